"""A tick is its requests, one after another: the simulator's own code, with segments stood in for by their contract."""

from __future__ import annotations

from collections.abc import Generator
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

from properties.contracts.contract import REQUEST, SEGMENT, Call, Stretch, promise, stand_in_for
from properties.contracts.request import stand_in
from properties.given import Given
from properties.worlds.rows import string_graph
from reference.simulator import Game
from reference.world import Facing
from spec.body import Body, EdgePosition, Level
from spec.graph import Direction
from spec.profiles import Profile
from spec.rules.leave import Departure, Placement
from spec.rules.request import Ask, Rules
from spec.rules.walk import Motion, Tow

ONE = Fraction(1)
PLACES = {"A": (0, 1), "B": (2, 3), "C": (4, 5)}
"""Where the borders of each body are."""
NAMES = tuple(PLACES)
Segment = Generator[Ask[Any, int], Any, Motion[Any, Any]]


@dataclass(frozen=True)
class Asked:
    """A request as its first segment meets it: who was asked, in which direction, for how much; and how far it goes."""

    body: str
    direction: Direction
    distance: Any
    spare: Any
    at_rest: bool
    in_game: bool
    went: Any


def any_cast(given: Given) -> tuple[Level[Any], dict[str, Any]]:
    """Three bodies on one edge, each a character of any speed or a box; and the speeds of the characters."""
    speeds = {name: speed for name in NAMES if (speed := given.number(f"speed of {name}")) > 0}
    bodies = [
        Body(name, EdgePosition(0, Fraction(left)), EdgePosition(0, Fraction(right)), speeds.get(name, ONE * 0), ONE)
        for name, (left, right) in PLACES.items()
    ]
    return Level(string_graph([Fraction(9)], None), ONE / 4, ONE / 2, tuple(bodies)), speeds


def any_key(given: Given) -> Direction | None:
    """One of two keys, or none."""
    if given.flag("a key is held"):
        return Direction.LEFT if given.flag("the key is the left one") else Direction.RIGHT
    return None


def tick_is_its_requests(profile: Profile, given: Given) -> None:
    """A tick asks each character once, in the order of the reading, to move its speed times the tick in its direction.

    Each request begins when the one before has ended, by the rules of the profile, and may ask all other bodies. The
    loop over the bodies is judged for three; it does the same for each. Without a key nobody is asked.
    """
    (level, speeds), seen = any_cast(given), list[Asked]()
    key = any_key(given)

    def segments(own: Rules, view: Facing[Any], body: int, motion: Motion[Any, Any], spare: Any) -> Segment:
        assert len(seen) < len(NAMES), "a request is over when its segment has ended"
        promise(given, REQUEST, Call(asked=motion.rest, moved=motion.rest), REQUEST.requires)
        yield from ()
        went = given.number(f"moved by request {1 + len(seen)}")
        at_rest, in_game = motion.at is view.front(body), view.world is game.world
        name = level.bodies[body].name
        seen.append(Asked(name, view.direction, motion.rest, spare, at_rest, in_game, went))
        stand_in_for(given, SEGMENT, Stretch(asked=motion.rest, moved=went))
        return Motion(motion.at, motion.rest - went, going=False)

    rules = replace(
        profile.rules,
        segment=segments,
        follow=stand_in("follow", rear_of),
        leave=stand_in("leave", where_it_is),
    )
    game = Game(replace(profile, rules=rules), level)
    done = game.tick(key)
    order = [] if key is None else [name for name in profile.tick_order(NAMES) if name in speeds]
    given.ensure("each character is asked once, in its turn", [one.body for one in seen] == order)
    given.ensure("in the direction of the key", [one.direction for one in seen] == [key for _ in order])
    given.ensure("the tick says what its requests did", [one.body for one in done] == order)
    for one, told in zip(seen, done, strict=False):
        given.ensure("by its speed times the tick", one.distance == speeds.get(one.body, 0) * level.tick)
        given.ensure("it may ask all others", one.spare == profile.push_limit(len(NAMES)) - 1)
        given.ensure("from where it stands", one.at_rest)
        given.ensure("in the game", one.in_game)
        given.ensure("the tick says how far each went", told.moved == one.went * one.direction)


def rear_of(tow: Tow[Any, Any]) -> Any:
    """The rear border, where it is."""
    return tow.rear


def where_it_is(leaving: Departure[Any, Any]) -> Placement[Any, Any]:
    """A body that stays."""
    return Placement(leaving.front, leaving.rear, leaving.moved)
