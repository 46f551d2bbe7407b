"""Conformance: logs of other implementations, held against the rules."""
