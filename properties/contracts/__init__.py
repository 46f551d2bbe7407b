"""Contracts: what a request requires and ensures, proved of the rules' own code."""
