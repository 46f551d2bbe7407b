"""Claims: under a profile and premises, a property; with the verdict that is expected. Data, no machinery."""
