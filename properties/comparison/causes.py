"""The causes of differences: for each the bodies on which it is at work, from what fired and from the two ends.

A cause counts for a step if one of these bodies ends in different places.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from fractions import Fraction

from properties.comparison.both import Both, Turn, in_terrain
from reference.world import World
from spec.conditions import EDGES_LONG
from spec.differences import (
    AT_THE_LEDGE,
    CARRIED,
    CORNER,
    FAR_END_TAKEN,
    HELD_BY_TOP,
    INTO_TERRAIN,
    LANDING,
    NARROW_PIT,
    OTHER_STRING,
    OUT_OF_SIGHT,
    RIDER_SPEED,
    ROUND_A_RING,
    STOPPED_BEFORE,
    SUPPORT_FALLS,
    TURNS,
    Difference,
)
from spec.graph import Direction
from spec.plane import carriers
from spec.rules.step import touching
from spec.storeys import Contact

Bodies = frozenset[int]


def landed(both: Both) -> Bodies:
    """Those that left their support under both."""
    return both.left & both.changed


def lost(both: Both) -> Bodies:
    """Those that lost their support in the repaired step alone, by their own motion."""
    own = both.changed - both.left - both.fired("leave/blocked", "leave/nowhere") - slid(both)
    return frozenset(body for body in own if not support_gone(both, body))


def lost_at_an_end(both: Both) -> Bodies:
    """Those that did so before anything moved, or as the step ended."""
    moments = [moment for moment in both.moments if not moment.left or not any(moment.velocities.values())]
    return lost(both) & frozenset(change.seat.body for moment in moments for change in moment.changes)


def stopped(both: Both) -> Bodies:
    """Those that the thesis let fall or jump, and that something on their storey stops."""
    shut = both.repaired("way/wall", "way/slower", "row/squeezed", "row/ring")
    return (both.left - both.changed) & shut


def held_by_ground(both: Both) -> Bodies:
    """Those that the thesis let fall or jump, and that their ground still holds."""
    kept = both.left - both.changed - stopped(both)
    return frozenset(body for body in kept if both.settled.support(body) is None)


def held_by_top(both: Both) -> Bodies:
    """Those that the thesis let fall or jump, and that the top on which they stood still holds."""
    kept = both.left - both.changed - stopped(both)
    return frozenset(body for body in kept if both.settled.support(body) is not None)


def at_a_corner(both: Both) -> Bodies:
    """Those that a corner blocked."""
    return both.fired("leave/nowhere")


def at_a_blocked_ledge(both: Both) -> Bodies:
    """Those that a ledge blocked."""
    return both.fired("leave/blocked")


def support_gone(both: Both, body: int) -> bool:
    """Whether a body stood, maybe through others, on one that fell or jumped."""
    return bool(set(carriers(both.before, body)[1:]) & (both.left | both.changed))


def on_what_fell(both: Both) -> Bodies:
    """Those that stood on what fell or jumped."""
    return frozenset(body for body in both.handles if support_gone(both, body))


def slid(both: Both) -> Bodies:
    """Riders that are not driven, and that did not keep up with their support."""
    return frozenset(body for body in both.handles if not both.driven(body) and slides(both, body))


def slides(both: Both, body: int) -> bool:
    """Whether a body at some time had not the velocity of the support that it had at the start."""
    support = both.before.support(body)
    moving = [moment.velocities for moment in both.moments if moment.moved]
    return support is not None and any(speeds[body] != speeds[support] for speeds in moving)


def met_strangers(both: Both) -> Bodies:
    """Those in contact with a body that, before or after, is not next to them on their string; carried ones aside."""
    worlds = (both.before, both.after)
    strange = [one for one in contacts(both) if any(not next_to(world, one) for world in worlds)]
    return frozenset(body for one in strange for body in (one.left, one.right)) - slid(both)


def contacts(both: Both) -> Iterator[Contact]:
    """The contacts of the repaired step, those at its start too."""
    marks = [*touching(both.start), *(event.mark for moment in both.moments for event in moment.events)]
    return (mark for mark in marks if isinstance(mark, Contact))


def next_to(world: World[Fraction], contact: Contact) -> bool:
    """Whether two bodies are next to each other on one string."""
    return world.beside(contact.left, Direction.RIGHT) == contact.right


def gone_into_terrain(both: Both) -> Bodies:
    """Those that the thesis left in terrain, where repaired a wall stopped them; carried ones aside."""
    entered = frozenset(body for body in both.handles if in_terrain(both.ended, body))
    return (entered & both.repaired("way/wall")) - slid(both)


def unseen(both: Both) -> Bodies:
    """Neighbours on one string that the thesis left nearer than the margin, where edges are shorter than that."""
    if EDGES_LONG.holds(both.after, Fraction(0)):
        return frozenset()
    world = both.after
    near = [pair for pair in world.neighbours() if world.clear(*pair) < world.margin]
    return frozenset(body for pair in near for body in pair)


def round_a_ring(both: Both) -> Bodies:
    """Those on a ring round which a request came, to its mover."""
    return frozenset(body for turn in both.turns for body in came_round(both, turn))


def came_round(both: Both, turn: Turn) -> Iterable[int]:
    """The bodies on the ring of a mover, if its request came round to it."""
    mover = both.handle(turn.body)
    row = both.before.row(mover)
    last = both.those(turn, "push/limit", "push/forbidden")
    again = turn.depth > len(row.order)
    closes = any(both.before.beside(body, both.direction) == mover for body in last)
    return row.order if row.closed and (again or closes) else ()


def on_what_moves(both: Both) -> Bodies:
    """Characters that walked on a body that moved."""
    walkers = [body for body in both.handles if both.asked.body is None and both.driven(body)]
    return frozenset(
        body for body in walkers if (support := both.before.support(body)) is not None and both.moved(support)
    )


def in_two_turns(both: Both) -> Bodies:
    """Those that took part in a turn together with a body that took part in another one too."""
    turns = [taking_part(both, turn) for turn in both.turns]
    often = {body for i, some in enumerate(turns) for others in turns[i + 1 :] for body in some & others}
    return frozenset(body for some in turns if some & often for body in some)


def taking_part(both: Both, turn: Turn) -> Bodies:
    """The bodies that moved in a turn, or stopped one that may not push."""
    stops = [both.before.beside(body, both.direction) for body in both.those(turn, "push/forbidden")]
    return both.those(turn).union(body for body in stops if body is not None)


Cause = Callable[[Both], Bodies]

CAUSES: dict[Difference, Cause] = {
    LANDING: landed,
    AT_THE_LEDGE: lost_at_an_end,
    NARROW_PIT: held_by_ground,
    HELD_BY_TOP: held_by_top,
    STOPPED_BEFORE: stopped,
    CORNER: at_a_corner,
    FAR_END_TAKEN: at_a_blocked_ledge,
    SUPPORT_FALLS: on_what_fell,
    CARRIED: slid,
    OTHER_STRING: met_strangers,
    INTO_TERRAIN: gone_into_terrain,
    OUT_OF_SIGHT: unseen,
    ROUND_A_RING: round_a_ring,
    RIDER_SPEED: on_what_moves,
    TURNS: in_two_turns,
}


def causes_of(both: Both) -> list[Difference]:
    """The causes for which a step differs; none if it does not."""
    return [difference for difference, cause in CAUSES.items() if both.differing and cause(both) & both.differing]
