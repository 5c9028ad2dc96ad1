"""The right-hand-side rule for lanes that go."""

from __future__ import annotations

from tests.core.findings import introduced, mended, only
from tests.core.worlds import scenario, straight, world

from lanewright.core.diff import diff

CODE = "deletion.not_rightmost"


def test_clean_the_right_lane_goes():
    #  ┆ 1 ┆ 2 ┆   =>   ┆  1  ┆
    case = scenario("lane_removed_right")
    assert introduced(case.base, case.edited) == []


def test_broken_the_left_lane_goes_and_the_right_one_takes_its_room():
    #  ┆ 1 ┆ 2 ┆   =>   ┆  2  ┆
    case, right = scenario("lane_removed_left"), scenario("lane_removed_right")
    assert only(case.base, case.edited, CODE).elements == (1,)
    after = mended(case.base, case.edited, CODE)
    assert diff(case.base, after).changes == diff(right.base, right.edited).changes


def test_edge_the_rule_is_the_insertion_rule_of_the_inverse_update():
    case = scenario("lane_added_left")
    assert introduced(case.edited, case.base) == [(CODE, (9,))]


def test_edge_a_lane_that_would_be_too_far_away_is_no_candidate():
    #  5 ┆ 4 ┆ 3, free at both ends: one lane stays, on the place of 3 and longer. It may be 4, but not 5
    base = world(
        straight(3, 0, 25, 0, 3.5, left_neighbor_id=4),
        straight(4, 0, 25, 3.5, 7, right_neighbor_id=3, left_neighbor_id=5),
        straight(5, 0, 25, 7, 10.5, right_neighbor_id=4),
    )
    assert introduced(base, world(straight(4, 0, 33, 0, 3.5))) == []
