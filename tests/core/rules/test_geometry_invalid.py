"""Lines that cannot be a lane or a crossing."""

from __future__ import annotations

import dataclasses
import math

import pytest
from tests.core.findings import introduced, only
from tests.core.worlds import crossing, lane, line, straight, street, world

from lanewright.core.rules import check

CODE = "geometry.invalid"
BASE = world(straight(1, 0, 60))


def test_clean_a_lane_that_tapers_to_a_point():
    #  1 ◁═════
    assert introduced(world(), world(lane(1, "0,0 30,3.5 60,3.5", "0,0 60,0"))) == []


def test_clean_a_lane_round_a_roundabout():
    ring = lane(1, "2,0 0,2 -2,0 0,-2 2,0", "6,0 0,6 -6,0 0,-6 6,0", successors=(1,), predecessors=(1,))
    assert introduced(world(), world(ring)) == []


@pytest.mark.parametrize(
    ("left", "right", "words"),
    [
        ("0,3.5", "0,0 60,0", "fewer than two points"),
        ("0,3.5 nan,3 60,3.5", "0,0 60,0", "not a finite number of metres"),
        ("0,3.5 20,3.5 20,3.5 60,3.5", "0,0 60,0", "repeats its point 2"),
        ("0,3.5 40,3.5 40,6 20,6 20,2 60,2", "0,0 60,0", "left boundary crosses itself"),
        ("0,3.5 60,-3.5", "0,0 60,0", "boundaries cross each other"),
        ("0,0 60,0", "0,3.5 60,3.5", "not on the left"),
        ("0,0.2 60,0.2", "0,0 60,0", "0.20 m wide"),
        ("0,20 60,20", "0,0 60,0", "20.00 m wide"),
    ],
)
def test_broken(left, right, words):
    violation = only(world(), world(lane(1, left, right)), CODE)
    assert words in violation.message
    assert violation.fixes == ()


def test_broken_a_crossing_whose_edges_cross():
    crossed = dataclasses.replace(crossing(5, 30), edge2=line("28,0 36,4"))
    assert only(world(), world(crossed), CODE).elements == (5,)


def test_edge_inherited_until_that_boundary_is_edited():
    broken = lane(1, "0,3.5 40,3.5 40,6 20,6 20,2 60,2", "0,0 60,0")
    moved = dataclasses.replace(broken, right_boundary=line("0,-1 60,-1"))
    redrawn = dataclasses.replace(broken, left_boundary=line("0,3.5 40,3.5 40,7 20,7 20,2 60,2"))
    assert [one.inherited for one in check(world(broken), world(broken))] == [True]
    assert [one.inherited for one in check(world(broken), world(moved))] == [True]
    assert [one.inherited for one in check(world(broken), world(redrawn))] == [False]


def test_edge_nothing_is_wrong_with_an_infinite_height():
    high = tuple((x, y, math.nan) for x, y, _ in straight(1, 20, 60).left_boundary)
    base = street()
    assert introduced(base, base.replaced([dataclasses.replace(base.lanes[1], left_boundary=high)])) == []


def test_clean_a_lane_that_ends_in_a_point():
    #  ═════▷ 1
    assert introduced(world(), world(lane(1, "0,3.5 30,3.5 60,0", "0,0 30,0 60,0"))) == []


def test_broken_boundaries_that_run_along_each_other():
    (violation,) = check(world(), world(lane(1, "0,3.5 20,0 40,0 60,3.5", "0,0 60,0")))
    assert "boundaries cross each other" in violation.message


def test_edge_what_was_deleted_is_told_no_more():
    crossed = dataclasses.replace(crossing(5, 30), edge2=line("28,0 36,4"))
    broken = lane(1, "0,3.5 40,3.5 40,6 20,6 20,2 60,2", "0,0 60,0")
    assert [one.elements for one in check(world(broken, crossed), world(broken, crossed))] == [(1,), (5,)]
    assert check(world(broken, crossed), world()) == ()


def test_edge_beside_an_old_defect_a_new_one_is_told_alone():
    base = world(lane(1, "0,3.5 20,3.5 20,3.5 60,3.5", "0,0 60,0"))
    edited = world(lane(1, "0,3.5 20,3.5 20,3.5 60,3.5", "0,0 0,0 60,0"))
    (violation,) = check(base, edited)
    assert violation.message == "Lane 1: the right boundary repeats its point 1. Redraw it there."
    assert not violation.inherited


@pytest.mark.parametrize(("top", "broken"), [(0.29, True), (0.31, False), (14.9, False), (15.1, True)])
def test_edge_the_narrowest_and_the_widest_lane(top, broken):
    assert bool(check(world(), world(straight(1, 0, 60, 0, top)))) is broken
