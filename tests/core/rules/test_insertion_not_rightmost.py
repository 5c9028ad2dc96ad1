"""The right-hand-side rule for lanes that come."""

from __future__ import annotations

from tests.core.findings import introduced, mended, only
from tests.core.worlds import scenario

from lanewright.core.diff import diff

CODE = "insertion.not_rightmost"


def test_clean_the_new_lane_comes_on_the_right():
    #  ┆  1  ┆   =>   ┆ 1 ┆ 9 ┆
    case = scenario("lane_added_right")
    assert introduced(case.base, case.edited) == []


def test_broken_the_new_lane_comes_on_the_left_of_one_that_made_room():
    #  ┆  1  ┆   =>   ┆ 9 ┆ 1 ┆
    case, right = scenario("lane_added_left"), scenario("lane_added_right")
    assert only(case.base, case.edited, CODE).elements == (9,)
    after = mended(case.base, case.edited, CODE)
    assert diff(case.base, after).changes == diff(right.base, right.edited).changes


def test_broken_three_segments_in_a_row_are_one_lane():
    case = scenario("three_segments_added_left")
    assert only(case.base, case.edited, CODE).elements == (7, 8, 9)


def test_edge_nothing_had_to_make_room():
    case = scenario("lane_added_left_clear")
    assert introduced(case.base, case.edited) == []


def test_edge_links_tell_the_lanes_apart():
    for name in ("left_pocket_opens", "left_pocket_middle"):
        case = scenario(name)
        assert introduced(case.base, case.edited) == []
