"""However a road is cut into lanes, its story is the same (spec §2: a cut in series is no change; §6.3)."""

from __future__ import annotations

import pytest
from tests.core.update_machine import same_road
from tests.core.worlds import lane, straight, street, world

from lanewright.core.canonical import canonical_form, canonical_updates, canonicalise, lengthening_updates
from lanewright.core.comparison import Comparison
from lanewright.core.diff import diff
from lanewright.core.edits import apply_edits
from lanewright.core.elements import LaneType, Mark
from lanewright.core.restore import restore
from lanewright.core.rules import check

#  1 (0..20) ── 2 (20..40) ── 3 (40..60)
ROW = world(
    straight(1, 0, 20, successors=(2,)),
    straight(2, 20, 40, predecessors=(1,), successors=(3,)),
    straight(3, 40, 60, predecessors=(2,)),
)


def story(base, edited):
    """What changed, new elements by how many."""
    changes = diff(base, canonicalise(base, edited)).changes
    return sorted(((one.id if one.key in base else "new", *one.categories) for one in changes), key=str)


def test_a_joint_further_along_the_road_is_no_change():
    shifted = world(
        straight(1, 0, 27, successors=(2,)),
        straight(2, 27, 33, predecessors=(1,), successors=(3,)),
        straight(3, 33, 60, predecessors=(2,)),
    )
    assert story(ROW, shifted) == []
    assert restore(ROW, canonicalise(ROW, shifted)) == ROW


def test_a_lane_beyond_a_lost_link_is_known_again_however_it_is_drawn():
    #  1    2 ── 3 (shorter), as two lanes and as one
    two = world(straight(1, 0, 20), straight(2, 20, 40, successors=(3,)), straight(3, 40, 52, predecessors=(2,)))
    one = world(straight(1, 0, 20), straight(9, 20, 52))
    assert story(ROW, two) == story(ROW, one) == [("new", "insertion"), (2, "deletion"), (3, "geometry")]


@pytest.mark.parametrize("joint", [30, 40, 50])
def test_a_widened_row_is_cut_across_from_the_old_joints(joint):
    wider = world(
        straight(1, 0, 20, successors=(8,)),
        straight(8, 20, joint, top=5, predecessors=(1,), successors=(9,)),
        straight(9, joint, 60, top=5, predecessors=(8,)),
    )
    assert story(ROW, wider) == [(2, "geometry"), (3, "geometry")]


def test_a_joint_that_was_drawn_stays_where_the_story_is_the_same():
    drawn = world(
        straight(1, 0, 20, successors=(2,)),
        straight(2, 20, 46, 2, 5.5, predecessors=(1,), successors=(3,)),
        straight(3, 46, 60, 2, 5.5, predecessors=(2,)),
    )
    assert canonicalise(ROW, drawn) is drawn


def test_paint_that_begins_further_on_moves_the_joint():
    #  1 white ── 2 bare, the paint ends at 20; then at 29
    white = {"left_mark": Mark.SOLID_WHITE}
    base = world(straight(1, 0, 20, successors=(2,), **white), straight(2, 20, 40, predecessors=(1,)))
    in_two = world(straight(1, 0, 29, successors=(2,), **white), straight(2, 29, 40, predecessors=(1,)))
    in_three = world(
        straight(1, 0, 20, successors=(9,), **white),
        straight(9, 20, 29, predecessors=(1,), successors=(2,), **white),
        straight(2, 29, 40, predecessors=(9,)),
    )
    assert story(base, in_two) == story(base, in_three) == [(1, "geometry"), (2, "geometry")]


