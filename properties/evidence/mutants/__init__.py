"""Mutants: the project's own source, changed in one place at a time by fixed operators. Each must be caught by name."""
