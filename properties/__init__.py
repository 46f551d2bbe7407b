"""The evidence: strategies, symbolic engine, proofs, witnesses, mutants, and the command line."""
