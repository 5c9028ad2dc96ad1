"""An element keeps its id at another place."""

from __future__ import annotations

from tests.core.findings import introduced, mended, only
from tests.core.worlds import crossing, lane, scenario, straight, world

from lanewright.core.diff import diff
from lanewright.core.rules import check

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


def test_edge_what_came_and_went_holds_nothing():
    #  1 ─┐            1 ─┐ (20 m up)
    #  2 ─┴─ 5   =>    2 ─┴─ 9     1 and 2 share a junction in both maps, but only through 5 and through 9
    base = world(
        straight(1, 0, 20, 30, 33.5, successors=(5,)),
        straight(2, 0, 20, 0, 3.5, successors=(5,)),
        straight(5, 20, 40, 0, 3.5),
    )
    edited = world(
        straight(1, 0, 20, 50, 53.5, successors=(9,)),
        straight(2, 0, 20, 0, 3.5, successors=(9,)),
        straight(9, 20, 90, 0, 3.5),
    )
    assert (CODE, (1,)) in introduced(base, edited)


def test_edge_a_junction_of_survivors_holds():
    #  1 ── 2, and 1 swings 20 m away with its other end
    base = world(straight(1, 0, 20, successors=(2,)), straight(2, 20, 40, predecessors=(1,)))
    swung = lane(1, "3.5,30 20,3.5", "0,30 20,0", successors=(2,))
    assert introduced(base, base.replaced([swung])) == []


def test_broken_three_renames_are_all_named_on_the_button():
    case = scenario("ends_exchanged")
    titles = {fix.title for one in check(case.base, case.edited) for fix in one.fixes}
    assert titles == {"Make canonical: lane 9 becomes lane 1, lane 100 becomes lane 200 and lane 200 becomes lane 100"}
