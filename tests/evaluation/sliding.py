"""What a run says of bodies that slide: figures 6.10 and 6.11, friction and gravity (6.3.2, 6.3.3)."""

from __future__ import annotations

from collections.abc import Callable
from math import asin, atan, degrees
from statistics import median

from evaluation.cases import FITTED, FREE, RUBBING, SHOWN_FRICTION, SHOWN_SPEED, STEEPNESS_BY, TICK, TICKS, UNITY
from evaluation.finding import (
    BOX2D,
    MENDED,
    PRINTED,
    Fact,
    Finding,
    Rows,
    Tables,
    digits,
    judged,
    least,
    length,
    most,
)
from evaluation.gravity import GUESSES, INSET
from evaluation.tables import Line, by, number
from spec import evaluated
from spec.evaluated import Judgement

CLOSE = 0.01
"""Bodies of width 1 m that are nowhere further apart than this follow each other closely."""

NEAR = 0.02
"""What fits is 10 if it is no further from it."""

Chosen = Callable[[Line], bool]


def distances(tables: Tables, engine: str, gravity: float, chosen: Chosen) -> list[Line]:
    """How far an engine is from Box2D at most, in those runs that are chosen."""
    lines = tables["differences"].of(engine)
    return [line for line in lines if number(line, "gravity") == gravity and chosen(line)]


def furthest(tables: Tables, engine: str, gravity: float, chosen: Chosen) -> float:
    """How far an engine is from Box2D at most, over all runs that are chosen."""
    return most(distances(tables, engine, gravity, chosen), "furthest")


def frictionless(line: Line) -> bool:
    """A run on a slope without friction."""
    return line["friction"] == 0


def on_flat(line: Line) -> bool:
    """A run on the flat."""
    return line["degrees"] == 0


def rubbing(turning: bool, slope: float | None = None) -> Chosen:
    """A run on a slope with friction, or on that slope, in which the box may turn or not."""

    def chosen(line: Line) -> bool:
        steep = line["degrees"] != 0 if slope is None else line["degrees"] == slope
        return steep and line["friction"] != 0 and line["turning"] == turning

    return chosen


def gravity_slope(tables: Tables) -> Finding:
    """E1."""
    ours = max(furthest(tables, engine, UNITY, frictionless) for engine in (PRINTED, MENDED))
    fitted = furthest(tables, PRINTED, FITTED, frictionless)
    return Finding(
        evaluated.GRAVITY,
        judged(ours <= CLOSE),
        f"The box keeps to the slope in all {len(FREE)} runs of {TICKS * TICK:g} s.",
        f"With gravity {UNITY}, as printed and as mended, within {length(ours)} of the box; with {FITTED:g} up to "
        f"{length(fitted)} away.",
        (
            "Figure 6.10 anew. Below, how far graphbodies are from the box on the same six slopes, which does not "
            "depend on the speed. Without friction the printed and the mended rules are the same.",
        ),
        figure=("slope", "Figure 6.10: places along the slope, on six slopes, at five speeds"),
    )


def guessed(tables: Tables, name: str) -> list[Line]:
    """What fits best under a guess, in each run."""
    return [line for line in tables["gravity"].lines if line["guess"] == name]


def guess_rows(tables: Tables) -> Rows:
    """What gravity fits best, and how well, under each guess."""
    keys = ("error", f"error at {UNITY:g}", f"error at {FITTED:g}")
    rows = [("guess", "best: least", "median", "most", "error with the best", *(f"with {key[9:]}" for key in keys[1:]))]
    for guess in GUESSES:
        own = guessed(tables, guess.name)
        best = [number(line, "best") for line in own]
        told = (f"{value:.2f}" for value in (min(best), median(best), max(best)))
        rows.append((guess.name, *told, *(length(most(own, key)) for key in keys)))
    return tuple(rows)


