"""Interpolation between points of the plane."""

from fractions import Fraction
from math import pi, sin

import pytest

from spec.interpolation import circular, linear


def test_linear_interpolation_is_exact_on_exact_numbers():
    assert linear((Fraction(0), Fraction(0)), (Fraction(3), Fraction(4)), Fraction(1, 3)) == (1, Fraction(4, 3))


def test_circular_interpolation_rotates_about_the_origin():
    assert circular((1, 0), (0, 1), 0.5) == pytest.approx((sin(pi / 4), sin(pi / 4)))


def test_circular_interpolation_changes_the_distance_linearly():
    assert circular((1, 0), (-3, 0.0001), 0.5)[1] == pytest.approx(2, abs=1e-3)


def test_circular_interpolation_takes_the_short_way_round():
    assert circular((0, -1), (-1, 0), 0.5) == pytest.approx((-sin(pi / 4), -sin(pi / 4)))
