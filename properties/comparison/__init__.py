"""The profiles `thesis` and `repaired`, step by step from the same states."""