def gravity_of_10(tables: Tables) -> Finding:
    """P3: what gravity fits best, under each guess."""
    printed = guessed(tables, GUESSES[0].name)
    worse = all(number(line, f"error at {UNITY:g}") < number(line, f"error at {FITTED:g}") for line in printed)
    return Finding(
        evaluated.GRAVITY_OF_10,
        judged(not worse),
        f"What fits it best is {median(number(line, 'best') for line in printed):.2f}, under each of its settings "
        "tried.",
        f"The printed rule is nearer with {UNITY} than with {FITTED:g} in each of {len(printed)} runs.",
        (
            "Why did 10 fit better? For each guess the table has the gravity that fits best over the slopes and speeds "
            "of figure 6.10, by the sum of squares over all ticks; and the greatest error of a run, as the root of the "
            f"mean square, with the best gravity, with {UNITY} and with {FITTED:g}. Runs take {TICKS * TICK:g} s, if "
            "nothing else is said.",
            *known(tables),
        ),
        facts_of_gravity(tables),
        guess_rows(tables),
        ("gravity", "Which gravity fits best under each guess, in each run"),
    )


def known(tables: Tables) -> tuple[str, ...]:
    """What is known of the reason, and what is not."""
    fits = {guess.name: [number(line, "best") for line in guessed(tables, guess.name)] for guess in GUESSES}
    as_ever = [name for name, best in fits.items() if off(best, UNITY) < NEAR / 10]
    scattered = [name for name, best in fits.items() if max(best) - min(best) > NEAR]
    ten = [name for name, best in fits.items() if off(best, FITTED) < NEAR]
    return (
        f"**What is known.** It is neither the engine nor its settings: {UNITY} is what fits best with "
        f"{letters(as_ever)}.",
        f"What fits best differs from run to run with {letters(scattered)}. These can be the reason only if 10 was "
        f"best on the whole, by the choice of the runs. Within {NEAR:g} of {FITTED:g} at every angle and speed is: "
        f"{letters(ten) or 'none'}.",
        '`getSteepness()` "returns the dot product between the up vector and the vector that points from one '
        'EdgePosition in 3D space to the other" (6.3.2): the text does not say that this vector is normalised. 0.01 is '
        "the distance at which Unity's 2D physics takes shapes to touch, if nothing else is set. With such a vector "
        f"{FITTED:g} is exactly right for borders that are {UNITY / FITTED:.3f} apart on a body of width 1.",
        "A body that moves before it finds its velocity comes near 10 too, in runs of two to three seconds; but the "
        "shorter the run, the greater the gravity that fits, and none fits well.",
        "**What is not known.** Of the prototype's code the thesis prints figure 6.7 only, and its text has no number "
        "of the runs behind figure 6.10. That borders were inset is a guess, if the only one here that explains what "
        "is said. Not tried is a minimum or maximum of velocity, with which places are no longer linear in gravity.",
    )


def letters(names: list[str]) -> str:
    """Guesses, each with its letter; those of one letter that are all among them by the letter alone."""
    found = {name[:3]: [other for other in names if other[:3] == name[:3]] for name in names}
    every = {name[:3]: [guess.name for guess in GUESSES if guess.name[:3] == name[:3]] for name in names}
    told = [key if found[key] == every[key] else "; ".join(found[key]) for key in found]
    return "; ".join(told)


def off(best: list[float], gravity: float) -> float:
    """By how much what fits best differs from a gravity, at most."""
    return max(abs(value - gravity) for value in best)


