"""An id that this map once deleted stands for something else."""

from __future__ import annotations

from tests.core.worlds import crossing, straight, world

from lanewright.core.claims import Claims
from lanewright.core.edits import apply_edits
from lanewright.core.elements import ElementKind
from lanewright.core.rules import check

CODE = "identity.reused"
OLD = straight(9, 0, 60)
BASE = world(straight(1, 0, 60, 20, 23.5))
CLAIMS = Claims(retired={OLD.key: OLD})


def codes(edited):
    return [one.code for one in check(BASE, edited, CLAIMS)]


def test_clean_the_same_lane_comes_back():
    assert codes(world(BASE.lanes[1], OLD)) == []


def test_broken_another_lane_under_the_old_id():
    edited = world(BASE.lanes[1], straight(9, 200, 260))
    assert codes(edited) == [CODE]
    fix = check(BASE, edited, CLAIMS)[0].fixes[0]
    assert codes(apply_edits(edited, fix.edits)) == []


def test_edge_without_a_history_nothing_is_known():
    assert check(BASE, world(BASE.lanes[1], straight(9, 200, 260))) == ()


def test_broken_a_crossing_under_the_old_id_of_a_lane():
    drawn = crossing(9, 10)
    edited = world(BASE.lanes[1], drawn)
    (violation,) = check(BASE, edited, CLAIMS)
    assert (violation.code, violation.kind, violation.elements) == (CODE, ElementKind.PEDESTRIAN_CROSSING, (9,))
    after = apply_edits(edited, violation.fixes[0].edits)
    assert codes(after) == []
    assert [one.edge1 for one in after.crossings.values()] == [drawn.edge1]


def crossings(retired, edited):
    claims = Claims(retired={retired.key: retired})
    return check(BASE, world(*BASE, edited), claims)


def test_clean_a_crossing_comes_back_where_it_overlaps_its_old_place():
    assert crossings(crossing(9, 30), crossing(9, 30)) == ()
    assert crossings(crossing(9, 30), crossing(9, 31)) == ()


def test_broken_another_crossing_under_the_old_id():
    (violation,) = crossings(crossing(9, 30), crossing(9, 32))
    assert (violation.code, violation.elements) == (CODE, (9,))
    edited = world(*BASE, crossing(9, 32))
    after = apply_edits(edited, violation.fixes[0].edits)
    assert after.crossings.keys() == {10}
    assert after.crossings[10].edge1 == edited.crossings[9].edge1
    assert after.lanes == edited.lanes


def test_edge_of_several_retired_ids_each_is_judged_by_itself():
    #  8 is nowhere, 9 came back as it was, 10 stands for something else, 1 is a survivor
    retired = {
        one.key: one for one in (straight(8, 0, 60), OLD, straight(10, 0, 60), crossing(10, 0), straight(1, 900, 960))
    }
    edited = world(BASE.lanes[1], OLD, straight(10, 200, 260), crossing(10, 300))
    found = check(BASE, edited, Claims(retired=retired))
    assert [(one.kind, one.elements) for one in found] == [
        (ElementKind.LANE_SEGMENT, (10,)),
        (ElementKind.PEDESTRIAN_CROSSING, (10,)),
    ]
    for one in found:
        after = apply_edits(edited, one.fixes[0].edits)
        assert one.id not in {other.id for other in check(BASE, after, Claims(retired=retired))}


def test_edge_the_fix_takes_no_id_that_was_retired():
    retired = {one.key: one for one in (OLD, straight(10, 0, 60), straight(11, 0, 60))}
    edited = world(BASE.lanes[1], straight(9, 200, 260))
    (violation,) = check(BASE, edited, Claims(retired=retired))
    assert violation.fixes[0].title == "Call it lane 12"


def test_broken_a_lane_beside_behind_or_oncoming_under_the_old_id():
    beside, behind = straight(9, 0, 60, 3.5, 7), straight(9, 60, 120)
    oncoming = straight(9, 60, 0, 3.5, 0)
    for other in (beside, behind, oncoming):
        assert CODE in codes(world(BASE.lanes[1], other)), other


def test_clean_the_lane_comes_back_a_little_elsewhere():
    assert codes(world(BASE.lanes[1], straight(9, 2, 66, 0.5, 4))) == []
