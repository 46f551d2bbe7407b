"""What the rules do in situations that a reader of the thesis would try first."""

from fractions import Fraction

import pytest

from reference.formats.level import BodyRecord, LevelRecord, Position, level_of
from reference.simulator import Game
from spec.body import EdgePosition
from spec.graph import Direction
from spec.profiles import THESIS
from spec.transform import in_floats


def game(vertices, bodies, circumference=None, margin="1/4", floats=False):
    """A game on a polyline; each body is (name, edge, left location, edge, right location) and maybe a speed."""
    records = [
        BodyRecord(name, Position(str(left), edge=le), Position(str(right), edge=re), str(speed[0]) if speed else "0")
        for name, le, left, re, right, *speed in bodies
    ]
    record = LevelRecord(
        format="graphbody/level@1",
        name="test",
        vertices=vertices,
        bodies=records,
        margin=margin,
        circumference=circumference,
    )
    level = level_of(record)
    return Game(THESIS, in_floats(level) if floats else level)


def at(played, name):
    """The borders of a body as (edge, location) pairs."""
    body = played.world.bodies[played.handles[name]]
    return (body.left.edge, body.left.location), (body.right.edge, body.right.location)


LINE = [(0, 0), (10, 0)]
TWO = [(0, 0), (10, 0), (13, 4)]


def test_a_free_body_moves_by_all_it_was_asked():
    played = game(LINE, [("A", 0, 1, 0, 2)])
    assert played.request("A", Fraction(3)).moved == 3
    assert at(played, "A") == ((0, 4), (0, 5))


def test_what_exceeds_the_edge_carries_over_to_the_next_and_the_rear_border_follows_later():
    played = game(TWO, [("A", 0, 7, 0, 8)])
    event = played.request("A", Fraction(5, 2))
    assert event.moved == Fraction(5, 2)
    assert at(played, "A") == ((0, Fraction(19, 2)), (1, Fraction(1, 2)))


def test_a_body_that_ends_exactly_at_a_vertex_stays_on_the_edge_it_came_along():
    played = game(TWO, [("A", 0, 7, 0, 8)])
    played.request("A", Fraction(2))
    assert at(played, "A")[1] == (0, 10)


def test_a_body_stops_at_a_wall_and_says_how_far_it_moved():
    played = game(LINE, [("A", 0, 7, 0, 8)])
    event = played.request("A", Fraction(5))
    assert event.moved == 2
    assert ("A", "walk/wall") in event.fired


def test_a_pushed_row_stops_where_its_first_body_meets_the_wall_margins_kept():
    played = game(LINE, [("A", 0, 1, 0, 2), ("B", 0, 4, 0, 5), ("C", 0, 6, 0, 7)])
    event = played.request("A", Fraction(20))
    assert at(played, "C") == ((0, 9), (0, 10))
    assert at(played, "B") == ((0, Fraction(31, 4)), (0, Fraction(35, 4)))
    assert at(played, "A") == ((0, Fraction(13, 2)), (0, Fraction(15, 2)))
    assert event.moved == Fraction(11, 2)
    assert event.depth == 3


def test_a_body_pushes_only_by_what_exceeds_the_room():
    played = game(LINE, [("A", 0, 1, 0, 2), ("B", 0, 4, 0, 5)])
    played.request("A", Fraction(2))
    assert at(played, "B") == ((0, Fraction(17, 4)), (0, Fraction(21, 4)))


def test_left_is_the_mirror_image_of_right():
    played = game(LINE, [("A", 0, 8, 0, 9), ("B", 0, 5, 0, 6)])
    assert played.request("A", Fraction(-20)).moved == Fraction(-27, 4)
    assert at(played, "B") == ((0, 0), (0, 1))


def test_a_full_circle_stops_at_the_push_limit():
    bodies = [(name, 0, i * 3, 0, i * 3 + 2) for i, name in enumerate("ABC")]
    played = game([(0, 0)], bodies, circumference=9, margin=1)
    event = played.request("B", Fraction(1))
    assert event.moved == 0
    assert event.depth == 3
    assert ("A", "push/limit") in event.fired


