"""Where evidence is written."""

from __future__ import annotations

from pathlib import Path

BUILD = Path("build")
WITNESSES, JOBS, FOUND, MUTANTS = BUILD / "witnesses", BUILD / "jobs", BUILD / "map", BUILD / "mutants"
RESULTS, RESULTS_LONG = BUILD / "results.json", BUILD / "results-long.json"

LISTED = "obligations.json"
"""In the directory of an export: its files, and what is to be answered of each."""


def file_name(claim_id: str) -> str:
    """The name of a claim's witness, without its ending."""
    return claim_id.removeprefix("claim/").replace("/", "-")
