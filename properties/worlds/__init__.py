"""Symbolic worlds: a window on any row, and whole rows of a fixed number of bodies."""
