"""What is found in a level: places where something is not kept, in words, each with requests that go wrong there."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from fractions import Fraction
from pathlib import Path
from typing import Any

from properties.lint.search import Range, Search, Some, Wrong, hull, range_of, search, shifts
from reference.formats.files import FormatError, one_line
from reference.formats.level import LevelRecord, valid_level
from reference.plan import check_plan
from reference.play import profile_of, read_playable, stance_of
from reference.world import LevelError, World
from spec.body import Level
from spec.conditions import EDGES_LONG, PLANE_START, clearances_demanded, lengths_demanded
from spec.demand import Demand, Element, Place, breaches
from spec.graph import EdgeType
from spec.guidelines import GUIDELINES, Size, sizes_of
from spec.profiles import AnyProfile, Profile
from spec.registry import Statement, statements

OF_STOREYS = "model/storeys"
MOST_NAMED, MOST_REACHES, MOST_EDGES = 3, 20, 500
NOT_LOOKED = f"more than {MOST_EDGES} edges, which only --profile repaired looks at"


@dataclass(frozen=True)
class Linted:
    """A level to be linted: where it stands, its record, the level itself, and the profile."""

    file: Path
    where: str
    record: LevelRecord
    level: Level[Fraction]
    profile: AnyProfile


@dataclass(frozen=True)
class Finding:
    """A place where something is not kept: its path in the file, what is there, and what of it is wrong."""

    place: str
    what: str
    statement: Statement
    seen: str
    mend: str
    reach: Range | None
    wrong: Wrong | None = None


@dataclass(frozen=True)
class Found:
    """All that was found in a level: findings, what else goes wrong, what was searched, and if it is of storeys."""

    findings: list[Finding]
    others: list[Wrong]
    searched: Search | None
    storeys: LevelError | None


def opened(file: Path, profile: str | None) -> Linted:
    """The level of a level or scenario file, to be linted under a profile, or that of the scenario.

    Raises:
        FormatError: one line that names the file and the place, if anything in it is not as it must be.
    """
    scenario, record = read_playable(file)
    where = f"{file.parent / scenario.level}: $" if isinstance(scenario.level, str) else f"{file}: $.level"
    try:
        chosen = profile_of(profile or scenario.profile)
    except LevelError as error:
        raise FormatError(one_line(f"{file}: {error.problem}")) from None
    try:
        level = valid_level(record, "$", stance=stance_of(chosen))
    except LevelError as error:
        raise FormatError(one_line(f"{where}{error.place[1:]}: {error.problem}")) from None
    return Linted(file, where.partition(": ")[2], record, level, chosen)


def found_in(linted: Linted) -> Found:
    """Look for places where something is not kept, and for requests that go wrong."""
    if not isinstance(linted.profile, Profile):
        storeys = storeys_refused(linted.level)
        return Found([] if storeys is None else [of_storeys(linted, storeys)], [], None, storeys)
    few = len(linted.level.graph.edges) <= MOST_EDGES
    storeys = storeys_refused(linted.level) if few else LevelError("$", NOT_LOOKED)
    world = World(linted.level)
    findings = [finding(linted, world, *one) for one in not_kept(world)]
    if any(one.statement is PLANE_START for one in findings):
        return Found(findings, [], None, storeys)
    searched = search(linted.profile, world, by_nearness(world, findings))
    findings = [replace(one, wrong=wrong_at(one.reach, searched.wrongs)) for one in findings]
    told = {name for one in findings if one.wrong is not None for name in one.wrong.broken}
    return Found(findings, list(others(searched.wrongs, told)), searched, storeys)


def storeys_refused(level: Level[Fraction]) -> LevelError | None:
    """Why a level is none of storeys, or None if it is one."""
    try:
        check_plan(level)
    except LevelError as error:
        return error
    return None


def of_storeys(linted: Linted, error: LevelError) -> Finding:
    """That a level is none of storeys, as a finding."""
    statement = statements()[OF_STOREYS]
    return Finding(under(linted.where, error.place), "the level", statement, error.problem, "", None)


def not_kept(world: World[Fraction]) -> Iterator[tuple[Statement, Demand]]:
    """What is not kept, once for each place: guidelines, then conditions."""
    sizes = grouped(sizes_of(world))
    for guideline in GUIDELINES:
        yield from ((guideline, one) for one in first_of_each(breaches(guideline.demands(world.graph, sizes))))
    yield from ((EDGES_LONG, one) for one in breaches(lengths_demanded(world)))
    terrain = Grounds(world)
    for group in groups(world):
        yield from ((PLANE_START, one) for one in clearances_of(world, group, terrain))


class Grounds:
    """The ground edges of a level from left to right: those that are near some range are found without all others."""

    def __init__(self, world: World[Fraction]) -> None:
        self.world = world
        edges = [(number, edge) for number, edge in enumerate(world.graph.edges) if edge.type is EdgeType.GROUND]
        self.longest = max((edge.length for _, edge in edges), default=Fraction(0))
        starts = [(world.graph.vertices[edge.left].x, number) for number, edge in edges]
        self.starts = sorted((x + by, number) for x, number in starts for by in shifts(world))

    def near(self, reach: Range) -> list[int]:
        """The numbers of those that may be nearer to a range than the margin."""
        first = bisect_left(self.starts, (reach[0] - self.longest - self.world.margin, 0))
        last = bisect_left(self.starts, (reach[1] + self.world.margin, 0))
        return sorted({number for _, number in self.starts[first:last]})


def clearances_of(world: World[Fraction], group: list[int], terrain: Grounds) -> Iterator[Demand]:
    """The clearances that some bodies do not keep, to each other and to the terrain that is where they are."""
    numbers = terrain.near(hull(range_of(world, body) for body in group))
    graph = replace(world.graph, edges=tuple(world.graph.edges[number] for number in numbers))
    for one in breaches(clearances_demanded(Some(world, group, graph))):
        others = [replace(place, number=numbers[place.number]) for place in one.others if place.element is Element.EDGE]
        yield replace(one, others=tuple(others)) if others else one


def grouped(sizes: Iterable[Size]) -> list[Size]:
    """The bodies of each size together, in the level's order: the size of the first body first."""
    bodies: dict[tuple[Any, Any], list[int]] = {}
    for size in sizes:
        bodies.setdefault((size.width, size.height), []).extend(size.bodies)
    return [Size(tuple(of_size), width, height) for (width, height), of_size in bodies.items()]


