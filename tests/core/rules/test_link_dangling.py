"""A lane names an id that no map knows."""

from __future__ import annotations

import dataclasses

from tests.core.findings import introduced, mended, only
from tests.core.worlds import straight, street, world

CODE = "link.dangling"


def test_clean_the_rim_of_the_crop_is_no_defect():
    #  1 ──> 777 (beyond the crop)
    base = world(straight(1, 0, 60, successors=(777,)))
    edited = world(straight(1, 0, 60, successors=(777,)), straight(2, 0, 60, 20, 23.5, predecessors=(777,)))
    assert introduced(base, edited) == []


def test_broken_a_deleted_lane_is_still_named():
    base = street()
    edited = world(base.lanes[100], dataclasses.replace(base.lanes[200], predecessors=()))
    assert only(base, edited, CODE).elements == (100,)
    assert mended(base, edited, CODE).lanes[100].successors == ()


def test_edge_a_neighbour_that_is_not_there():
    base = world(straight(1, 0, 60))
    edited = world(straight(1, 0, 60, left_neighbor_id=5))
    assert mended(base, edited, CODE) == base
