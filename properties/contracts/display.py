"""What is shown of the display: one display step with any numbers, any two after each other, and counts of many.

A display step changes how high above its target a body is shown, and nothing else counts. So what holds of any step,
with any height, target and sinking, holds after any number of them.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from itertools import pairwise
from math import dist, hypot, isclose
from random import Random
from typing import Any

from properties.contracts.errata import Stage
from properties.contracts.families import promise_one
from properties.contracts.request import Seen
from properties.given import Given
from reference.display import Screen, Speeds, frames
from reference.play import LIBRARY
from reference.recording import recording
from reference.simulator import Game, Heard, Record
from reference.world import World
from spec.body import Body, EdgePosition, Level
from spec.display import DISPLAY_RULES, DISPLAYS, THESIS_DISPLAY
from spec.graph import Vertex, polyline
from spec.interpolation import circular
from spec.invariants import every
from spec.number import greater, lesser
from spec.profiles import AnyProfile, Profile
from spec.rules.display import Descent, DisplayRules, Shift, Swing, by_the_time_fallen, by_the_way_fallen

MOST_CHOICES = 10
SPEEDS = Speeds(Fraction(100), Fraction(900))


def seen_by(given: Given, rules: DisplayRules) -> DisplayRules:
    """The rules of a display, seen."""
    return rules.through(lambda family: Seen(family, given, MOST_CHOICES))


def any_descent(given: Given) -> Descent[Any]:
    """Any height on the screen, any target, any sinking."""
    shown, target = given.number("shown"), given.number("target")
    return Descent(shown, target, given.flag("it is shown falling"), given.number("sinking"))


def any_swing(given: Given) -> Swing[Any]:
    """Any angle on the screen, any target, any turning."""
    shown, target = given.number("angle shown"), given.number("angle of the ground")
    return Swing(shown, target, given.flag("it is shown turning"), given.number("turning"))


def vertical_has_one(rules: DisplayRules, given: Given) -> None:
    """Any height, target and sinking."""
    promise_one(given, rules.vertical, any_descent(given))


def rotation_has_one(rules: DisplayRules, given: Given) -> None:
    """Any angle, target and turning."""
    promise_one(given, rules.rotation, any_swing(given))


def across_has_one(rules: DisplayRules, given: Given) -> None:
    """Any place."""
    promise_one(given, rules.across, Shift(given.number("shown"), given.number("target")))


def descended(rules: DisplayRules, descent: Descent[Any]) -> Descent[Any]:
    """A body after a display step."""
    after: Descent[Any] = rules.vertical.choose(descent).effect(descent)
    return after


def swung(rules: DisplayRules, swing: Swing[Any]) -> Swing[Any]:
    """A body's angle after a display step."""
    after: Swing[Any] = rules.rotation.choose(swing).effect(swing)
    return after


def falls_are_smooth(rules: DisplayRules, given: Given) -> None:
    """A body is never shown below its target, nor raised above it, nor lowered by more than it sinks."""
    descent = any_descent(given)
    after = descended(seen_by(given, rules), descent)
    given.ensure("it is not shown below its target", after.shown >= descent.target)
    if descent.falling:
        most = greater(descent.shown, descent.target)
        given.ensure("it is not raised, but to its target", after.shown <= most)
        least = lesser(descent.shown, greater(descent.target, descent.shown - descent.by))
        given.ensure("it is lowered by what it sinks, or less at the target", after.shown >= least)
        given.ensure("it goes on until its target", after.falling == bool(after.shown > descent.target))
    else:
        given.ensure("it is at its target", every([after.shown == descent.target, not after.falling]))


def falls_add_up(rules: DisplayRules, given: Given) -> None:
    """Two display steps show what one does in which the body sinks by as much as in both."""
    target, rules = given.number("target"), seen_by(given, rules)
    first, second = given.number("sinking"), given.number("sinking after that")
    start = Descent(target + given.number("height above the target"), target, given.flag("it is shown falling"), first)
    middle = descended(rules, start)
    twice = descended(rules, Descent(middle.shown, target, middle.falling, second))
    once = descended(rules, Descent(start.shown, target, start.falling, first + second))
    given.ensure("the same height", twice.shown == once.shown)
    given.ensure("one falls if the other does", twice.falling == once.falling)


def falls_arrive(rules: DisplayRules, given: Given) -> None:
    """A body that sinks by its height above its target is there, and falls no more."""
    descent = any_descent(given)
    given.assume(descent.shown - descent.target <= descent.by, "it sinks by its height above its target, or more")
    after = descended(seen_by(given, rules), descent)
    given.ensure("it is there", after.shown == descent.target)
    given.ensure("it falls no more", not after.falling)


