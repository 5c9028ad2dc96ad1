"""Ids, links and neighbours when lanes are renamed, joined, exchanged, parted and taken out."""

from __future__ import annotations

import dataclasses

import pytest
from tests.core.worlds import crossing, lane, line, straight, street, world

from lanewright.core.elements import ElementKey, ElementKind, LaneType, Mark
from lanewright.core.identity import (
    fresh_id,
    joinable,
    joined,
    renamed,
    unlinked,
    with_lanes_exchanged,
    with_neighbors_found,
    without_link,
)


def neighbors(lanes):
    return {key: (one.left_neighbor_id, one.right_neighbor_id) for key, one in lanes.items()}


def found(*lanes, loose=None):
    by_id = {one.id: one for one in lanes}
    return neighbors(with_neighbors_found(by_id, by_id if loose is None else loose))


def test_lanes_that_share_a_line_are_neighbours():
    #  ┆ 1 ┆ 2 ┆ 3 ┆
    one, two, three = (straight(key, 0, 60, 3.5 * (3 - key), 3.5 * (4 - key)) for key in (1, 2, 3))
    assert found(one, two, three) == {1: (None, 2), 2: (1, 3), 3: (2, None)}
    assert found(one, two, three, loose=[3]) == {1: (None, None), 2: (None, 3), 3: (2, None)}


def test_oncoming_lanes_that_share_a_line_are_left_of_each_other():
    #  1 ──>
    #  <── 2    the centre line, reversed
    one = lane(1, "0,0 30,0 60,0", "0,-3.5 60,-3.5")
    two = lane(2, "60,0 30,0 0,0", "60,3.5 0,3.5")
    assert found(one, two) == {1: (2, None), 2: (1, None)}


def test_lanes_that_lie_on_each_other_are_no_neighbours():
    assert found(straight(1, 0, 60), straight(2, 0, 60)) == {1: (None, None), 2: (None, None)}
    oncoming = lane(2, "60,0 0,0", "60,3.5 0,3.5")
    assert found(straight(1, 0, 60), oncoming) == {1: (None, None), 2: (None, None)}


def test_a_line_is_shared_whatever_its_height():
    high = dataclasses.replace(straight(1, 0, 60, 3.5, 7), right_boundary=line("0,3.5 60,3.5", z=2.0))
    assert found(high, straight(2, 0, 60, 0, 3.5)) == {1: (None, 2), 2: (1, None)}


def test_who_has_a_neighbour_keeps_it():
    #  1 ┆ 2 and 1 ┆ 3 share the line; 1 and 2 name each other already
    one = straight(1, 0, 60, 3.5, 7, right_neighbor_id=2)
    two, three = straight(2, 0, 60, 0, 3.5, left_neighbor_id=1), straight(3, 0, 60, 1, 3.5)
    assert found(one, two, three, loose=[3]) == {1: (None, 2), 2: (1, None), 3: (None, None)}
    beyond = dataclasses.replace(one, right_neighbor_id=777)
    assert found(beyond, three) == {1: (None, 777), 3: (None, None)}


def test_of_several_beside_it_the_smallest_id_is_the_neighbour():
    three = straight(3, 0, 60, 3.5, 7)
    assert found(three, straight(2, 0, 60, 1, 3.5), straight(1, 0, 60, 0, 3.5)) == {
        3: (None, 1),
        2: (None, None),
        1: (3, None),
    }


def test_joined_lanes_run_on_under_the_first_id():
    one = straight(1, 0, 20, predecessors=(100,), successors=(2,), left_neighbor_id=7, right_neighbor_id=8)
    two = straight(2, 20, 60, predecessors=(1,), successors=(200,), left_neighbor_id=7)
    whole = joined([one, two])
    assert (whole.id, whole.predecessors, whole.successors) == (1, (100,), (200,))
    assert (whole.left_boundary, whole.right_boundary) == (line("0,3.5 20,3.5 60,3.5"), line("0,0 20,0 60,0"))
    assert (whole.left_neighbor_id, whole.right_neighbor_id) == (7, None)


