"""A deletion and an insertion at the same place."""

from __future__ import annotations

import dataclasses

from tests.core.findings import introduced, mended, only
from tests.core.worlds import crossing, lane, line, scenario, straight, street, world

from lanewright.core.diff import diff
from lanewright.core.edits import apply_edits
from lanewright.core.identity import renamed, with_lanes_exchanged
from lanewright.core.rules import check
from lanewright.core.series import Run

CODE = "replacement.unjustified"


def test_clean_a_lane_that_goes_for_good_is_a_deletion():
    #  100 ── 1 ── 200   =>   100      200
    base = street()
    edited = world(
        dataclasses.replace(base.lanes[100], successors=()), dataclasses.replace(base.lanes[200], predecessors=())
    )
    assert introduced(base, edited) == []


def test_broken_a_lane_under_a_new_id_between_the_same_junctions():
    #  100 ── 1 ── 200   =>   100 ── 9 ── 200
    base = street()
    edited = renamed(base, {1: 9})
    violation = only(base, edited, CODE)
    assert violation.elements == (1, 9)
    assert "edit lane 1 in place" in violation.message
    assert mended(base, edited, CODE) == base


def test_broken_a_lane_drawn_anew_as_two_is_joined_by_the_fix():
    #  100 ── 1 ── 200   =>   100 ── 8 ─ 9 ── 200
    base = street()
    run = Run.of([base.lanes[1]])
    halves = [dataclasses.replace(piece, id=key) for piece, key in zip(run.pieces([(20, 20)]), (8, 9), strict=True)]
    edited = with_lanes_exchanged(base, [1], halves)
    assert only(base, edited, CODE).elements == (1, 8, 9)
    assert diff(base, mended(base, edited, CODE)).changes == ()


def test_broken_a_property_that_changes_half_way_asks_for_a_cut():
    case = scenario("marks_mid_lane")
    after = mended(case.base, case.edited, CODE)
    assert {key: lane.part_of for key, lane in after.lanes.items()} == {9: 1, 10: 1, 100: None, 200: None}
    assert [(one.id, one.leaves) for one in diff(case.base, after).changes] == [(10, ("marking.type.left",))]


def test_broken_a_crossing_drawn_anew_on_the_same_ground():
    base, edited = world(crossing(5, 30)), world(crossing(6, 31))
    assert only(base, edited, CODE).elements == (5, 6)
    assert list(mended(base, edited, CODE).crossings) == [5]


def test_edge_free_ends_just_beyond_three_metres_are_another_place():
    #  1 ───────   =>      9 ───────   (3.2 m further on)
    base = world(straight(1, 0, 60))
    assert introduced(base, world(straight(9, 2.9, 62.9))) == [(CODE, (1, 9))]
    assert [code for code, _ in introduced(base, world(straight(9, 3.2, 63.2)))] == ["identity.not_canonical"]


def test_edge_a_ring_replaced_by_a_ring():
    #  one lane that leads into itself, round a roundabout
    ring = lane(1, "2,0 0,2 -2,0 0,-2 2,0", "6,0 0,6 -6,0 0,-6 6,0", successors=(1,), predecessors=(1,))
    base, edited = world(ring), renamed(world(ring), {1: 9})
    assert only(base, edited, CODE).elements == (1, 9)


def test_broken_a_part_of_what_was_drawn_stands_in_the_old_place():
    #  1 ──   =>   9 ── 10: 9 where 1 was, 10 beyond it, inside an intersection
    base = world(straight(1, 0, 60))
    beyond = straight(10, 60, 90, predecessors=(9,), is_intersection=True)
    edited = world(straight(9, 0, 60, successors=(10,)), beyond)
    assert only(base, edited, CODE).elements == (1, 9)
    assert set(mended(base, edited, CODE).lanes) == {1, 10}


def test_broken_each_fix_mends_its_own_update():
    base = world(straight(1, 0, 60), straight(2, 1000, 1060))
    edited = renamed(base, {1: 8, 2: 9})
    found = [one for one in check(base, edited) if not one.inherited]
    assert [one.elements for one in found] == [(1, 8), (2, 9)]
    assert [set(apply_edits(edited, one.fixes[0].edits).lanes) for one in found] == [{1, 9}, {2, 8}]


def test_edge_a_line_that_only_a_person_can_redraw_stays_bad_under_the_old_id():
    base = street()
    crossed = dataclasses.replace(base.lanes[1], left_boundary=line("20,3.5 40,3.5 40,6 30,6 30,2 60,3.5"))
    edited = renamed(base.replaced([crossed]), {1: 9})
    violation = only(base, edited, CODE)
    assert introduced(base, apply_edits(edited, violation.fixes[0].edits)) == [("geometry.invalid", (1,))]