def test_on_a_circle_with_less_free_space_than_the_distance_the_row_closes_up_and_stops():
    played = game([(0, 0)], [("A", 0, 0, 0, 1), ("B", 0, 4, 0, 5)], circumference=8, margin=1)
    assert played.request("A", Fraction(100)).moved == 4
    assert played.request("A", Fraction(-100)).moved == -4


def test_a_body_alone_on_a_circle_is_no_obstacle_to_itself():
    played = game([(0, 0), (4, 0)], [("A", 0, 1, 0, 2)], circumference=8)
    assert played.request("A", Fraction(20)).moved == 20


def test_a_tick_moves_each_character_by_its_speed_and_no_box():
    played = game(LINE, [("A", 0, 1, 0, 2, 50), ("B", 0, 5, 0, 6)])
    events = played.tick(Direction.RIGHT)
    assert [(event.body, event.moved) for event in events] == [("A", 1)]


def test_one_blocked_character_stops_while_the_other_goes_on():
    played = game(LINE, [("A", 0, 1, 0, 2, 50), ("B", 0, 9, 0, 10, 50)])
    assert [event.moved for event in played.tick(Direction.RIGHT)] == [1, 0]


def test_a_character_that_another_one_pushes_moves_again_in_its_own_turn():
    played = game(LINE, [("A", 0, 1, 0, 2, 50), ("B", 0, "9/4", 0, "13/4", 50)])
    played.tick(Direction.RIGHT)
    assert at(played, "B") == ((0, Fraction(17, 4)), (0, Fraction(21, 4)))


def test_a_row_of_two_thousand_bodies_can_be_pushed():
    bodies = [(str(i), 0, i * 2, 0, i * 2 + 1) for i in range(2000)]
    played = game([(0, 0), (5000, 0)], bodies, margin=1)
    event = played.request("0", Fraction(1))
    assert event.moved == 1
    assert event.depth == 2000


@pytest.mark.parametrize("floats", [False, True])
def test_numbers_keep_their_kind(floats):
    played = game(TWO, [("A", 0, 7, 0, 8)], floats=floats)
    played.request("A", 2.5 if floats else Fraction(5, 2))
    kind = float if floats else Fraction
    assert all(isinstance(location, kind) for _, location in at(played, "A"))


def test_a_rider_on_a_body_across_a_bend_at_the_seam_of_a_cylinder_is_above_it():
    record = LevelRecord(
        "graphbody/level@1",
        "seam",
        [("0", "0"), ("4", "3"), ("8", "0"), ("12", "0")],
        [
            BodyRecord("Box", Position("3", edge=3), Position("1", edge=0)),
            BodyRecord("Rider", Position("1/2", top="Box"), Position("1", top="Box")),
        ],
        circumference="16",
    )
    world = Game(THESIS, level_of(record)).world
    assert world.point(world.bodies[1].left) == (Fraction(309, 20), Fraction(23, 20))


@pytest.mark.parametrize(
    ("body", "round_"), [((0, 1, 3, 3), None), ((0, 4, 0, 3), "20")], ids=["over a hump", "nearly round"]
)
def test_a_top_ends_above_the_borders_also_where_the_ground_bends_between_them(body, round_):
    hump = [(0, 0), (4, 0), (8, 3), (12, 0), *([] if round_ else [(16, 0)])]
    world = game(hump, [("A", *body)], circumference=round_).world
    (held,) = world.bodies
    top = EdgePosition(world.statics, world.width(0))
    assert world.point(top)[0] == world.unrolled(held)[0]
    assert not world.straight(held)


def test_who_falls_is_not_led_up_a_wall_that_begins_at_the_foot():
    played = game([(0, 1), (3, 1), (3, 0), (3, 2), (6, 2)], [("A", 0, 1, 0, 2)])
    event = played.request("A", Fraction(4))
    assert at(played, "A")[0] == (0, 3)
    assert [rule for _, rule in event.fired if rule.startswith("leave/")] == ["leave/nowhere"]