@pytest.mark.parametrize("length", [2, 30])
def test_a_road_driven_on_is_a_longer_lane_in_one_piece_or_two(length):
    whole = ROW.replaced([straight(3, 40, 60 + length, predecessors=(2,))])
    in_two = ROW.replaced(
        [
            straight(3, 40, 60, predecessors=(2,), successors=(9,)),
            straight(9, 60, 60 + length, predecessors=(3,)),
        ]
    )
    assert story(ROW, whole) == story(ROW, in_two) == [(3, "geometry")]
    comparison = Comparison(ROW, in_two)
    assert check(ROW, in_two) == (), "a lane may be put back as it was"
    saved = canonical_updates(comparison, lengthening_updates(comparison))
    assert diff(whole, saved.edited).changes == ()
    assert (saved.edited.lanes.keys(), saved.renamed, saved.joined) == (whole.lanes.keys(), {}, (9,))


def test_a_lane_of_another_kind_driven_on_is_an_insertion():
    bus = straight(9, 60, 90, predecessors=(3,), lane_type=LaneType.BUS)
    drawn = ROW.replaced([straight(3, 40, 60, predecessors=(2,), successors=(9,)), bus])
    assert canonicalise(ROW, drawn) is drawn
    assert lengthening_updates(Comparison(ROW, drawn)) == []


def test_a_lane_that_fills_a_gap_is_an_insertion():
    base = world(straight(1, 0, 20), straight(3, 40, 60))
    filled = world(
        straight(1, 0, 20, successors=(2,)),
        straight(2, 20, 40, predecessors=(1,), successors=(3,)),
        straight(3, 40, 60, predecessors=(2,)),
    )
    in_one = world(straight(9, 0, 60))
    assert story(base, filled) == story(base, in_one) == [("new", "insertion")]


def test_new_lanes_are_cut_where_the_lanes_beside_them_end():
    #  1 ── 2 ── 3 and on their right 7 ── 8 ── 9, drawn as three lanes or as one
    beside = {1: 7, 2: 8, 3: 9}
    old = [
        straight(key, one.left_boundary[0][0], one.left_boundary[-1][0], successors=one.successors,
                 predecessors=one.predecessors, right_neighbor_id=beside[key])
        for key, one in ROW.lanes.items()
    ]  # fmt: skip
    three = world(
        *old,
        straight(7, 0, 20, -3.5, 0, successors=(8,), left_neighbor_id=1),
        straight(8, 20, 40, -3.5, 0, predecessors=(7,), successors=(9,), left_neighbor_id=2),
        straight(9, 40, 60, -3.5, 0, predecessors=(8,), left_neighbor_id=3),
    )
    one = world(*ROW, lane(7, "0,0 20,0 40,0 60,0", "0,-3.5 60,-3.5"))
    assert canonicalise(ROW, three) is three
    canonical = canonicalise(ROW, one)
    assert canonical_form(ROW, one).cut == (7,), "and that is said"
    assert [len(canonical.lanes), *story(ROW, one)] == [6, *story(ROW, three)]
    assert {key: canonical.lanes[key].right_neighbor_id for key in ROW.lanes}.keys() == beside.keys()
    assert all(canonical.lanes[key].right_neighbor_id in canonical.lanes for key in ROW.lanes)


def test_a_lane_between_two_updates_is_one_question():
    #  3 ── 4 ── 5   =>   3   4        5 went, and 3, hardly bent, leads to 4 no more
    base = world(straight(3, 0, 20, successors=(4,)), straight(4, 20, 40, successors=(5,)), straight(5, 40, 60))
    bent = lane(3, "0,3.5 10,3.498 20,3.5", "0,0 20,0")
    edited = world(bent, straight(4, 20, 40))
    (violation,) = check(base, edited)
    assert violation.code == "identity.rerouted"
    assert check(base, canonicalise(base, edited)) == ()


def test_a_fix_keeps_what_else_was_edited():
    #  100 ── 1 ── 200: 100 drawn anew, 200 for buses now
    base = street()
    edited = base.replaced(
        [
            straight(9, 0, 20, successors=(1,)),
            straight(1, 20, 60, predecessors=(9,), successors=(200,)),
            straight(200, 60, 80, lane_type=LaneType.BUS, predecessors=(1,)),
        ],
        [base.lanes[100].key],
    )
    (violation,) = check(base, edited)
    mended = apply_edits(edited, violation.fixes[0].edits)
    assert violation.code == "replacement.unjustified"
    assert [(one.id, *one.categories) for one in diff(base, mended).changes] == [(200, "type")]


