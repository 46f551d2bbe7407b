"""The numbers of docs/physics.md: what the printed rules of velocity do, beside the mended ones, in exact runs."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from fractions import Fraction
from math import asin, atan, degrees

from spec.profiles import MENDED, PRINTED
from spec.rules.velocity import Material, Motion, Slope, VelocityRules, simulate_tick

BEGIN = "<!-- numbers: made from the rules -->\n"
END = "<!-- numbers: end -->\n"

ONE, ZERO = Fraction(1), Fraction(0)
LEVEL = Slope(ONE, ZERO)
GRAVITY, TICK = Fraction(981, 100), Fraction(1, 50)
SLOPES = {
    name: Slope(Fraction(run, length), Fraction(rise, length))
    for name, run, rise, length in (("5-12-13", 12, 5, 13), ("3-4-5", 4, 3, 5), ("20-21-29", 21, 20, 29))
}
SECONDS = 2


def with_numbers(page: str) -> str:
    """A page with the numbers between its two marks made anew."""
    before, _, rest = page.partition(BEGIN)
    _, found, after = rest.partition(END)
    assert found, "the page has no place for the numbers"
    return before + BEGIN + "\n".join(numbers()) + END + after


def numbers() -> Iterator[str]:
    """All tables, each with what it shows."""
    yield "\n**P1.** A body is shot up a slope at 5 m/s, with a coefficient of 0.8 and gravity 9.81, in ticks of 20 ms."
    yield f"How far up it is after {SECONDS} s, in metres:\n"
    yield table(("slope", "degrees", "printed", "mended", "difference"), shots())
    yield "**P2.** The steepest slope on which a body rests, in degrees:\n"
    yield table(("coefficient", "printed: sin <= mu / (1 + mu)", "mended: tan <= mu"), rests())
    yield "**P10.** A body at 1 m/s on level ground, where only drag acts; after 1 s, in ticks of several lengths:\n"
    yield table(("tick in ms", "printed, drag 0.98", "mended, damping 1", "its way", "velocity and way"), dragged())
    yield "**E2.** The way on which a body at 5 m/s stops on level ground, with gravity 9.81, in ticks of 20 ms:\n"
    yield table(("coefficient", "way", "v0^2 / (2 a)", "that, less v0 dt / 2"), stops())


def table(head: tuple[str, ...], rows: Iterable[tuple[str, ...]]) -> str:
    """A table in Markdown."""
    lines = [head, ("---",) * len(head), *rows]
    return "".join(f"| {' | '.join(line)} |\n" for line in lines)


def decimal(number: Fraction | float, places: int = 3) -> str:
    """A number, rounded."""
    return f"{float(number):.{places}f}"


def material(friction: Fraction = ZERO, drag: Fraction = ONE, damping: Fraction = ZERO) -> Material[Fraction]:
    """A material without bounds."""
    return Material(friction, drag, damping, ZERO, None, ONE)


def run(
    rules: VelocityRules, motion: Motion[Fraction], slope: Slope[Fraction], tick: Fraction, ticks: int
) -> tuple[Fraction, Fraction]:
    """The velocity and the way after some ticks."""
    way = ZERO
    for _ in range(ticks):
        motion = simulate_tick(rules, motion, slope, tick)
        way += motion.velocity * tick
    return motion.velocity, way


def shots() -> Iterator[tuple[str, ...]]:
    """How far up each slope a body is by the printed and by the mended rules."""
    motion = Motion(5 * ONE, material(friction=Fraction(4, 5)), GRAVITY, ZERO)
    for name, slope in SLOPES.items():
        printed, mended = (run(rules, motion, slope, TICK, SECONDS * 50)[1] for rules in (PRINTED, MENDED))
        angle = decimal(degrees(asin(slope.rise)), 1)
        yield name, angle, decimal(printed), decimal(mended), decimal(printed - mended)


def rests() -> Iterator[tuple[str, ...]]:
    """Up to which angle bodies of several coefficients rest."""
    for friction in (Fraction(n, 10) for n in (2, 4, 6, 8, 10)):
        yield (
            decimal(friction, 1),
            decimal(degrees(asin(friction / (1 + friction))), 1),
            decimal(degrees(atan(friction)), 1),
        )


def dragged() -> Iterator[tuple[str, ...]]:
    """What drag leaves in a second by both rules, tick by tick."""
    motion = Motion(ONE, material(drag=Fraction(98, 100), damping=ONE), ZERO, ZERO)
    for ticks in (25, 50, 100):
        tick = Fraction(1, ticks)
        printed, mended = (run(rules, motion, LEVEL, tick, ticks) for rules in (PRINTED, MENDED))
        left, way = mended
        yield str(1000 // ticks), decimal(printed[0]), decimal(left), decimal(way), decimal(left + way)


def stops() -> Iterator[tuple[str, ...]]:
    """The ways on which bodies of several coefficients stop."""
    for friction in (Fraction(n, 10) for n in (1, 2, 4, 8)):
        motion = Motion(5 * ONE, material(friction=friction), GRAVITY, ZERO)
        whole = motion.velocity * motion.velocity / (2 * friction * GRAVITY)
        way = run(MENDED, motion, LEVEL, TICK, 300)[1]
        yield decimal(friction, 1), decimal(way, 4), decimal(whole, 4), decimal(whole - motion.velocity * TICK / 2, 4)
