"""Many levels of storeys, stepped at once: where a step has a closed form by cumulative operations on arrays, storey by
storey; from event to event where it has none.

**Rows.** A row is here what is on a storey between two walls, in contact or not. Let the place of a body be the room
that there is before it in its row, between all bodies and beyond their margins: bodies in contact are at one place.
There, the first of a row comes as far as it wishes, and each other one as far as it wishes or the one behind it comes:
a cumulative maximum. No body comes farther than the walls ahead of it and of all before it allow: a cumulative minimum
from the front.

**Why that is where events lead.** Let all that are driven be driven one way, at one speed, in the plane or on what does
not move. Then every velocity is 0 or that speed. A body has come as far as it wished, until it is pushed; it comes
farther than both only if it is pushed first, and is then carried on by its own support while what has pushed it stands.
In a row in which no support moves this cannot be: who moves of its own does so to the end, or to a wall that all stop
at who are in contact behind. Nor can it be where supports that move, once they do, move to the end. Nor where they are
all of one row and nobody on them is driven: of two of these, with anything that the one behind carries in contact with
what the other one carries, the one ahead moves only while the one behind does, once that has begun; for if the one
behind stops, it stands behind a wall, or what carries it does, and so does all in contact ahead of it. What they carry
moves so too, and the next storey has what this one has. Else, a wall between two supports may stop one before the other
begins, with a row above that reaches over the wall; so it does not fit, and events decide.

**Supports.** How far a body slides on its support grows while the body is not stopped, and lessens when it is. So the
greatest way that it slides is where it ends if nothing stops it, and less than its own way else. If that is less than
what would make it lose its support, it keeps that.

**Going on.** If all of a level keep their speeds for a time ahead, a step of any part of it is one sum. So it is found
out for how long nothing comes, and a level is looked at again only then.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from reference.rounding import ROUNDINGS, UNIT_ROUNDOFF
from reference.stepping import run
from reference.storeys import Place, StoreyWorld
from spec.graph import Direction
from spec.number import greater, lesser
from spec.rules.step import StepRules, step
from spec.storeys import Drive, Interval

Array = NDArray[Any]

MANY_ROWS = 100
"""As many rows are swept place by place; fewer are swept in one operation, which takes longer for each body."""

LONGER = 64
"""So many times as long as something has gone on it is tried whether it goes on."""


@dataclass(frozen=True)
class Standing:
    """How the bodies of a line stand, in the order of the level: what does not change while none changes its support.

    Attributes:
        kinds: of each body the storey, its row, counted over all storeys, its place in that, the body that it stands
            on (itself on the ground), and whether it stands on ground above the floor.
        edges: of each body the walls between which it is, and the ends of the ground that holds it.
    """

    kinds: Array
    edges: Array


def standing(world: StoreyWorld[Any], dtype: Any) -> Standing:
    """How the bodies of a line stand."""
    pairs, found, row, place = set(world.neighbours()), dict[int, tuple[int, int]](), -1, 0
    for storey in world.storeys():
        before = -1
        for body in world.row(storey):
            row, place = (row, place + 1) if (before, body) in pairs else (row + 1, 0)
            found[body], before = (row, place), body
    kinds = [
        (at.storey, *found[body], body if at.support is None else at.support, on_ground(at))
        for body, at in enumerate(world.places)
    ]
    return Standing(np.array(kinds), np.array([edges_of(world, at) for at in world.places], dtype))


def on_ground(place: Place[Any]) -> bool:
    """Whether a body stands on ground above the floor."""
    return place.support is None and place.storey > 0


def edges_of(world: StoreyWorld[Any], place: Place[Any]) -> tuple[Any, Any, Any, Any]:
    """The nearest walls on both sides of a body, and the ends of its ground; elsewhere the walls again."""
    ends = world.terrain.ends
    assert ends is not None
    left, right = ends.left, ends.right
    for solid in world.solid(place.storey):
        if solid.left > place.left:
            right = lesser(right, solid.left)
        if solid.left < place.left:
            left = greater(left, solid.right)
    ground = ground_of(world, place) if on_ground(place) else Interval(left, right)
    return left, right, ground.left, ground.right


def ground_of(world: StoreyWorld[Any], place: Place[Any]) -> Interval[Any]:
    """The ground that holds a body, with what follows it across gaps that the body does not fit into.

    It ends where the body is if none holds it.
    """
    found: list[Interval[Any]] = []
    for piece in sorted(world.terrain.ground(place.storey), key=lambda piece: piece.left):
        if found and piece.left < found[-1].right + place.width:
            found[-1] = Interval(found[-1].left, piece.right)
        else:
            found.append(piece)
    holding = (piece for piece in found if piece.left < place.right and piece.right > place.left)
    return next(holding, Interval(place.right, place.left))


@dataclass(frozen=True)
class Storey:
    """The bodies of one storey of all levels: first those that are first in their rows, then those that are second.

    Attributes:
        bodies: where they are in the arrays.
        runs: of these, those at places that as many rows have, one place after another, and how many rows that is.
        first: how many are first in their rows.
        behind: of all others the ones before them in their rows.
        riders: those that stand on others.
    """

    bodies: slice
    runs: tuple[tuple[slice, int], ...]
    first: int
    behind: Array
    riders: Array


@dataclass(frozen=True)
class Layout:
    """The bodies of many levels in an order in which each operation takes what is beside each other.

    Attributes:
        order: which bodies they are, of all; all else is in this order.
        kinds: of each body its storey, its row, its place in that, and whether it stands on ground above the floor.
        riders: those that stand on others.
        fallers: those that stand on ground above the floor.
    """

    order: Array
    level: Array
    kinds: Array
    width: Array
    margin: Array
    support: Array
    edges: Array
    storeys: tuple[Storey, ...]
    riders: Array
    fallers: Array

    @property
    def row(self) -> Array:
        """The row of each body."""
        found: Array = self.kinds[1]
        return found


def lay_out(
    found: Sequence[Standing], bodies: Array, first: Array, level: Array, width: Array, margin: Array
) -> Layout:
    """Put the bodies of some levels in order: storey by storey, then by places in rows, longer rows first.

    `bodies` are those whose standing is given, level by level, each with the `first` of its level; all else is of all.
    """
    storey, row, place, support, falls = np.concatenate([one.kinds for one in found]).T
    row, support = row + first, support + first
    length = np.bincount(row)
    sort = np.lexsort((row, -length[row], place, storey))
    order, whereabouts = bodies[sort], np.zeros(len(level), int)
    whereabouts[order] = np.arange(len(order))
    kinds, edges = np.array([storey, row, place, falls])[:, sort], np.concatenate([one.edges for one in found])[sort].T
    return laid_out(order, level[order], kinds, width[order], margin[order], whereabouts[support[sort]], edges.copy())


def laid_out(
    order: Array, level: Array, kinds: Array, width: Array, margin: Array, support: Array, edges: Array
) -> Layout:
    """A layout of bodies that are in order."""
    storey, _, place, falls = kinds
    rides = support != np.arange(len(order))
    storeys = tuple(storeys_of(storey, place, rides))
    riders, fallers = np.flatnonzero(rides), np.flatnonzero(falls)
    return Layout(order, level, kinds, width, margin, support, edges, storeys, riders, fallers)


def part_of(layout: Layout, levels: Array) -> Layout:
    """The layout of some of its levels."""
    if levels.all():
        return layout
    those, found = np.flatnonzero(levels[layout.level]), np.zeros(len(layout.order), int)
    found[those] = np.arange(len(those))
    return laid_out(
        layout.order[those],
        layout.level[those],
        layout.kinds[:, those],
        layout.width[those],
        layout.margin[those],
        found[layout.support[those]],
        layout.edges[:, those],
    )


def storeys_of(storey: Array, place: Array, rides: Array) -> Iterator[Storey]:
    """The storeys of bodies that are in order."""
    for one in np.unique(storey):
        start, end = np.searchsorted(storey, [one, one + 1])
        yield storey_of(start, place[start:end], start + np.flatnonzero(rides[start:end]))


def storey_of(start: int, place: Array, riders: Array) -> Storey:
    """A storey whose bodies begin at one of all, at their places in rows."""
    rows = np.bincount(place)
    starts = np.cumsum(rows) - rows
    new = [0, *(1 + np.flatnonzero(np.diff(rows))).tolist(), len(rows)]
    ends = [*starts.tolist(), len(place)]
    runs = tuple((slice(ends[one], ends[other]), int(rows[one])) for one, other in pairwise(new))
    behind = np.arange(rows[0], len(place)) - rows[place[rows[0] :] - 1]
    return Storey(slice(start, start + len(place)), runs, int(rows[0]), behind, riders)


@dataclass(frozen=True)
class Drives:
    """The drives of all bodies of a batch: their speeds, positive to the right, and whether they are relative."""

    speed: Array
    relative: Array


def drives_of(drives: Iterable[Mapping[int, Drive[Any]]]) -> Drives:
    """The drives of all bodies, from those of each level by its own handles."""
    found = [of_level[body] for of_level in drives for body in range(len(of_level))]
    dtype = np.float64 if isinstance(found[0].speed, float) else object
    return Drives(np.array([one.speed for one in found], dtype), np.array([one.relative for one in found]))


@dataclass(frozen=True)
class Ways:
    """How far bodies go by the closed form, positive to the right.

    Attributes:
        stopped: whether walls keep them from going as far as they wish or are pushed.
        unclear: whether they need not go so far, since what carries and pushes them comes and goes.
    """

    far: Array
    stopped: Array
    unclear: Array


def moves(far: Array) -> Array:
    """Who goes anywhere."""
    return (far > 0) | (far < 0)


def ways(layout: Layout, left: Array, own: Array, relative: Array) -> Ways:
    """How far bodies go that wish to go so far of their own, in the plane or relative to their supports."""
    row, driven = layout.row, moves(own)
    found = Ways(np.zeros_like(left), np.zeros(len(row), bool), np.zeros(len(row), bool))
    in_driven, brief = np.zeros((2, 1 + row.max(initial=-1)), bool)
    in_driven[row[driven]] = True
    wish = own.copy()
    for storey in layout.storeys:
        carried = storey.riders[relative[storey.riders] & moves(found.far[layout.support[storey.riders]])]
        support = layout.support[carried]
        wish[carried] += found.far[support]
        brief[row[carried[brief[row[support]]]]] = True
        several = differ(row[carried], row[support], len(brief))
        found.unclear[carried] = driven[carried] | (brief & (several | in_driven))[row[carried]]
        sweep(layout, storey, left, wish, found)
        brief[row[storey.bodies][found.stopped[storey.bodies]]] = True
    return found


def differ(groups: Array, values: Array, many: int) -> Array:
    """Of each of so many groups whether its values differ."""
    one, found = np.zeros(many, int), np.zeros(many, bool)
    one[groups] = values
    found[groups[one[groups] != values]] = True
    return found


def several_speeds(level: Array, speed: Array) -> Array:
    """Who is driven at another speed than another body of its level."""
    driven, one = moves(speed), np.zeros(1 + level.max(initial=-1), speed.dtype)
    one[level[driven]] = speed[driven]
    other: Array = speed != one[level]
    return driven & other


def sweep(layout: Layout, storey: Storey, left: Array, wish: Array, found: Ways) -> None:
    """Let the rows of a storey go as far as they wish, are pushed, and walls allow."""
    those = storey.bodies
    place = rooms(layout, storey, left)
    for direction in Direction:
        far = wish[those] * direction
        if not np.any(far > 0):
            continue
        walls = to_walls(layout, left, those, direction)
        far, stopped = along_rows(storey, direction, far, place * direction, walls)
        found.far[those] += far * direction
        found.stopped[those] |= stopped


def along_rows(storey: Storey, direction: Direction, wishes: Array, start: Array, walls: Array) -> tuple[Array, Array]:
    """How far the bodies of rows come in a direction, and who does not come as far as it wishes or is pushed.

    `start` is the room in all up to each body, in that direction: there, who is pushed comes where the one behind does.
    `walls` is how far the walls ahead are. The closed form of a row is this text, here and in its proof.
    """
    pushed, allowed = start + np.maximum(wishes, 0), start + walls
    accumulate(np.maximum, pushed, storey, direction)
    accumulate(np.minimum, allowed, storey, direction.opposite)
    return np.minimum(pushed, allowed) - start, pushed > allowed


def rooms(layout: Layout, storey: Storey, left: Array) -> Array:
    """The room that there is in all before each body of a storey in its row, from the left."""
    size, at = (layout.width + layout.margin)[storey.bodies], left[storey.bodies]
    found, behind, ahead = np.zeros_like(at), storey.behind, slice(storey.first, None)
    found[ahead] = np.maximum(at[ahead] - (at[behind] + size[behind]), 0)
    accumulate(np.add, found, storey, Direction.RIGHT)
    return found


def to_walls(layout: Layout, left: Array, those: slice, direction: Direction) -> Array:
    """How far bodies are from the walls on one side; not at all if a rounding has put them there."""
    left_walls, right_walls = layout.edges[:2, those]
    right = left[those] + layout.width[those]
    room = right_walls - right if direction is Direction.RIGHT else left[those] - left_walls
    found: Array = np.maximum(room, 0)
    return found


def accumulate(operation: np.ufunc, values: Array, storey: Storey, direction: Direction) -> None:
    """Replace each value along the rows of a storey by that of it and of those before it in a direction."""
    before = values[:0]
    for bodies, rows in storey.runs[::direction]:
        places = values[bodies].reshape(-1, rows)[::direction]
        both = min(rows, len(before))
        operation(before[:both], places[0, :both], out=places[0, :both])
        if rows < MANY_ROWS:
            operation.accumulate(places, axis=0, out=places)
        else:
            for one, other in pairwise(places):
                operation(one, other, out=other)
        before = places[-1]


def lost(layout: Layout, left: Array, found: Ways, holding_on: Array, slack: Any) -> Array:
    """Who may come as near as a slack to losing its support in a step, or does not have it.

    `holding_on` are those that move of their own or with their supports.
    """
    result = np.zeros(len(left), bool)
    riders, fallers, width = layout.riders, layout.fallers, layout.width
    on = layout.support[riders]
    far, under = found.far[riders], found.far[on]
    ahead = np.where(found.stopped[riders] | ~holding_on[riders], far, far - under)
    behind = np.where(holding_on[riders], far - under, under * -1)
    to_right = left[on] + (width[on] + layout.margin[riders]) - left[riders]
    to_left = left[riders] + (width[riders] + layout.margin[riders]) - left[on]
    result[riders] = reaches((ahead * 0, ahead, behind), to_left, to_right, slack)
    far, (begins, ends) = found.far[fallers], layout.edges[2:, fallers]
    to_right, to_left = ends - left[fallers], left[fallers] + width[fallers] - begins
    result[fallers] = reaches((far * 0, far), to_left, to_right, slack)
    return result


def reaches(ways: Sequence[Array], to_left: Array, to_right: Array, slack: Any) -> Array:
    """Whether any of some ways comes as near as a slack to what there is on its side."""
    found: Array = np.logical_or.reduce([(far + slack >= to_right) | (far * -1 + slack >= to_left) for far in ways])
    return found


def furthest(layout: Layout, left: Array, drives: Drives, durations: Array, slack: Any) -> tuple[Array, Array]:
    """How far the bodies of a layout go, to the right, and which levels that is so for; places and drives are in order.

    Who comes as near as `slack` to losing its support is as if it lost it.
    """
    speed, relative, level = drives.speed, drives.relative, layout.level
    found = ways(layout, left, speed * durations[level], relative)
    fits = np.ones(len(durations), bool)
    fits[level[found.unclear | several_speeds(level, speed)]] = False
    fits[level[lost(layout, left, found, relative | moves(speed), slack)]] = False
    return found.far, fits


class Batch:
    """Many levels of storeys, in the kind of numbers that the first of them has: floats, or any in arrays of objects.

    Bodies are counted through all levels: those of a level begin at `first`.

    Attributes:
        left: where the bodies are.
        fits: which levels had a closed form when they were last looked at.
        lead: the speed of who is driven in each level, if anybody is.
        speck: how far roundings may keep a body of each level from where it should come.
        begun, rate, gone, ahead: where bodies were when their level was last looked at, and how they have moved since:
            at these speeds, for so long, of a time for which nothing comes. That is less than 0 if it is not known.
        before, time, far: room for what a step computes. No operation writes where it reads: that takes longer.
    """

    def __init__(self, worlds: Sequence[StoreyWorld[Any]], rules: StepRules, slack: Any = 0) -> None:
        """Take the levels as they are; the rules are for steps without a closed form, and nobody is driven.

        Who would come as near as `slack` to losing its support goes by events: in floats it may be lost or not.
        """
        dtype = np.float64 if isinstance(worlds[0].margin, float) else object
        self.rules, self.slack, self.worlds = rules, slack, [world.copy() for world in worlds]
        sizes = np.array([len(world.places) for world in worlds])
        places = [place for world in worlds for place in world.places]
        self.first, self.level = np.cumsum(sizes) - sizes, np.repeat(np.arange(len(worlds)), sizes)
        self.left = np.array([place.left for place in places], dtype)
        self.width = np.array([place.width for place in places], dtype)
        self.margin = np.array([world.margin for world in worlds], dtype)[self.level]
        self.plain = np.array([is_plain(world) for world in worlds])
        self.standing = {i: standing(worlds[i], dtype) for i in np.flatnonzero(self.plain).tolist()}
        self.layout = self.lay_out()
        self.drives = Drives(np.zeros(len(places), dtype), np.ones(len(places), bool))
        self.fits, self.speck = self.plain.copy(), np.array([speck(world) for world in worlds], dtype)
        self.begun, self.rate, self.time, self.far = self.left.copy(), self.left * 0, self.left * 0, self.left * 0
        self.lead, self.gone, self.before = self.speck * 0, self.speck * 0, self.speck * 0
        self.ahead = self.speck * 0 - 1

    def lay_out(self) -> Layout:
        """Put the bodies of all levels that may have a closed form in order, as they stand."""
        bodies = np.flatnonzero(self.plain[self.level])
        none = Standing(np.zeros((0, 5), int), np.zeros((0, 4), self.left.dtype))
        found = [none, *(self.standing[i] for i in sorted(self.standing))]
        return lay_out(found, bodies, self.first[self.level[bodies]], self.level, self.width, self.margin)

    def world(self, level: int) -> StoreyWorld[Any]:
        """The storeys of a level as they are now."""
        return self.at(level, self.left)

    def at(self, level: int, lefts: Array) -> StoreyWorld[Any]:
        """The storeys of a level with its bodies somewhere else."""
        world, those = self.worlds[level].copy(), self.bodies(level)
        world.places = [
            replace(place, left=left) for place, left in zip(world.places, lefts[those].tolist(), strict=True)
        ]
        return world

    def bodies(self, level: int) -> slice:
        """Where the bodies of a level are."""
        return slice(self.first[level], self.first[level] + len(self.worlds[level].places))

    def drive(self, drives: Drives) -> None:
        """Let bodies have these drives from now on."""
        changed = (drives.speed != self.drives.speed) | (drives.relative != self.drives.relative)
        self.drives = Drives(drives.speed.copy(), drives.relative.copy())
        self.ahead[self.level[changed]] = -1
        driven = moves(drives.speed)
        self.lead[self.level[driven]] = drives.speed[driven]

    def step(self, durations: Array) -> None:
        """Drive all bodies of each level for a time of its own.

        Raises:
            Endless: if rules are chosen too often.
        """
        self.gone, self.before = np.add(self.gone, durations, out=self.before), self.gone
        late = self.gone > self.ahead
        if np.count_nonzero(late):
            self.look(late, durations)
        self.gone.take(self.level, out=self.time, mode="clip")
        np.multiply(self.rate, self.time, out=self.far)
        np.add(self.begun, self.far, out=self.left)

    def look(self, levels: Array, durations: Array) -> None:
        """Look at some levels, in which something may come before a step ends."""
        going = levels & (self.ahead > 0)
        fresh = levels & ~self.go_on(going) if going.any() else levels
        if fresh.any():
            self.begin(fresh, durations)

    def go_on(self, levels: Array) -> Array:
        """Let those of some levels go on as they do in which nothing comes now; return which they are.

        A much longer time is tried, and then that until which, by the closed form of the longer one, all may go on.
        """
        found, sooner = self.kept(levels & self.fits, self.gone * LONGER)
        again, _ = self.kept(levels & self.fits & ~found, sooner)
        by_rules = [level for level in np.flatnonzero(levels & ~self.fits).tolist() if self.kept_by_rules(level)]
        found |= again
        found[by_rules] = True
        return found

    def kept(self, levels: Array, times: Array) -> tuple[Array, Array]:
        """In which of some levels all keep their speeds for a time, and sooner times for the others."""
        layout = part_of(self.layout, levels & self.plain)
        far, fits = self.furthest(layout, self.begun, times)
        _, straight = self.straight(layout, far, times)
        found: Array = levels & fits & straight & (times >= self.gone)
        self.ahead[found] = times[found]
        return found, self.sooner(layout, far, times)

    def kept_by_rules(self, level: int) -> bool:
        """Whether nothing comes in a level now by the rules; nor does it before the first event.

        If somebody settles at that, it is looked at again half the time before: a step may end just then.
        """
        longer = self.gone[level] * LONGER
        moment = next(step(self.rules, self.at(level, self.begun), self.drives_of(level), longer))
        if moment.moved <= self.gone[level]:
            return False
        self.ahead[level] = (self.gone[level] + moment.moved) / 2 if moment.changes else moment.moved
        return True

    def sooner(self, layout: Layout, far: Array, times: Array) -> Array:
        """For each level the shortest time for which somebody of a layout went or stood who did both in a longer one.

        If it did each once, it changed then. Where nobody did both, it is twice the time that the level has gone.
        """
        found, level, whole = self.gone * 2, layout.level, (self.lead * times)[layout.level]
        least = np.minimum(np.abs(far), np.abs(whole - far))
        those = np.flatnonzero(~is_near(least, self.speck[level]))
        until = np.full(len(times), np.inf).astype(times.dtype)
        np.minimum.at(until, level[those], least[those] / np.abs(self.lead[level[those]]))
        np.copyto(found, until, where=until < np.inf)
        return found

    def begin(self, levels: Array, durations: Array) -> None:
        """Take a step in some levels, from where they are."""
        those, layout = levels[self.level], part_of(self.layout, levels & self.plain)
        np.copyto(self.begun, self.left, where=those)
        np.copyto(self.rate, 0, where=those)
        self.ahead[levels], self.gone[levels] = -1, 0
        far, fits = self.furthest(layout, self.left, durations)
        rate, straight = self.straight(layout, far, durations)
        self.fits[levels], straight = fits[levels], levels & fits & straight
        self.ahead[straight] = self.gone[straight] = durations[straight]
        goes, once = straight[layout.level], (levels & fits & ~straight)[layout.level]
        self.rate[layout.order[goes]] = rate[goes]
        self.begun[layout.order[once]] += far[once]
        changed = [self.by_events(level, durations[level]) for level in np.flatnonzero(levels & ~fits).tolist()]
        if any(changed):
            self.layout = self.lay_out()

    def furthest(self, layout: Layout, lefts: Array, durations: Array) -> tuple[Array, Array]:
        """How far each body of a layout goes from a place, to the right, and which levels that is so for."""
        order = layout.order
        drives = Drives(self.drives.speed[order], self.drives.relative[order])
        far, fits = furthest(layout, lefts[order], drives, durations, self.slack)
        return far, fits & self.plain

    def straight(self, layout: Layout, far: Array, durations: Array) -> tuple[Array, Array]:
        """The speeds of the bodies of a layout that come so far, and in which levels all keep theirs for the time.

        Where there is a closed form, all speeds are 0 or that of who is driven. So who comes as far as that leads has
        had it all the time, and who comes nowhere has stood; in floats, but for roundings, which are to be fewer.
        """
        level, whole = layout.level, self.lead * durations
        result = ~is_near(whole, self.speck * 2) | ~moves(self.lead)
        speck, goes = self.speck[level], ~is_near(far, self.speck[level])
        result[level[goes & ~is_near(far - whole[level], speck)]] = False
        return np.where(goes, self.lead[level], 0), result

    def by_events(self, level: int, duration: Any) -> bool:
        """Drive the bodies of a level from event to event; whether any stands otherwise then."""
        those, (world, rates) = self.bodies(level), self.run(level, duration)
        if rates is not None:
            self.rate[those], self.ahead[level], self.gone[level] = rates, duration, duration
            return False
        self.worlds[level], self.begun[those] = world, [place.left for place in world.places]
        if not self.plain[level]:
            return False
        before, now = self.standing[level], standing(world, self.left.dtype)
        self.standing[level] = now
        return not (np.array_equal(before.kinds, now.kinds) and np.array_equal(before.edges, now.edges))

    def run(self, level: int, duration: Any) -> tuple[StoreyWorld[Any], list[Any] | None]:
        """A level after a time, from event to event, and the speeds of its bodies if nothing comes until that is over.

        On a ring these tell nothing: who comes round begins anew.
        """
        world = self.world(level)
        moments, _ = run(self.rules, world, self.drives_of(level), duration)
        if world.circumference is not None or len(moments) > 1 or moments[0].events or moments[0].changes:
            return world, None
        return world, [moments[0].velocities[body] for body in range(len(world.places))]

    def drives_of(self, level: int) -> dict[int, Drive[Any]]:
        """The drives of the bodies of a level."""
        those = self.bodies(level)
        return dict(enumerate(map(Drive, self.drives.speed[those].tolist(), self.drives.relative[those].tolist())))


def is_near(values: Array, far: Array) -> Array:
    """Which values are no further from 0 than that."""
    found: Array = (values <= far) & (values * -1 <= far)
    return found


def speck(world: StoreyWorld[Any]) -> Any:
    """How far roundings may keep a body of a level from where it should come: in floats, some for each body."""
    ends = world.terrain.ends
    if ends is None or not isinstance(world.margin, float):
        return world.margin * 0
    most = max(abs(ends.left), abs(ends.right)) * len(world.places)
    return float(UNIT_ROUNDOFF["float64"]) * ROUNDINGS / 2 * most


def is_plain(world: StoreyWorld[Any]) -> bool:
    """Whether a level may have closed forms: it is a line, and all may push."""
    return world.circumference is None and all(place.pushes for place in world.places)