def facts_of_gravity(tables: Tables) -> tuple[Fact, ...]:
    """What was recorded of P3."""
    exact = furthest(tables, PRINTED, UNITY, frictionless)
    fitted = distances(tables, PRINTED, FITTED, frictionless)
    near, far, time = least(fitted, "furthest"), most(fitted, "furthest"), TICKS * TICK
    steepest = (FITTED - UNITY) * time * (time + TICK) / 2
    (inset,) = (guess.name for guess in GUESSES if guess.prototype.inset)
    bests = [number(line, "best") for line in guessed(tables, inset)]
    return (
        Fact("P3", "the printed rule with 9.81 follows to 1 mm", f"to {length(exact)}", exact <= 0.001),
        Fact(
            "P3",
            "with 10 it misses by 0.02 to 9 m",
            f"by {digits(near)} to {digits(far)} m; in {time:g} s it cannot miss by more than {digits(steepest)} m",
            far > 8.5,
        ),
        Fact(
            "P3",
            "not normalised and inset by 0.01: 10.01 at every speed and angle",
            f"{min(bests):.3f} to {max(bests):.3f}",
            off(bests, UNITY / (1 - 2 * INSET)) < 0.001,
        ),
    )


def flat_friction(tables: Tables) -> Finding:
    """E2."""
    ours = max(furthest(tables, engine, UNITY, on_flat) for engine in (PRINTED, MENDED))
    ends = [line for line in tables["ends"].lines if on_flat(line)]
    short = max(abs(formula(line) - number(line, "end") - number(line, "speed") * TICK / 2) for line in ends)
    partial = most(ends, "friction") * UNITY * TICK**2 / 4
    return Finding(
        evaluated.FLAT_FRICTION,
        judged(ours <= CLOSE),
        "The box slides and stops; its friction is the geometric mean of two coefficients, here of the same.",
        f"As printed and as mended within {length(ours)} of the box, from start to stop.",
        (
            f"Figure 6.11 anew: (a) {SHOWN_SPEED} m/s and coefficients from 0.1 to 0.8, (b) a coefficient of "
            f"{SHOWN_FRICTION} and 1 to 10 m/s. All {len(ends) // 3} pairs of the two are compared. On the flat the "
            "printed and the mended rules are the same.",
        ),
        (
            Fact("E2", "within 0.15 mm", f"within {length(ours)}", ours <= 0.00015),
            Fact(
                "E2",
                "both stop v0 dt / 2 short of v0² / (2 mu g)",
                f"so do all three, to {length(short)}: the last tick is cut short",
                short <= partial,
            ),
        ),
        figure=("flat", "Figure 6.11: places on the flat, for several coefficients and several speeds"),
    )


def formula(line: Line) -> float:
    """Where a body stops that friction slows evenly."""
    return number(line, "speed") ** 2 / (2 * number(line, "friction") * UNITY)


def static_friction(tables: Tables) -> Finding:
    """E3, P2."""
    engines = {engine: by(tables["rest"].of(engine), "friction") for engine in (BOX2D, PRINTED, MENDED)}
    rows, close = [], []
    for friction in (number(line, "friction") for line in tables["rest"].of(BOX2D)):
        found = [number(lines[friction,], "degrees") for lines in engines.values()]
        proper, printed = degrees(atan(friction)), degrees(asin(friction / (1 + friction)))
        wanted = (proper, printed, proper)
        close.append([abs(a - b) <= STEEPNESS_BY * 1.001 for a, b in zip(found, wanted, strict=True)])
        rows.append((f"{friction:g}", *(f"{value:.1f}" for value in (*found, proper, printed))))
    return Finding(
        evaluated.STATIC_FRICTION,
        Judgement.EXPLAINED if all(map(all, close)) else Judgement.REFUTED,
        "A box at rest stays at rest on slopes up to atan(mu): one coefficient serves both kinds of friction.",
        "As printed a body at rest stays at rest on slopes up to asin(mu / (1 + mu)), as mended up to atan(mu).",
        (
            "Friction that cannot turn a velocity round, but ends at 0, is static friction: where it can take in a "
            "tick all that gravity gives, a body at rest stays. Box2D has the same, with the same coefficient. So "
            "nothing can be seen on the flat, where the thesis looked; on a slope the printed rule lets go too "
            "early, because of its normal force.",
            f"The steepest slope on which a body laid down at rest stays, in degrees, by steps of {STEEPNESS_BY:g}:",
        ),
        (
            Fact(
                "P2",
                "a body at rest slides at asin(mu / (1 + mu)), not atan(mu)",
                f"so it is, to {STEEPNESS_BY:g} degrees",
                all(one[1] for one in close),
            ),
        ),
        (("mu", BOX2D, "printed", "mended", "atan(mu)", "asin(mu / (1 + mu))"), *rows),
    )


