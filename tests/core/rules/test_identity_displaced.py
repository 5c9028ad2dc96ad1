"""An element keeps its id at another place."""

from __future__ import annotations

from tests.core.findings import introduced, mended, only
from tests.core.worlds import crossing, scenario, straight, world

from lanewright.core.diff import diff

CODE = "identity.displaced"


def test_clean_a_lane_swings_out_between_the_same_junctions():
    case = scenario("realigned_between_junctions")
    assert introduced(case.base, case.edited) == []


def test_broken_a_free_lane_keeps_its_id_twenty_metres_away():
    case = scenario("free_lane_moved_far")
    assert only(case.base, case.edited, CODE).elements == (1,)
    assert set(mended(case.base, case.edited, CODE).lanes) == {2}


def test_broken_two_lanes_side_by_side_exchange_their_ids():
    #  1 ═ 2   =>   2 ═ 1
    case = scenario("lanes_exchanged")
    assert only(case.base, case.edited, CODE).elements == (1, 2)
    assert diff(case.base, mended(case.base, case.edited, CODE)).changes == ()


def test_broken_a_crossing_hardly_overlaps_its_old_place():
    base, edited = world(crossing(5, 30)), world(crossing(5, 32))
    assert only(base, edited, CODE).elements == (5,)


def test_edge_a_free_lane_three_metres_aside_is_the_same():
    base = world(straight(1, 0, 60, 0, 3.5))
    assert introduced(base, world(straight(1, 0, 60, 6.4, 9.9))) == []
    assert introduced(base, world(straight(1, 0, 60, 6.6, 10.1))) == [(CODE, (1,))]
