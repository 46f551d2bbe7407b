"""Random levels and requests, with a liking for boundaries."""