def test_joined_lanes_that_do_not_meet_keep_both_points():
    apart = joined([straight(1, 0, 20), straight(2, 21, 60)])
    assert apart.left_boundary == line("0,3.5 20,3.5 21,3.5 60,3.5")


@pytest.mark.parametrize(
    "difference",
    [
        {"left_mark": Mark.SOLID_WHITE},
        {"right_mark": Mark.SOLID_WHITE},
        {"lane_type": LaneType.BIKE},
        {"is_intersection": True},
    ],
)
def test_lanes_in_series_are_one_where_nothing_differs(difference):
    assert joinable(straight(1, 0, 20), straight(2, 20, 60))
    assert not joinable(straight(1, 0, 20), straight(2, 20, 60, **difference))
    assert joinable(straight(1, 0, 20, **difference), straight(2, 20, 60, **difference))


def test_a_lane_exchanged_for_two_hands_on_its_links_and_neighbours():
    #  100 ── 1 ── 200, 5 beside 1   =>   100 ── 8 ── 9 ── 200, 6 and 7 are beside the halves
    base = street().replaced([dataclasses.replace(street().lanes[1], right_neighbor_id=5)])
    base = base.replaced(
        [
            straight(5, 20, 60, -3.5, 0, left_neighbor_id=1),
            straight(6, 20, 40, 3.5, 7),
            straight(7, 20, 40, -7, -3.5),
            crossing(50, 30),
        ]
    )
    edited = with_lanes_exchanged(base, [1], [straight(8, 20, 40), straight(9, 40, 60)])
    assert {key: (one.predecessors, one.successors) for key, one in edited.lanes.items() if key not in (5, 6, 7)} == {
        8: ((100,), (9,)),
        9: ((8,), (200,)),
        100: ((), (8,)),
        200: ((9,), ()),
    }
    assert neighbors(edited.lanes) == {
        5: (None, None),
        6: (None, 8),
        7: (None, None),
        8: (6, None),
        9: (None, None),
        100: (None, None),
        200: (None, None),
    }
    assert edited.crossings == base.crossings


def test_two_lanes_exchanged_for_one_leave_no_trace():
    edited = with_lanes_exchanged(street(), [1, 200], [straight(9, 20, 80)])
    assert {key: (one.predecessors, one.successors) for key, one in edited.lanes.items()} == {
        9: ((100,), ()),
        100: ((), (9,)),
    }


def test_a_ring_stays_a_ring():
    ring = straight(1, 0, 20, successors=(1, 777), predecessors=(1,))
    edited = with_lanes_exchanged(world(ring), [1], [straight(8, 0, 10), straight(9, 10, 20)])
    assert {key: (one.predecessors, one.successors) for key, one in edited.lanes.items()} == {
        8: ((9,), (9,)),
        9: ((8,), (8, 777)),
    }


def test_renaming_follows_links_neighbours_and_crossings():
    base = street().replaced(
        [
            dataclasses.replace(street().lanes[1], left_neighbor_id=100, right_neighbor_id=200),
            crossing(1, 30),
            crossing(2, 50),
        ]
    )
    edited = renamed(base, {100: 7, 200: 8}, {1: 9})
    assert edited.lanes[1].predecessors == (7,)
    assert edited.lanes[1].successors == (8,)
    assert neighbors(edited.lanes)[1] == (7, 8)
    assert {key: one.edge1 for key, one in edited.crossings.items()} == {
        2: base.crossings[2].edge1,
        9: base.crossings[1].edge1,
    }
    assert sorted(edited.lanes) == [1, 7, 8]
    assert renamed(base, {}, {1: 9}).lanes == base.lanes
    assert renamed(base, {}, {}) is base


