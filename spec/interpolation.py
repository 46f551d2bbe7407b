"""Interpolation between two points of the plane, for showing positions (6.1.2; R13)."""

from __future__ import annotations

from math import atan2, cos, hypot, pi, sin

from spec.number import N

Point = tuple[float, float]


def linear(start: tuple[N, N], end: tuple[N, N], part: N) -> tuple[N, N]:
    """The point a part of the way from one point to another, on the straight line."""
    (x, y), (far_x, far_y) = start, end
    return x + (far_x - x) * part, y + (far_y - y) * part


def circular(start: Point, end: Point, part: float) -> Point:
    """The point a part of the way round the origin, the short way; the distance from it changes linearly."""
    turn = atan2(end[1], end[0]) - atan2(start[1], start[0])
    turn = (turn + pi) % (2 * pi) - pi
    angle = atan2(start[1], start[0]) + turn * part
    radius = hypot(*start) + (hypot(*end) - hypot(*start)) * part
    return radius * cos(angle), radius * sin(angle)
