"""How a claim is settled: proofs, whole rows, samples, witnesses, mutants."""