def places_are_at_once(rules: DisplayRules, given: Given) -> None:
    """Horizontally a body is where it is."""
    shift, rules = Shift(given.number("shown"), given.number("target")), seen_by(given, rules)
    given.ensure("it is there", rules.across.choose(shift).effect(shift) == shift.target)


def riders_stay_on_top(rules: DisplayRules, given: Given) -> None:
    """A body is never shown inside the one that it stands on, and one that falls with it stays upon it."""
    rules, height, by = seen_by(given, rules), given.number("height"), given.number("sinking")
    below = Descent(given.number("shown"), given.number("target"), given.flag("the support falls"), by)
    raised, carried = given.number("how much higher the rider is shown"), given.flag("the rider falls")
    support = descended(rules, below)
    on_top = support.shown + height
    rider = descended(rules, Descent(below.shown + height + raised, on_top, carried, by))
    given.ensure("it is shown upon its support", rider.shown >= on_top)
    if carried and below.falling and raised <= raised * 0:
        given.ensure("one that falls with it stays upon it", rider.shown == on_top)


def turns_are_smooth(rules: DisplayRules, given: Given) -> None:
    """A body that is shown turning comes nearer to its target, by the turning speed, and never goes past it."""
    swing = any_swing(given)
    after = swung(seen_by(given, rules), swing)
    away, left = distance(swing.shown, swing.target), distance(after.shown, swing.target)
    if swing.turning:
        given.ensure("it comes nearer by the turning speed, or is there", left == greater(away - swing.by, away * 0))
        given.ensure("it turns no more than that", distance(after.shown, swing.shown) <= swing.by)
        given.ensure("it goes on until its target", after.turning == bool(left > 0))
    else:
        given.ensure("it is at its target", every([after.shown == swing.target, not after.turning]))


def turns_add_up(rules: DisplayRules, given: Given) -> None:
    """Two display steps turn a body as far as one does in which it turns by as much as in both."""
    rules, start, second = seen_by(given, rules), any_swing(given), given.number("turning after that")
    middle = swung(rules, start)
    twice = swung(rules, Swing(middle.shown, start.target, middle.turning, second))
    once = swung(rules, Swing(start.shown, start.target, start.turning, start.by + second))
    given.ensure("the same angle", twice.shown == once.shown)
    given.ensure("one turns if the other does", twice.turning == once.turning)


def distance(a: Any, b: Any) -> Any:
    """How far two numbers are from each other."""
    return greater(a - b, b - a)


def steps_to_land(sinking: Any, height: Fraction, tick: Fraction, speed: Fraction) -> int:
    """In how many display steps a body that is shown so high above its target comes down to it."""
    descent, steps = Descent(height, height * 0, True, height * 0), 0
    while descent.falling:
        by = sinking(steps * tick, (steps + 1) * tick, speed)
        descent, steps = descended(THESIS_DISPLAY, Descent(descent.shown, height * 0, True, by)), steps + 1
    return steps


def falls_end(profile: AnyProfile) -> int:
    """A fall of height h is shown in the least n display steps for which n (n + 1) / 2 ticks, times the fall speed, are
    h or more; under `repaired` in the least for which n² ticks squared, times it, are.
    """
    sizes = [Fraction(size, 4) for size in (1, 3, 4, 8, 17, 40)]
    cases = [(height, tick, speed) for height in sizes for tick in sizes[:4] for speed in sizes[:4]]
    for height, tick, speed in cases:
        steps = steps_to_land(by_the_time_fallen, height, tick, speed)
        assert steps * (steps + 1) * tick * speed >= 2 * height > (steps - 1) * steps * tick * speed, f"{steps} steps"
        steps = steps_to_land(by_the_way_fallen, height, tick, speed)
        assert (steps * tick) ** 2 * speed >= height > ((steps - 1) * tick) ** 2 * speed, f"{steps} steps"
    return 2 * len(cases)


def cuts_do_not_matter(profile: AnyProfile) -> int:
    """Under `repaired`, a body has sunk by as much after a time, into whatever display steps that is cut."""
    draw, cases = Random(6), 200
    for _ in range(cases):
        cuts = sorted({Fraction(draw.randrange(1, 1000), 100) for _ in range(draw.randrange(1, 9))})
        sunk = [by_the_way_fallen(before, after, Fraction(3)) for before, after in pairwise([Fraction(0), *cuts])]
        assert sum(sunk) == 3 * cuts[-1] ** 2, f"cut at {cuts}: {sum(sunk)}"
    return cases


def every_display_rule_fires(profile: AnyProfile) -> int:
    """A scenario in which bodies fall onto slopes, shown in frames of a quarter of a tick, needs every rule."""
    record = Record(0)
    shown = recording(LIBRARY / "scenarios" / "fall-onto-slopes.json")
    rules = DISPLAYS[shown.header.profile].through(lambda family: Heard(family, record))
    steps = len(list(frames(shown, rules, SPEEDS, parts=4)))
    missing = {rule.id for rule in DISPLAY_RULES} - {rule for _, rule in record.fired}
    assert not missing, f"it does not need {', '.join(sorted(missing))}"
    return steps


