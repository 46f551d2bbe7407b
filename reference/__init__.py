"""A minimal simulator that computes what `spec` says, its file formats and its library of levels."""
