"""A part of the map: what is to be found out, what is said of it, and how it is looked at again."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

Finding = Any
"""What a job has found out, as plain JSON data; the same in every run, so without times."""

Findings = Mapping[str, Finding]
"""What the jobs of a part have found out, by their names."""


@dataclass(frozen=True)
class Part:
    """A section of the map.

    Attributes:
        name: the name of its file of findings.
        title: its heading.
        jobs: what is to be run, by name; jobs run in processes of their own, so they can be pickled.
        section: what the page says of the findings, as lines of Markdown.
        witnesses: the scenarios that the section links to as `map/witnesses/NAME.json`, drawn as
            `map/pictures/NAME.svg`; each as the JSON of a scenario file.
        broken: what of the findings does not hold when it is looked at again, quickly: one line for each.
    """

    name: str
    title: str
    jobs: Callable[[], Mapping[str, Callable[[], Finding]]]
    section: Callable[[Findings], list[str]]
    witnesses: Callable[[Findings], Mapping[str, Any]]
    broken: Callable[[Findings], Iterator[str]]