def test_lanes_with_a_gap_between_them_are_not_one_road():
    #  1 ── 2   =>   1 ─  8 ── 9        a hole of 4 m after 1
    base = world(straight(1, 0, 20, successors=(2,)), straight(2, 20, 60, predecessors=(1,)))
    edited = world(
        straight(1, 0, 20, successors=(8,)),
        straight(8, 24, 40, predecessors=(1,), successors=(9,)),
        straight(9, 40, 60, predecessors=(8,)),
    )
    canonical = canonicalise(base, edited)
    assert canonical.lanes[2].left_boundary[0] == (24.0, 3.5, 0.0)
    assert story(base, edited) == [(2, "geometry")]


def test_lanes_are_not_joined_where_something_leads_on_beyond_the_rim():
    #  1 ── 999 (beyond the rim)   =>   1 ── 999, 9
    base = world(straight(1, 0, 40, successors=(999,)))
    edited = world(straight(1, 0, 40, successors=(999, 9)), straight(9, 40, 60, predecessors=(1,)))
    assert lengthening_updates(Comparison(base, edited)) == []
    assert canonicalise(base, edited) is edited


def test_a_cut_that_the_base_records_is_looked_at_in_a_map_that_has_the_lane_whole():
    white = {"left_mark": Mark.SOLID_WHITE}
    parts = world(
        straight(11, 0, 20, successors=(12,), part_of=1), straight(12, 20, 60, predecessors=(11,), part_of=1, **white)
    )
    whole = world(straight(1, 0, 60, **white))
    assert same_road(whole, canonicalise(parts, whole))


def test_exchanged_ids_are_not_put_back_because_they_tell_the_same():
    #  1 over 2, both bent, under each other's ids; far away a joint moved along its road
    far = (straight(4, 0, 20, 50, 53.5, successors=(5,)), straight(5, 20, 50, 50, 53.5, predecessors=(4,)))
    base = world(straight(1, 0, 60, 0, 3.5, right_neighbor_id=2), straight(2, 0, 60, -3.5, 0, left_neighbor_id=1), *far)
    edited = world(
        lane(2, "0,4.5 30,6 60,4.5", "0,0.5 30,1 60,0.5", right_neighbor_id=1),
        lane(1, "0,0.5 30,1 60,0.5", "0,-4.5 30,-6 60,-4.5", left_neighbor_id=2),
        straight(4, 0, 30, 50, 53.5, successors=(5,)),
        straight(5, 30, 50, 50, 53.5, predecessors=(4,)),
    )
    form = canonical_form(base, edited)
    assert form.renamed == {edited.lanes[1].key: 2, edited.lanes[2].key: 1}
    assert form.edited.lanes[1].left_boundary == edited.lanes[2].left_boundary
    assert [one.code for one in check(base, form.edited)] == []


def test_one_update_in_canonical_form_leaves_the_others_as_they_were_edited():
    #  2 names 1 as its neighbour, 1 names nobody; 1 is driven on by 9, 2 repainted
    base = world(straight(1, 0, 100), straight(2, 0, 40, -3.5, 0, left_neighbor_id=1))
    edited = world(
        straight(1, 0, 100, successors=(9,)),
        straight(9, 100, 130, predecessors=(1,)),
        straight(2, 0, 40, -3.5, 0, left_neighbor_id=1, right_mark=Mark.SOLID_WHITE),
    )
    comparison = Comparison(base, edited)
    saved = canonical_updates(comparison, lengthening_updates(comparison)).edited
    assert [(one.id, *one.categories) for one in diff(base, saved).changes] == [(1, "geometry"), (2, "marking")]