def first_of_each(demands: Iterable[Demand]) -> Iterator[Demand]:
    """One demand of those of one kind at a place: that with the greatest numbers."""
    found: dict[tuple[Place, str], Demand] = {}
    for one in demands:
        known = found.get((one.place, one.seen))
        if known is None or one.numbers > known.numbers:
            found[one.place, one.seen] = one
    return iter(found.values())


def groups(world: World[Fraction]) -> list[list[int]]:
    """The bodies, from left to right, in groups that are at least the margin apart."""
    ranges = sorted((range_of(world, body), body) for body in world.handles())
    found: list[list[int]] = []
    end = Fraction(0)
    for (left, right), body in ranges:
        if not found or left >= end + world.margin:
            found.append([])
        end = max(end, right) if found[-1] else right
        found[-1].append(body)
    if world.graph.circumference is not None and len(found) > 1:
        found[0] += found.pop()
    return found


def finding(linted: Linted, world: World[Fraction], statement: Statement, demand: Demand) -> Finding:
    """What is not kept at a place, in words."""
    place = static(world, demand.place)
    others = named(world, demand.others)
    seen, mend = (text.format(*demand.numbers, others=others) for text in (demand.seen, demand.mend))
    path = under(linted.where, path_of(linted.record, place))
    return Finding(path, words(world, place), statement, seen, mend, reach_of(world, place))


def static(world: World[Fraction], place: Place) -> Place:
    """A place, of which a ground edge is counted among all static edges."""
    if place.element is not Element.GROUND:
        return place
    grounds = [index for index, edge in enumerate(world.graph.edges) if edge.type is EdgeType.GROUND]
    return Place(Element.EDGE, grounds[place.number])


def under(where: str, place: str) -> str:
    """A place in a level as a place in the document that it stands in."""
    return place.replace("$", where, 1)


def path_of(record: LevelRecord, place: Place) -> str:
    """Where a place stands in the file of a level; an edge that is not named there, at its left vertex."""
    if place.element is Element.BODY:
        return f"$.bodies[{place.number}]"
    named_there = place.element is Element.EDGE and record.edges is not None
    return f"$.{'edges' if named_there else 'vertices'}[{place.number}]"


def words(world: World[Fraction], place: Place) -> str:
    """What is at a place, in words."""
    if place.element is Element.BODY:
        return f"body {world.bodies[place.number].name!r}"
    points = [f"({vertex.x}, {vertex.y})" for vertex in vertices_at(world, place)]
    if place.element is Element.VERTEX:
        return f"vertex {place.number}, at {points[0]}"
    kind = world.graph.edges[place.number].type.value
    return f"{kind} edge {place.number}, from {points[0]} to {points[1]}"


def vertices_at(world: World[Fraction], place: Place) -> list[Any]:
    """The vertices of an edge, or a vertex itself."""
    graph = world.graph
    if place.element is Element.VERTEX:
        return [graph.vertices[place.number]]
    edge = graph.edges[place.number]
    return [graph.vertices[edge.left], graph.vertices[edge.right]]


def named(world: World[Fraction], places: tuple[Place, ...]) -> str:
    """Some places, each by its number or name."""
    of_bodies = bool(places) and places[0].element is Element.BODY
    names = [repr(world.bodies[one.number].name) if of_bodies else f"edge {one.number}" for one in places]
    shown = names if len(names) <= MOST_NAMED else [*names[:MOST_NAMED], f"{len(names) - MOST_NAMED} more"]
    listed = " and ".join([", ".join(shown[:-1]), *shown[-1:]] if len(shown) > 1 else shown)
    return f"{'body' if len(names) == 1 else 'bodies'} {listed}" if of_bodies else listed


def reach_of(world: World[Fraction], place: Place) -> Range:
    """Between where in the plane a place is."""
    if place.element is Element.BODY:
        return range_of(world, place.number)
    xs = [vertex.x for vertex in vertices_at(world, place)]
    return min(xs), max(xs)


def by_nearness(world: World[Fraction], findings: list[Finding]) -> list[int]:
    """All bodies, those first that are nearest to where something is not kept."""
    reaches = sorted({one.reach for one in findings if one.reach is not None})[:MOST_REACHES]

    def distance(body: int) -> Fraction:
        left, right = range_of(world, body)
        return min((max(start - right, left - end, Fraction(0)) for start, end in reaches), default=Fraction(0))

    return sorted(world.handles(), key=distance)


def wrong_at(reach: Range | None, wrongs: list[Wrong]) -> Wrong | None:
    """The first requests that go wrong at a place."""
    if reach is None:
        return None
    return next((one for one in wrongs if one.reach[0] <= reach[1] and reach[0] <= one.reach[1]), None)


def others(wrongs: list[Wrong], told: set[str]) -> Iterator[Wrong]:
    """The first requests that break each of what is not told of yet."""
    for one in wrongs:
        if not told.issuperset(one.broken):
            told.update(one.broken)
            yield one
