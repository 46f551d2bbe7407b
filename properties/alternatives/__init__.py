"""Readings side by side: small scenes, what each reading makes of them, and which invariants it keeps."""
