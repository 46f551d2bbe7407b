"""Properties that compare runs: two requests and one, a level and its mirror image, the rules and the closed form.

Each takes a trial and its row, in exact numbers or in floats, and says whether the property holds.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

from properties.closed_form import displacements
from properties.strategies.rows import Trial
from reference.formats import in_floats
from reference.row import Row, row_of
from reference.simulator import move
from spec.body import Level
from spec.graph import Direction, Vertex
from spec.invariants import ADDITIVE, CLOSED_FORM, DETERMINISM, EDGE_SPLIT, MIRROR, TRANSLATION, equal
from spec.profiles import Profile
from spec.transform import mirror, moved, split


@dataclass(frozen=True)
class Check:
    """A property of a trial, run in a row of exact numbers or of floats."""

    id: str
    holds: Callable[[Profile, Trial, Row[Any], Any], Any]


def placed(row: Row[Any]) -> list[tuple[str, Any, Any]]:
    """Where all bodies are, by name and by coordinates along the string."""
    return sorted((body.name, row.coordinate(body.left), row.coordinate(body.right)) for body in row.bodies)


def alike(one: Row[Any], two: Row[Any], tolerance: Any) -> bool:
    """Whether two rows hold the same bodies at the same places of their strings."""
    pairs = zip(placed(one), placed(two), strict=True)
    return all(
        a[0] == b[0] and all(near(one, x, y, tolerance) for x, y in zip(a[1:], b[1:], strict=True)) for a, b in pairs
    )


def near(row: Row[Any], x: Any, y: Any, tolerance: Any) -> bool:
    """Whether two coordinates are the same place."""
    return any(equal(x, y + shift, tolerance) for shift in ([0, row.length, -row.length] if row.closed else [0]))


def after(profile: Profile, row: Row[Any], trial: Trial, *distances: Any) -> Row[Any]:
    """The row after requests one after another, of the trial's body in its direction."""
    result = row.copy()
    for distance in distances:
        move(profile, result, trial.body, trial.direction, distance)
    return result


def exact_chain(profile: Profile, trial: Trial, row: Row[Any], tolerance: Any) -> bool:
    """The rules move every body as far as the closed form says."""
    asked = trial.asked + row.margin * 0
    result = after(profile, row, trial, asked)
    expected = displacements(row, trial.body, trial.direction, asked, profile.push_limit(len(row.bodies)))
    return all(
        equal(result.travel(row, body, trial.direction), expected.get(body, asked * 0), tolerance)
        for body in row.bodies_in_order()
    )


def additive(profile: Profile, trial: Trial, row: Row[Any], tolerance: Any) -> bool:
    """Two requests do what one of their sum does; on a ring, if their sum fits into the free space."""
    asked = trial.asked + row.margin * 0
    room = row.free - len(row.bodies) * row.margin
    asked = min(asked, room) if row.closed and len(row.bodies) > 1 else asked
    part = asked / 3
    return alike(after(profile, row, trial, part, asked - part), after(profile, row, trial, asked), tolerance)


def deterministic(profile: Profile, trial: Trial, row: Row[Any], tolerance: Any) -> bool:
    """The same request twice gives the very same state and record."""
    one, two = row.copy(), row.copy()
    asked = trial.asked + row.margin * 0
    runs = [move(profile, held, trial.body, trial.direction, asked) for held in (one, two)]
    return one.bodies == two.bodies and runs[0][0] == runs[1][0] and runs[0][1].fired == runs[1][1].fired


def in_kind(level: Level[Fraction], row: Row[Any]) -> Row[Any]:
    """The row of another level, in the same kind of numbers as a row."""
    return row_of(level) if isinstance(row.margin, Fraction) else row_of_floats(level)


def row_of_floats(level: Level[Fraction]) -> Row[float]:
    """The row of a level in floats; that it is valid is checked in exact numbers."""
    exact, floats = row_of(level), in_floats(level)
    order = {body.name: place for place, body in enumerate(exact.bodies)}
    bodies = sorted(floats.bodies, key=lambda body: order[body.name])
    return Row(floats.graph, floats.margin, bodies, closed=exact.closed)


def same_named(row: Row[Any], name: str) -> int:
    """The place in a row of the body with a name."""
    return next(place for place, body in enumerate(row.bodies) if body.name == name)


def changed(
    profile: Profile, trial: Trial, row: Row[Any], level: Level[Fraction], direction: Direction
) -> tuple[Row[Any], Row[Any]]:
    """The row of a changed level before and after the trial's request, made in `direction`."""
    other = in_kind(level, row)
    body = same_named(other, row.bodies[trial.body].name)
    return other, after(profile, other, replace(trial, body=body, direction=direction), trial.asked + row.margin * 0)


def mirrored(profile: Profile, trial: Trial, row: Row[Any], tolerance: Any) -> bool:
    """The mirrored request does the mirror image."""
    one = after(profile, row, trial, trial.asked + row.margin * 0)
    start, two = changed(profile, trial, row, mirror(trial.level), trial.direction.opposite)
    return all(
        equal(
            one.travel(row, body, trial.direction),
            two.travel(start, same_named(two, held.name), trial.direction.opposite),
            tolerance,
        )
        for body, held in enumerate(row.bodies)
    )


def unchanged_by(change: Callable[[Level[Fraction]], Level[Fraction] | None]) -> Callable[..., bool]:
    """Whether a change of the level changes no displacement."""

    def holds(profile: Profile, trial: Trial, row: Row[Any], tolerance: Any) -> bool:
        level = change(trial.level)
        if level is None:
            return True
        one = after(profile, row, trial, trial.asked + row.margin * 0)
        start, two = changed(profile, trial, row, level, trial.direction)
        return all(
            equal(
                one.travel(row, body, trial.direction),
                two.travel(start, same_named(two, held.name), trial.direction),
                tolerance,
            )
            for body, held in enumerate(row.bodies)
        )

    return holds


def split_longest(level: Level[Fraction]) -> Level[Fraction] | None:
    """The level with its longest edge split in the middle, if both halves are as long as the margin."""
    lengths = [edge.length for edge in level.graph.edges]
    edge = lengths.index(max(lengths))
    at, left = lengths[edge] / 2, level.graph.vertices[level.graph.edges[edge].left]
    return split(level, edge, at, Vertex(left.x + at, left.y)) if at >= level.margin else None


def moved_away(level: Level[Fraction]) -> Level[Fraction]:
    """The level moved by a vector."""
    return moved(level, Vertex(Fraction(-7), Fraction(5, 3)))


RELATIONS = (
    Check(CLOSED_FORM.id, exact_chain),
    Check(ADDITIVE.id, additive),
    Check(DETERMINISM.id, deterministic),
    Check(MIRROR.id, mirrored),
    Check(EDGE_SPLIT.id, unchanged_by(split_longest)),
    Check(TRANSLATION.id, unchanged_by(moved_away)),
)
