"""Two elements for one thing on the road."""

from __future__ import annotations

import dataclasses

from tests.core.findings import introduced, mended, only
from tests.core.worlds import crossing, lane, straight, world

from lanewright.core.elements import LaneType
from lanewright.core.rules import check

CODE = "element.duplicate"


def test_clean_a_two_way_street_is_two_lanes_on_each_other():
    #  1 ──>
    #  <── 2   on the same ground
    base = world(straight(1, 0, 60))
    oncoming = lane(2, "60,0 0,0", "60,3.5 0,3.5")
    assert introduced(base, world(base.lanes[1], oncoming)) == []


def test_broken_a_lane_drawn_on_another():
    base = world(straight(1, 0, 60))
    edited = world(base.lanes[1], straight(9, 0, 60, 0.1, 3.5))
    assert only(base, edited, CODE).elements == (1, 9)
    assert mended(base, edited, CODE) == base


def test_broken_two_crossings_on_each_other():
    base = world(crossing(5, 30))
    assert only(base, world(crossing(5, 30), crossing(6, 30.1)), CODE).elements == (5, 6)


def test_edge_another_type_is_another_lane_and_old_duplicates_are_inherited():
    base = world(straight(1, 0, 60))
    assert introduced(base, world(base.lanes[1], straight(9, 0, 60, lane_type=LaneType.BIKE))) == []
    twice = world(straight(1, 0, 60), straight(2, 0, 60))
    marked = twice.replaced([dataclasses.replace(twice.lanes[1], is_intersection=True)])
    assert [(one.code, one.inherited) for one in check(twice, marked)] == [(CODE, True)]
