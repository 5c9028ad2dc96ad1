"""What stays below tolerance goes back to the base, exactly and without gaps."""

from __future__ import annotations

import dataclasses

import pytest
from tests.core.worlds import REAL_MAPS, REAL_MAPS_MISSING, crossing, line, real_map, scenario, straight, street, world

from lanewright.core.diff import diff
from lanewright.core.restore import restore


def test_a_map_against_itself_stays_the_very_same():
    base = street()
    assert restore(base, street()) == base


def test_a_point_added_on_the_line_goes():
    case = scenario("vertex_on_line")
    assert restore(case.base, case.edited) == case.base


def test_a_joint_moved_by_three_centimetres_returns_in_both_lanes():
    #  100 ──┤ moved by 3 cm ├── 1
    base = street()
    edited = base.replaced(
        [
            dataclasses.replace(base.lanes[100], left_boundary=line("0,3.5 20,3.53")),
            dataclasses.replace(base.lanes[1], left_boundary=line("20,3.53 60,3.5")),
        ]
    )
    assert restore(base, edited) == base


def test_where_a_changed_lane_meets_an_unchanged_one_both_return_to_the_joint():
    #  100 unchanged ──┤ 3 cm ├── 1 swings out by 1 m
    base = street()
    edited = base.replaced(
        [
            dataclasses.replace(base.lanes[100], left_boundary=line("0,3.5 20,3.53")),
            dataclasses.replace(base.lanes[1], left_boundary=line("20,3.53 40,4.5 60,3.5")),
        ]
    )
    restored = restore(base, edited)
    assert restored.lanes[100] == base.lanes[100]
    assert restored.lanes[1].left_boundary == line("20,3.5 40,4.5 60,3.5")


def test_a_joint_between_changed_lanes_keeps_its_new_place():
    base = street()
    edited = base.replaced(
        [
            dataclasses.replace(base.lanes[100], left_boundary=line("0,4.5 20,3.53")),
            dataclasses.replace(base.lanes[1], left_boundary=line("20,3.53 40,4.5 60,3.5")),
        ]
    )
    assert restore(base, edited) == edited


def test_the_new_lane_beside_a_restored_boundary_follows_it():
    #  1 above, its lower boundary nudged by 2 cm; 9 drawn below shares the nudged line
    base = world(straight(1, 0, 60, 0, 3.5))
    nudged = "0,0.02 60,0.02"
    edited = world(
        dataclasses.replace(base.lanes[1], right_boundary=line(nudged), right_neighbor_id=9),
        dataclasses.replace(straight(9, 0, 60, -3.5, 0), left_boundary=line(nudged), left_neighbor_id=1),
    )
    restored = restore(base, edited)
    assert restored.lanes[1].right_boundary == base.lanes[1].right_boundary
    assert restored.lanes[9].left_boundary == base.lanes[1].right_boundary
    assert restored.lanes[1].right_neighbor_id == 9


def test_heights_link_order_and_edge_order_do_not_count():
    base = world(
        straight(1, 0, 20, successors=(2, 3)),
        straight(2, 20, 40, predecessors=(1,)),
        straight(3, 20, 40, predecessors=(1,)),
        crossing(5, 30),
    )
    lifted = tuple((x, y, z + 1) for x, y, z in base.lanes[2].left_boundary)
    turned = dataclasses.replace(base.crossings[5], edge1=base.crossings[5].edge2[::-1], edge2=base.crossings[5].edge1)
    edited = base.replaced(
        [
            dataclasses.replace(base.lanes[1], successors=(3, 2)),
            dataclasses.replace(base.lanes[2], left_boundary=lifted),
            dataclasses.replace(base.lanes[3], predecessors=()),
            turned,
        ]
    )
    assert restore(base, edited) == base


def test_what_moved_stays_moved():
    case = scenario("widened_right")
    assert restore(case.base, case.edited) == case.edited


@pytest.mark.shared
@pytest.mark.skipif(not REAL_MAPS, reason=REAL_MAPS_MISSING)
def test_a_tiny_shift_of_a_whole_real_map_is_no_change():
    base = real_map(REAL_MAPS[0])
    shifted = base.replaced(
        dataclasses.replace(
            lane,
            left_boundary=tuple((x + 0.02, y, z) for x, y, z in lane.left_boundary),
            right_boundary=tuple((x + 0.02, y, z) for x, y, z in lane.right_boundary),
        )
        for lane in base.lanes.values()
    )
    assert diff(base, shifted).changes == ()
    assert restore(base, shifted) == base
