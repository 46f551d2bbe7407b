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
NAMES = ("A", "B", "C")
Segment = Generator[Ask[Any, int], Any, Motion[Any, Any]]


@dataclass(frozen=True)
class Asked:
    """A request as its first segment meets it: who was asked, in which direction, for how much."""

    body: str
    direction: Direction
    distance: Any
    spare: Any
    at_rest: bool


def any_cast(given: Given) -> Level[Any]:
    """Three bodies on one edge, each a character of any speed or a box; the tick is the unit of time."""
    bodies = []
    for place, name in enumerate(NAMES):
        speed = given.number(f"speed of {name}") if given.flag(f"{name} is a character") else Fraction(0)
        if not isinstance(speed, Fraction) or speed:
            given.assume(speed > 0, "a character has a speed")
        left = Fraction(2 * place)
        bodies.append(Body(name, EdgePosition(0, left), EdgePosition(0, left + 1), speed, ONE))
    return Level(string_graph([Fraction(9)], None), ONE / 4, ONE, tuple(bodies))


def tick_is_its_requests(profile: Profile, given: Given) -> None:
    """A tick asks each character once, in the order of the reading, to move its speed times the tick in its direction.

    Each request begins when the one before has ended, by the rules of the profile, and may ask all other bodies. The
    loop over the bodies is judged for three; it does the same for each.
    """
    level, seen = any_cast(given), list[Asked]()
    key = Direction.LEFT if given.flag("the key is the left one") else Direction.RIGHT

    def segments(own: Rules, view: Facing[Any], body: int, motion: Motion[Any, Any], spare: Any) -> Segment:
        at_rest = motion.at is view.front(body) and view.world is game.world
        seen.append(Asked(level.bodies[body].name, view.direction, motion.rest, spare, at_rest))
        yield from ()
        went = given.number(f"moved by request {len(seen)}")
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
    characters = [body for body in level.bodies if not isinstance(body.speed, Fraction) or body.speed]
    order = [name for name in profile.tick_order(NAMES) if name in {body.name for body in characters}]
    given.ensure("each character is asked once, in its turn", [one.body for one in seen] == order)
    given.ensure("the tick says what its requests did", [one.body for one in done] == order)
    speeds = {body.name: body.speed for body in characters}
    for one in seen:
        promise(given, REQUEST, Call(asked=one.distance, moved=one.distance), REQUEST.requires)
        given.ensure("in the direction of the key", one.direction is key)
        given.ensure("by its speed times the tick", one.distance == speeds[one.body])
        given.ensure("it may ask all others", one.spare == profile.push_limit(len(NAMES)) - 1)
        given.ensure("from where it stands in the game", one.at_rest)


def rear_of(tow: Tow[Any, Any]) -> Any:
    """The rear border, where it is."""
    return tow.rear


def where_it_is(leaving: Departure[Any, Any]) -> Placement[Any, Any]:
    """A body that stays."""
    return Placement(leaving.front, leaving.rear, leaving.moved)