def test_ids_exchanged_all_at_once():
    edited = renamed(street(), {1: 200, 200: 1})
    assert edited.lanes[100].successors == (200,)
    assert edited.lanes[200].successors == (1,)


def test_two_links_that_become_one_are_written_once():
    base = world(straight(1, 0, 20, successors=(2, 3)), straight(2, 20, 40), straight(3, 20, 40))
    assert renamed(unlinked(base, [2]).replaced([base.lanes[1]]), {3: 2}).lanes[1].successors == (2,)


def test_whoever_named_what_went_names_it_no_more():
    base = street().replaced(
        [
            dataclasses.replace(street().lanes[100], left_neighbor_id=1, right_neighbor_id=5),
            dataclasses.replace(street().lanes[200], left_neighbor_id=5, right_neighbor_id=1),
            crossing(1, 30),
            crossing(2, 50),
        ]
    )
    edited = unlinked(base, [1], [2])
    assert edited.lanes[100].successors == edited.lanes[200].predecessors == ()
    assert neighbors(edited.lanes) == {100: (None, 5), 200: (5, None)}
    assert list(edited.crossings) == [1]


@pytest.mark.parametrize(
    ("upstream", "downstream"),
    [({"successors": (2, 3)}, {}), ({}, {"predecessors": (1, 3)}), ({"successors": (2, 3)}, {"predecessors": (1, 3)})],
)
def test_a_link_taken_out_leaves_the_others(upstream, downstream):
    lanes = {1: straight(1, 0, 20, **upstream), 2: straight(2, 20, 40, **downstream), 3: straight(3, 20, 40)}
    changed = {one.id: one for one in without_link(lanes, (1, 2))}
    assert {key: one.successors + one.predecessors for key, one in changed.items()} == {
        key: (3,) for key, given in ((1, upstream), (2, downstream)) if given
    }


def test_a_lane_linked_to_itself_is_opened_on_both_sides():
    ring = straight(1, 0, 20, successors=(1,), predecessors=(1,))
    (opened,) = without_link({1: ring}, (1, 1))
    assert (opened.successors, opened.predecessors) == ((), ())


@pytest.mark.parametrize(
    "state",
    [
        world(straight(9, 0, 20)),
        world(straight(1, 0, 20, successors=(9,))),
        world(straight(1, 0, 20, predecessors=(9,))),
        world(straight(1, 0, 20, left_neighbor_id=9)),
        world(straight(1, 0, 20, right_neighbor_id=9)),
        world(crossing(9, 30)),
    ],
)
def test_a_new_id_is_above_all_that_a_map_has_or_names(state):
    assert fresh_id([state]) == 10
    assert fresh_id([world(straight(2, 0, 20)), state]) == 10
    assert fresh_id([state], [ElementKey(ElementKind.LANE_SEGMENT, 20)]) == 21


def test_the_first_id_of_an_empty_map():
    assert fresh_id([world()]) == 1


def test_a_lane_exchanged_for_three_is_linked_in_their_order():
    pieces = [straight(7, 20, 30), straight(8, 30, 50), straight(9, 50, 60)]
    base = street().replaced([dataclasses.replace(street().lanes[200], predecessors=(777, 1))])
    edited = with_lanes_exchanged(base, [1], pieces)
    assert {key: (edited.lanes[key].predecessors, edited.lanes[key].successors) for key in (7, 8, 9, 200)} == {
        7: ((100,), (8,)),
        8: ((7,), (9,)),
        9: ((8,), (200,)),
        200: ((777, 9), ()),
    }


def test_a_neighbour_on_one_side_does_not_hinder_the_other():
    #  777 ┆ 1 ┆ 2 ┆
    one, two = straight(1, 0, 60, 3.5, 7, left_neighbor_id=777), straight(2, 0, 60, 0, 3.5)
    assert found(one, two, loose=[1]) == {1: (777, 2), 2: (1, None)}
