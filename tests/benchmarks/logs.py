"""The log of the bench of validation: a character pushes four boxes on a line, right and left, in floats."""

from __future__ import annotations

import json
from pathlib import Path

import msgspec

from reference.play import play
from reference.recording import header_of, lines_of

ASIDE = dict.fromkeys(("step", "moves", "events", "supports", "pressed", "solved"))
"""What a foreign program may leave out of a line."""
LEFTS = (0.3, 2.1, 3.8, 5.5, 7.2)
TICKS = 125


def boxes_and_ticks(directory: Path, times: int) -> Path:
    """Where the scenario is written: so many times, ticks with one key and then with the other."""
    bodies = [
        {"name": f"Body {i}", "left": {"edge": 0, "location": at}, "right": {"edge": 0, "location": at + 1}}
        for i, at in enumerate(LEFTS)
    ]
    level = {"format": "graphbody/level@1", "name": "boxes", "margin": "1/10", "tick": "1/60", "bodies": bodies}
    bodies[0]["speed"] = 2
    steps = [{"tick": {"key": key, "times": TICKS}} for key in ("right", "left") * times]
    scenario = {"format": "graphbody/scenario@1", "name": "boxes", "profile": "repaired", "steps": steps}
    path = directory / "boxes.json"
    path.write_text(json.dumps({**scenario, "level": {**level, "vertices": [[0, 0], [40, 0]]}}))
    return path


def traces_of(scenario: Path) -> tuple[list[bytes], list[bytes]]:
    """The trace of a scenario in floats, line by line: all of it, and without what may be left out."""
    playing = play(scenario, floats=True)
    header, *lines = header_of(playing, floats=True), *lines_of(playing)
    bare = [msgspec.structs.replace(line, **ASIDE) for line in lines]
    all_said, left_out = ([msgspec.json.encode(record) for record in (header, *some)] for some in (lines, bare))
    return all_said, left_out


def log_of(directory: Path, times: int, bare: bool) -> tuple[Path, int]:
    """Where the trace of boxes and ticks is written, and how many lines it has."""
    lines = traces_of(boxes_and_ticks(directory, times))[bare]
    path = directory / "trace.jsonl"
    path.write_bytes(b"\n".join(lines) + b"\n")
    return path, len(lines)
