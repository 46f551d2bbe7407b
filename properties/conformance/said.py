"""What a line says beside where the bodies are: distances moved, rules, events, supports, buttons, the goal."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from fractions import Fraction

import msgspec

from properties.conformance.judge import Difference, Expected
from properties.conformance.log import Grid, Request, Step
from reference.formats.numbers import exact, readable
from reference.formats.trace import LineRecord, MoveRecord
from reference.recording import events_of, supports_of
from reference.simulator import Fulfilled
from reference.world import World
from spec.body import Body, EdgePosition
from spec.profiles import Profile

OF_VELOCITY = "velocity/"


def of_the_state(line: LineRecord, seen: World[Fraction], tolerance: Fraction) -> Iterator[Difference]:
    """What a line says of the state after it, and is not so in the state that it says it is."""
    supports = supports_of(seen.level.bodies, seen.level)
    if line.supports is not None and line.supports != supports:
        yield Difference("", "supports", as_json(supports), as_json(line.supports))
    buttons = seen.level.buttons
    pressed = [seen.pressed(button) for button in buttons]
    open_to_both = [at_a_border(seen, button, tolerance) for button in buttons]
    told = pressed if line.pressed is None else line.pressed
    if len(told) != len(pressed):
        yield Difference("", "pressed", as_json(pressed), as_json(told))
        return
    right = [two if either else one for one, two, either in zip(pressed, told, open_to_both, strict=True)]
    if told != right:
        yield Difference("", "pressed", as_json(right), as_json(told))
    known = line.pressed is not None or not any(open_to_both)
    if line.solved is not None and line.solved != all(right) and known:
        yield Difference("", "solved", as_json(all(right)), as_json(line.solved))


def as_json(value: object) -> str:
    """A value as it stands in a file."""
    return msgspec.json.encode(value).decode()


def of_the_grid(step: Step, grid: Grid | None) -> Iterator[Difference]:
    """The numbers of a line that are not on the grid that its header promises."""
    if grid is None:
        return
    for body, _, distance in step.asked:
        if distance not in grid:
            yield Difference(step.after.bodies[body].name, "asked", str(grid), readable(distance))
    for held in step.after.bodies:
        for side, at in (("left", held.left), ("right", held.right)):
            if at.location not in grid:
                yield Difference(held.name, f"{side}.location", str(grid), readable(at.location))


def at_a_border(seen: World[Fraction], button: EdgePosition[Fraction], tolerance: Fraction) -> bool:
    """Whether a button is so near to a border that it may or may not be pressed."""
    row, along = seen.row_of_edge[button.edge], seen.coordinate(button)
    bodies = [seen.bodies[body] for body in row.order]
    borders = [seen.coordinate(border) for body in bodies for border in (body.left, body.right)]
    return tolerance > 0 and any(abs(along - border) <= tolerance for border in borders)


def of_the_velocities(
    seen: World[Fraction], expected: Iterable[Body[Fraction]], tolerance: Fraction
) -> Iterator[Difference]:
    """The velocities that a line says bodies have, and they have others; the tolerance is that of distances."""
    nearly = tolerance / seen.level.tick
    for held, right in zip(seen.bodies, expected, strict=True):
        if held.motion is not None and right.motion is not None:
            apart = abs(held.motion.velocity - right.motion.velocity)
            if apart > nearly:
                texts = readable(right.motion.velocity), readable(held.motion.velocity)
                yield Difference(held.name, "velocity", *texts, apart)


def of_the_rolls(line: LineRecord, turns: list[Fulfilled[Fraction]]) -> Iterator[Difference]:
    """The rules of velocity that a line says fired, and others did."""
    for move, turn in zip(line.moves or (), turns, strict=False):
        right = [rule for _, rule in turn.fired if rule.startswith(OF_VELOCITY)]
        told = [rule for _, rule in move.fired or () if rule.startswith(OF_VELOCITY)]
        if move.fired is not None and told != right:
            yield Difference(move.body, "fired", " ".join(right) or "none", " ".join(told) or "none")


def of_the_moves(
    line: LineRecord, asked: tuple[Request, ...], expected: Expected, tolerance: Fraction, rules_known: bool
) -> Iterator[Difference]:
    """What a line says of its requests, and is not so; of the rules that fired too, if these are known."""
    names = [expected.world.bodies[body].name for body, _, _ in asked]
    told = names if line.moves is None else [move.body for move in line.moves]
    if told != names:
        yield Difference("", "moves", f"those of {', '.join(names)}", f"those of {', '.join(told)}")
    else:
        for i, move in enumerate(line.moves or []):
            yield from of_a_move(i, move, asked[i], expected, tolerance)
            if rules_known:
                yield from of_the_rules(i, move, expected)


def of_a_move(
    index: int, move: MoveRecord, asked: Request, expected: Expected, tolerance: Fraction
) -> Iterator[Difference]:
    """What a line says of one of its requests, and is not so."""
    _, direction, distance = asked
    place = f"$.moves[{index}]"
    for field, value, right in (
        ("asked", move.asked, distance * direction),
        ("moved", move.moved, expected.moved[index]),
    ):
        if abs(exact(value, f"{place}.{field}") - right) > tolerance:
            yield Difference(move.body, field, readable(right), str(value))


def of_the_rules(index: int, move: MoveRecord, expected: Expected) -> Iterator[Difference]:
    """The first rule that a line says fired in one of its requests, and did not, or did not yet."""
    fired = fired_in(expected, index)
    seen = [pair for pair in move.fired or () if not pair[1].startswith(OF_VELOCITY)]
    if move.fired is not None and seen != fired:
        first = next((i for i, pair in enumerate(fired) if seen[i : i + 1] != [pair]), len(fired))
        right_pair, told = (" ".join(pairs[first]) if first < len(pairs) else "none" for pairs in (fired, seen))
        yield Difference(move.body, f"fired[{first}]", right_pair, told)


def fired_in(expected: Expected, index: int) -> list[tuple[str, str]]:
    """The rules that fired in a request, each with its body."""
    bodies = expected.world.bodies
    return [(bodies[body].name, rule) for body, rule in expected.records[index].fired]


def of_the_events(line: LineRecord, profile: Profile, expected: Expected) -> Iterator[Difference]:
    """What a line says of its events, and is not so."""
    if line.events is None:
        return
    events = events_of(profile)
    fired = [pair for index in range(len(expected.records)) for pair in fired_in(expected, index)]
    right = [f"{body} {events[rule]} by {rule}" for body, rule in fired if rule in events]
    told = [f"{event.body} {event.event} by {event.rule}" for event in line.events]
    if told != right:
        yield Difference("", "events", "; ".join(right) or "none", "; ".join(told) or "none")