def nobody_drops_unseen(profile: AnyProfile) -> int:
    """With hardly any fall speed, nobody is lowered on the screen by more than that, in scenarios of storeys."""
    slow, cases = Speeds(Fraction(1, 10**6), Fraction(1)), 0
    for path in sorted((LIBRARY / "scenarios").glob("repaired-*.json")):
        found = recording(path)
        for before, after in pairwise(frames(found, DISPLAYS[profile.name], slow)):
            for name in before.keys() & after.keys():
                lowered = before[name].y - after[name].y
                assert lowered <= Fraction(1, 1000), f"{path.stem}: {name} is lowered by {lowered} at once"
                cases += 1
    return cases


def arcs() -> Iterator[tuple[tuple[float, float], tuple[float, float]]]:
    """Pairs of points, less than half a round apart, at equal and at other distances from the origin."""
    draw = Random(13)
    for _ in range(200):
        start = (draw.uniform(-4, 4), draw.uniform(-4, 4))
        end = (draw.uniform(-4, 4), draw.uniform(-4, 4))
        scale = hypot(*start) / hypot(*end)
        yield start, end
        yield start, (end[0] * scale, end[1] * scale)


PARTS = [part / 8 for part in range(9)]


def circles_are_even(profile: AnyProfile) -> int:
    """From end to end, the distance from the origin changes by equal parts. Between points as far from it, and only
    there, the way goes by equal parts too. Together they are longer than the chord that the graph measures.
    """
    pairs = list(arcs())
    for start, end in pairs:
        points = [circular(start, end, part) for part in PARTS]
        radii, ways = [hypot(*point) for point in points], [dist(*pair) for pair in pairwise(points)]
        assert dist(points[0], start) + dist(points[-1], end) < 1e-9, f"{start} to {end}: other ends"
        grown = [far - near for near, far in pairwise(radii)]
        assert all(isclose(one, grown[0], abs_tol=1e-9) for one in grown), f"{start} to {end}: uneven radii"
        on_a_circle = isclose(radii[0], radii[-1])
        assert isclose(min(ways), max(ways), rel_tol=1e-6) == on_a_circle, f"{start} to {end}: ways {ways}"
        assert sum(ways) > dist(start, end), f"{start} to {end}: not longer than the chord"
    return len(pairs)


def before_a_pit(tick: Any, bodies: int) -> Level[Any]:
    """One or two bodies before a pit that is as deep as they are high; the one that is nearer to it comes first."""
    one = Fraction(1)
    graph = polyline([Vertex(one * x, one * y) for x, y in ((0, 1), (4, 1), (4, 0), (8, 0))])
    places = [one * 5 / 2 - body * 3 / 2 for body in range(bodies)]
    borders = [(EdgePosition(0, left), EdgePosition(0, left + one)) for left in places]
    held = tuple(Body("AB"[i], left, right, one, one) for i, (left, right) in enumerate(borders))
    return Level(graph, one / 8, tick, held)


def shown_level(world: World[Any]) -> Screen[Any]:
    """A screen on which nobody turns, and the fall speed is 1."""
    one = Fraction(1)
    return Screen(THESIS_DISPLAY, Speeds(one, one), world, bearing=lambda run, rise: one * 0)


def any_tick(given: Given) -> Any:
    """Any length of a tick."""
    tick = given.number("tick")
    given.assume(tick > 0, "the tick is positive")
    return tick


def frames_do_not_matter(profile: Profile, given: Given, stage: Stage) -> None:
    """A body that falls is shown as high after a tick, whether that is one display step or two."""
    level = before_a_pit(any_tick(given), bodies=1)
    start, game, asked = stage.set(level), Game(profile, level), Fraction(2)
    stage.steps.append(("A", asked))
    game.request("A", asked)
    heights = []
    for parts in (1, 2):
        screen = shown_level(start)
        for part in range(parts):
            screen.show(game.world, frozenset() if part else frozenset({"A"}), level.tick / parts)
        heights.append(screen.shown["A"].y)
    given.ensure("it is shown as high", heights[0] == heights[1])


def nobody_is_shown_rising(profile: Profile, given: Given, stage: Stage) -> None:
    """A body that steps onto the top of one that is shown falling is not shown higher than before."""
    level, asked = before_a_pit(any_tick(given), bodies=2), Fraction(7, 2)
    screen, game = shown_level(stage.set(level)), Game(profile, level)
    stage.steps.append(("B", asked))
    before = screen.shown["B"].y
    game.request("B", asked)
    screen.show(game.world, frozenset({"A", "B"}), level.tick)
    given.ensure("it is shown no higher than before", screen.shown["B"].y <= before)
