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
