"""A turn deleted and inserted although its function stays."""

from __future__ import annotations

from tests.core.findings import introduced, mended, only
from tests.core.worlds import scenario

from lanewright.core.diff import diff
from lanewright.core.identity import renamed

CODE = "replacement.function_preserved"


def test_clean_the_turn_is_rerouted_in_place():
    case = scenario("outer_lane_removed_turn_in_place")
    assert introduced(case.base, case.edited) == []


def test_broken_the_right_turn_of_the_rightmost_lane_under_a_new_id():
    #  11 ──┬── 41 ── 21        the outer lane 12/42/22 goes,
    #       └ 51 => 59          the right turn starts from 11 now
    case = scenario("outer_lane_removed_turn_replaced")
    assert only(case.base, case.edited, CODE).elements == (51, 59)
    after = mended(case.base, case.edited, CODE)
    assert "geometry.topology" in next(one.leaves for one in diff(case.base, after).changes if one.id == 51)


def test_edge_the_turn_from_another_rank_is_another_turn():
    case = scenario("right_turn_rerouted_replaced")
    assert introduced(case.base, case.edited) == []


def test_edge_at_the_same_place_the_replacement_is_told_once():
    case = scenario("right_turn_inserted")
    edited = renamed(case.edited, {51: 59})
    assert introduced(case.edited, edited) == [("replacement.unjustified", (51, 59))]
