"""Steps on storeys: what is easily got wrong, the invariants at work on wrong rules, and many games in floats."""

from fractions import Fraction

from properties.evidence.courses import drive
from reference.storeys import Place, StoreyWorld, Terrain
from spec.profiles import REPAIRED
from spec.storeys import Drive, Interval


def line(length, margin, *places):
    """The floor of a line."""
    return StoreyWorld(Terrain((), Interval(Fraction(0), Fraction(length))), Fraction(margin), places)


def ring(length, grounds, margin, *places):
    """A ring with grounds one storey up."""
    solid = tuple(Interval(Fraction(left), Fraction(right)) for left, right in grounds)
    return StoreyWorld(Terrain((solid,), None, Fraction(length)), Fraction(margin), places)


def test_a_body_that_goes_nearly_round_a_ring_does_not_fall_through_a_hole_that_it_does_not_fit_into():
    world = ring(4, [(0, 2)], 1, Place(1, Fraction(3), Fraction(3), None))
    course = drive(REPAIRED.rules, world, {0: Drive(Fraction(1))}, Fraction(3), Fraction(0))
    assert course.after.storey(0) == 1


def test_a_squeezed_body_stands_even_if_it_may_not_push_back():
    places = Place(0, Fraction(0), Fraction(2), None), Place(0, Fraction(3), Fraction(2), None, pushes=False)
    world = line(9, 1, *places)
    drives = {0: Drive(Fraction(1), relative=False), 1: Drive(Fraction(-1), relative=False)}
    course = drive(REPAIRED.rules, world, drives, Fraction(1), Fraction(0))
    assert [course.after.span(body).left for body in (0, 1)] == [0, 3]