def test_a_ring_is_cut_where_something_differs_on_it():
    #  a ring of 1 (white), 2 and 3; the joint of 2 and 3 drawn elsewhere
    white = {"left_mark": Mark.SOLID_WHITE}
    first = lane(1, "0,0 10,0", "0,-3 13,-3", successors=(2,), predecessors=(3,), **white)
    base = world(
        first,
        lane(2, "10,0 10,10", "13,-3 13,13", successors=(3,), predecessors=(1,)),
        lane(3, "10,10 0,10 0,0", "13,13 -3,13 0,-3", successors=(1,), predecessors=(2,)),
    )
    edited = world(
        first,
        lane(2, "10,0 10,10 5,10", "13,-3 13,13 5,13", successors=(3,), predecessors=(1,)),
        lane(3, "5,10 0,10 0,0", "5,13 -3,13 0,-3", successors=(1,), predecessors=(2,)),
    )
    assert story(base, edited) == []


def test_a_lane_drawn_anew_in_two_with_a_gap_is_the_part_that_is_nearer():
    #  1   =>   8 ─  9        a hole of 4 m between them
    base = world(straight(1, 0, 25))
    edited = world(straight(8, 0, 21, successors=(9,)), straight(9, 25, 27, predecessors=(8,)))
    assert story(base, edited) == [("new", "insertion"), (1, "geometry")]
    assert canonicalise(base, edited).lanes[1].left_boundary[-1] == (21.0, 3.5, 0.0)


def test_a_joint_that_moved_on_one_side_only_is_one_joint():
    #  1 ── 2 and 1 ── 3: the right corner of their joint 0.5 m further on
    base = world(
        straight(1, 0, 20, successors=(2, 3)),
        straight(2, 20, 60, predecessors=(1,), left_mark=Mark.SOLID_WHITE),
        lane(3, "20,3.5 50,-20", "20,0 47,-22", predecessors=(1,)),
    )
    edited = world(
        lane(1, "0,3.5 20,3.5", "0,0 20.5,0", successors=(2, 3)),
        lane(2, "20,3.5 60,3.5", "20.5,0 60,0", predecessors=(1,), left_mark=Mark.SOLID_WHITE),
        lane(3, "20,3.5 50,-20", "20.5,0 47,-22", predecessors=(1,)),
    )
    assert canonicalise(base, edited) is edited


@pytest.mark.parametrize("key", [1, 9])
def test_a_lane_shortened_where_what_it_led_to_went_is_the_same_lane(key):
    #  1 ── 2 ── 3   =>   1 (4 m shorter)    3
    base = world(
        straight(1, 0, 25, successors=(2,)),
        straight(2, 25, 50, predecessors=(1,), successors=(3,), is_intersection=True),
        straight(3, 50, 75, predecessors=(2,)),
    )
    assert story(base, world(straight(key, 0, 21), straight(3, 50, 75))) == [(1, "geometry"), (2, "deletion")]


def test_a_lane_of_the_same_kind_that_rim_links_set_apart_is_no_part_of_a_cut():
    #  1 leads beyond the rim; its end moves by 0.7 m and it is driven on
    base = world(straight(1, 0, 20, successors=(999,)))
    edited = world(
        lane(1, "0,3.5 20,3.5", "0,0 20.7,0", successors=(999, 9)),
        lane(9, "20,3.5 22,3.5", "20.7,0 22,0", predecessors=(1,)),
    )
    assert canonicalise(base, edited) is edited


@pytest.mark.parametrize("keys", [(2, 3), (8, 9)])
def test_the_first_lane_of_a_row_that_went_takes_no_other_with_it(keys):
    #  1 ── 2 ── 3 ── 4   =>   2 ── 3 ── 4, the joint of 2 and 3 moved a little
    base = world(*ROW.lanes.values(), straight(4, 60, 80, predecessors=(3,), is_intersection=True))
    first, second = keys
    edited = world(
        lane(first, "20,3.5 40.8,3", "20,0 40,0", successors=(second,)),
        lane(second, "40.8,3 60,3.5", "40,0 60,0", predecessors=(first,), successors=(4,)),
        straight(4, 60, 80, predecessors=(second,), is_intersection=True),
    )
    assert story(base, edited) == [(1, "deletion"), (2, "geometry"), (3, "geometry")]
