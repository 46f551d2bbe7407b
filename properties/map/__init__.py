"""The map: which guidelines suffice, which cases fail and which readings differ, part by part."""
