"""What must hold: rules, invariants, conditions and readings of graph-based movement."""
