"""`python -m independent LEVELS`: compare the second program with the reference on so many random levels."""

import sys
from collections import Counter
from dataclasses import dataclass, field
from itertools import pairwise
from multiprocessing import Pool
from pathlib import Path
from random import Random
from tempfile import TemporaryDirectory
from typing import Any

from independent.comparing import Line, by_reference, difference
from independent.levels import scenario
from reference.formats.files import FormatError

PROCESSES = 2
OFTEN = 1000
"""After how many levels the progress is told."""

MOST_REFUSED = 0.05
FLOORS = {
    "falls": 0.6,
    "jumps": 0.5,
    "rides": 0.2,
    "pushes": 0.5,
    "squeezes": 0.1,
    "contacts": 0.5,
    "walls": 0.6,
    "stops behind a slower body": 0.35,
    "passes nothing on": 0.4,
    "rings": 0.3,
    "closed rows": 0.005,
}
RULES = {
    "settle/fall": "falls",
    "settle/jump": "jumps",
    "row/pushed": "pushes",
    "row/squeezed": "squeezes",
    "event/contact": "contacts",
    "event/wall": "walls",
    "way/slower": "stops behind a slower body",
    "row/passes-nothing": "passes nothing on",
    "row/ring": "closed rows",
}


@dataclass(frozen=True)
class Compared:
    """What came of one level: why the reference refused it, what differs, and what was seen in it."""

    seed: int
    refused: str | None = None
    difference: str | None = None
    seen: set[str] = field(default_factory=set)


def compared(seed: int) -> Compared:
    """Compare the two on the level of a seed."""
    given = scenario(Random(seed), f"level {seed}")
    with TemporaryDirectory() as folder:
        try:
            lines = by_reference(given, Path(folder) / "level.json")
        except FormatError as error:
            return Compared(seed, refused=str(error))
    return Compared(seed, difference=difference(lines, given), seen=seen_in(given, lines))


def seen_in(given: dict[str, Any], lines: list[Line]) -> set[str]:
    """Return what the lines of a scenario show, by the names of `FLOORS`."""
    fired = {rule for line in lines for move in line["moves"] for _, rule in move["fired"]}
    seen = {name for rule, name in RULES.items() if rule in fired}
    if "circumference" in given["level"]:
        seen.add("rings")
    if any(rides(before, after) for before, after in pairwise(lines)):
        seen.add("rides")
    return seen


def rides(before: Line, after: Line) -> bool:
    """Whether a body is where it was on the top of another, and that one on the ground is not where it was."""
    earlier = {body["name"]: body for body in before["bodies"]}
    later = {body["name"]: body for body in after["bodies"]}
    return any(
        later[name] == earlier[name] and later[top] != earlier[top] and top not in after["supports"]
        for name, top in after["supports"].items()
    )


def main(levels: int) -> int:
    """Compare on so many levels; return 1 if any differs, or if they show too little."""
    counts: Counter[str] = Counter()
    with Pool(PROCESSES) as pool:
        for done, one in enumerate(pool.imap(compared, range(levels), chunksize=20), 1):
            counts.update(one.seen)
            counts["refused"] += one.refused is not None
            counts["differ"] += one.difference is not None
            if one.difference is not None:
                print(f"level {one.seed}: {one.difference}", flush=True)
            if done % OFTEN == 0:
                print(f"{done} levels, {counts['refused']} refused, {counts['differ']} differ", flush=True)
    return judged(counts, levels)


def judged(counts: Counter[str], levels: int) -> int:
    """Print what was seen; return 1 if levels differ or are too tame."""
    played = levels - counts["refused"]
    shares = {name: counts[name] / played for name in FLOORS}
    for name, share in shares.items():
        print(f"{share:7.1%} {name}" + (f", expected at least {FLOORS[name]:.1%}" if share < FLOORS[name] else ""))
    print(f"{played} levels played, {counts['refused']} refused, {counts['differ']} differ")
    tame = any(share < FLOORS[name] for name, share in shares.items()) or counts["refused"] > MOST_REFUSED * levels
    return int(tame or counts["differ"] > 0)


if __name__ == "__main__":
    sys.exit(main(int(sys.argv[1])))
