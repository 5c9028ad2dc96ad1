"""A lane names an id that no map knows."""

from __future__ import annotations

import dataclasses

from tests.core.findings import introduced, mended, only
from tests.core.worlds import straight, street, world

from lanewright.core.edits import apply_edits
from lanewright.core.rules import check

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


def test_edge_what_is_known_stays_named():
    #  1 ──> 2 and 777 (beyond the crop), 3 beside it; 5 and 6 are nowhere
    base = world(straight(1, 0, 20, successors=(777,)), straight(2, 20, 40), straight(3, 0, 20, 3.5, 7))
    edited = base.replaced(
        [
            dataclasses.replace(base.lanes[2], successors=(777, 5), left_neighbor_id=6),
            dataclasses.replace(base.lanes[3], right_neighbor_id=777, predecessors=(5, 777), left_neighbor_id=6),
        ]
    )
    found = [one for one in check(base, edited) if one.code == CODE]
    assert [one.elements for one in found] == [(2,), (3,)]
    after = apply_edits(apply_edits(edited, found[0].fixes[0].edits), found[1].fixes[0].edits)
    assert (after.lanes[2].successors, after.lanes[2].left_neighbor_id) == ((777,), None)
    assert (after.lanes[3].predecessors, after.lanes[3].right_neighbor_id) == ((777,), 777)


def test_edge_a_neighbour_of_the_map_stays_beside_one_that_is_not():
    base = world(straight(1, 0, 60), straight(2, 0, 60, 3.5, 7, right_neighbor_id=1))
    edited = base.replaced([straight(1, 0, 60, left_neighbor_id=2, right_neighbor_id=5)])
    after = mended(base, edited, CODE)
    assert (after.lanes[1].left_neighbor_id, after.lanes[1].right_neighbor_id) == (2, None)


def test_edge_every_lane_that_named_the_deleted_one_is_told():
    base = street()
    assert introduced(base, world(base.lanes[100], base.lanes[200])) == [(CODE, (100,)), (CODE, (200,))]