COLUMNS = ((PRINTED, True), (MENDED, True), (MENDED, False))
"""Engines beside a box that may turn, or may not."""


def normal_force(tables: Tables) -> Finding:
    """P1."""
    printed = distances(tables, PRINTED, UNITY, rubbing(turning=True))
    worst = max(printed, key=lambda line: number(line, "furthest"))
    turning, still = (furthest(tables, MENDED, UNITY, rubbing(may)) for may in (True, False))
    far = f"up to {length(number(worst, 'furthest'))} away from the box after {TICKS * TICK:g} s ({worst['run']})"
    return Finding(
        evaluated.NORMAL_FORCE,
        judged(number(worst, "furthest") <= CLOSE),
        "The box is pressed onto the slope by the cosine of the slope times gravity.",
        f"As printed {far}; as mended, with the cosine, within {length(turning)}.",
        (
            f"{len(RUBBING)} runs of {TICKS * TICK:g} s with friction. What is left between box and mended rule is the "
            "engine's: where a box that may turn comes to its turning point, its weight is shared out anew between its "
            f"corners, for which the 8 iterations that Unity gives are too few. If it may not turn, {length(still)} "
            "are left. The greatest distance, by slope:",
        ),
        facts_of_friction(tables, worst, turning, still),
        (("degrees", "printed", "mended", "mended, and the box may not turn"), *rows_of_slopes(tables)),
    )


def rows_of_slopes(tables: Tables) -> Rows:
    """The greatest distances, by slope."""
    slopes = sorted({run.degrees for run in RUBBING})
    cells = [
        [length(furthest(tables, engine, UNITY, rubbing(may, slope))) for engine, may in COLUMNS] for slope in slopes
    ]
    return tuple((f"{slope:g}", *row) for slope, row in zip(slopes, cells, strict=True))


def facts_of_friction(tables: Tables, worst: Line, turning: float, still: float) -> tuple[Fact, ...]:
    """What was recorded of P1."""
    runs = by(distances(tables, PRINTED, UNITY, rubbing(turning=True)), "degrees", "friction", "speed")
    there, everywhere = number(runs[40, 0.8, 5], "furthest"), number(worst, "furthest")
    return (
        Fact("P1", "the cosine fits to 0.1 mm over 100 runs", f"to {length(turning)}", turning <= 0.0001),
        Fact("P1", "the same, if the box may not turn", f"to {length(still)}", still <= 0.0001),
        Fact("P1", "as printed 2.95 m off at 40 degrees, mu 0.8, 5 m/s", f"{there:.2f} m", abs(there - 2.95) < 0.01),
        Fact("P1", "that is the most", f"{everywhere:.2f} m, {worst['run']}", everywhere < there + 0.01),
    )


def start_speed(tables: Tables) -> Finding:
    """P4."""
    (normal,) = (guess.name for guess in GUESSES if guess.settings.get("heading"))
    tangent, away = (most(guessed(tables, name), f"error at {UNITY:g}") for name in (GUESSES[0].name, normal))
    return Finding(
        evaluated.START_SPEED,
        judged(away <= CLOSE),
        "Started along the normal, the box leaves the ground.",
        f"Velocity is along the ground. If the box starts along it too, errors are up to {length(tangent)}; if it "
        f"starts along the normal, up to {length(away)}.",
        (
            "Table 6.3 says normal; in the text bodies are shot upwards from the bottom of the edge and slide down. "
            "What is meant is the tangent.",
        ),
    )
