"""The canonical form of updates in which a rule of identity was broken (spec §6.3)."""

from __future__ import annotations

import pytest
from tests.core.worlds import lane, straight, world

from lanewright.core.canonical import canonical_map, canonicalise
from lanewright.core.comparison import Comparison
from lanewright.core.diff import diff
from lanewright.core.edits import apply_edits
from lanewright.core.elements import MapState, Mark
from lanewright.core.identity import unlinked
from lanewright.core.rules import check

SOLID = {"left_mark": Mark.SOLID_WHITE, "right_mark": Mark.SOLID_WHITE}


def test_a_link_that_goes_beside_a_short_lane_replaces_one_lane():
    #        ┌ 2               ┌ 2
    #  1 (1 m)      =>   1 ────┘        the joint's left end moved by 0.8 m as well
    #        └ 3                 3
    base = world(
        straight(1, 0, 1.1, successors=(2, 3), **SOLID),
        lane(2, "1.1,3.5 8,4 14,8", "1.1,0 10,0.5 17,5", is_intersection=True),
        lane(3, "1.1,3.5 31,3.5", "1.1,0 31,0", is_intersection=True),
    )
    edited = world(
        lane(1, "0,3.5 0.4,3.8", "0,0 1.1,0", successors=(2,), **SOLID),
        lane(2, "0.4,3.8 8,4 14,8", "1.1,0 10,0.5 17,5", is_intersection=True),
        lane(3, "0.4,3.8 31,3.5", "1.1,0 31,0", is_intersection=True),
    )
    canonical = canonicalise(base, edited)
    assert canonicalise(base, canonical) == canonical
    assert sorted(change.categories for change in diff(base, canonical).changes) == [
        ("deletion",),
        ("geometry",),
        ("geometry",),
        ("insertion",),
    ]


#  1 ── 2        nothing joins 2 at its finish
ROW = world(straight(1, 0, 20, successors=(2,)), straight(2, 20, 40, predecessors=(1,)))


def story(base, edited):
    """What changed, new elements by how many."""
    changes = [
        (change.id if change.key in base else "new", *change.categories) for change in diff(base, edited).changes
    ]
    return sorted(changes, key=str)


@pytest.mark.parametrize("finish", [30, 44, 200])
def test_a_lane_drawn_anew_is_the_old_one_longer_or_shorter_at_its_loose_end(finish):
    edited = world(straight(1, 0, 20, successors=(9,)), straight(9, 20, finish, predecessors=(1,)))
    assert story(ROW, canonicalise(ROW, edited)) == [(2, "geometry")]


def test_a_lane_drawn_the_other_way_round_is_another():
    base = world(straight(2, 20, 40))
    turned = world(lane(2, "40,0 20,0", "40,3.5 20,3.5"))
    assert story(base, canonicalise(base, turned)) == [("new", "insertion"), (2, "deletion")]


def test_a_lane_that_goes_on_beyond_a_loose_end_to_a_new_junction_is_new_from_there_on():
    #  1 ── 2   3 ──      =>   1 ── 9 ── 3      9 drawn in the place of 2 and of the gap
    base = world(*ROW, straight(3, 60, 80))
    drawn = world(
        straight(1, 0, 20, successors=(9,)),
        straight(9, 20, 60, predecessors=(1,), successors=(3,)),
        straight(3, 60, 80, predecessors=(9,)),
    )
    canonical = canonicalise(base, drawn)
    assert story(base, canonical) == [("new", "insertion")]
    assert canonical.lanes[2].left_boundary == base.lanes[2].left_boundary
    assert canonicalise(base, canonical) == canonical


def test_the_same_where_it_begins():
    #  3 ──   1 ── 2      =>   3 ── 9 ── 2
    base = world(straight(3, -60, -20), *ROW)
    drawn = world(
        straight(3, -60, -20, successors=(9,)),
        straight(9, -20, 20, predecessors=(3,), successors=(2,)),
        straight(2, 20, 40, predecessors=(9,)),
    )
    canonical = canonicalise(base, drawn)
    assert story(base, canonical) == [("new", "insertion")]
    assert canonical.lanes[1].left_boundary == base.lanes[1].left_boundary


def test_a_longer_lane_reaches_to_the_next_joint_that_was_drawn():
    #  1 ── 2      =>   1 ── 2 ─── 9      9 inside an intersection, 8 m on
    drawn = world(
        straight(1, 0, 20, successors=(7,)),
        straight(7, 20, 48, predecessors=(1,), successors=(9,)),
        straight(9, 48, 60, predecessors=(7,), is_intersection=True),
    )
    assert story(ROW, canonicalise(ROW, drawn)) == [("new", "insertion"), (2, "geometry")]


def test_of_two_lanes_that_could_be_replaced_the_one_with_fewer_changes_stays():
    #  1 ── 2      =>   1    2      the link goes, and 1 is painted
    painted = world(straight(1, 0, 20, **SOLID), straight(2, 20, 40))
    assert story(ROW, canonicalise(ROW, painted)) == [("new", "insertion"), (1, "deletion")]


def test_of_equal_ones_the_lane_inside_the_intersection_is_replaced():
    turn = {"is_intersection": True}
    base = world(straight(1, 0, 20, successors=(2,), **turn), straight(2, 20, 40, predecessors=(1,)))
    edited = world(straight(1, 0, 20, **turn), straight(2, 20, 40))
    assert story(base, canonicalise(base, edited)) == [("new", "insertion"), (1, "deletion")]
    plain = world(straight(1, 0, 20), straight(2, 20, 40))
    assert story(ROW, canonicalise(ROW, plain)) == [("new", "insertion"), (2, "deletion")]


def test_lanes_drawn_as_one_where_a_branch_went_stay_two():
    #     ┌ 3
    #  1 ─┴ 2      =>   ── 9 ──      1 and 2 keep their joint, although nothing joins there any more
    branch = lane(3, "20,3.5 30,9", "20,0 32,5", predecessors=(1,))
    base = world(straight(1, 0, 20, successors=(2, 3)), straight(2, 20, 40, predecessors=(1,)), branch)
    canonical = canonicalise(base, world(straight(9, 0, 40)))
    assert story(base, canonical) == [(3, "deletion")]
    assert canonical == unlinked(base, [3])


def test_a_joint_where_paint_changes_is_the_nearest_of_the_joints_that_are_near():
    #  1 ─ 2 ── 3 ── 4      =>   8 ──── 9      the paint changes between 2 (2.5 m) and 3, and between 8 and 9
    base = world(
        straight(1, 0, 20, successors=(2,)),
        straight(2, 20, 22.5, successors=(3,), predecessors=(1,)),
        straight(3, 22.5, 40, predecessors=(2,), successors=(4,), **SOLID),
        straight(4, 40, 60, predecessors=(3,), **SOLID),
    )
    drawn = world(straight(8, 0, 22.5, successors=(9,)), straight(9, 22.5, 60, predecessors=(8,), **SOLID))
    assert story(base, canonicalise(base, drawn)) == []


@pytest.mark.parametrize("joint", [38, 42, 50])
def test_a_longer_lane_is_one_story_wherever_it_is_drawn_in_two(joint):
    drawn = world(
        straight(1, 0, 20, successors=(8,)),
        straight(8, 20, joint, predecessors=(1,), successors=(9,)),
        straight(9, joint, 60, predecessors=(8,)),
    )
    assert story(ROW, canonicalise(ROW, drawn)) == [(2, "geometry")]


def test_a_legal_story_stands_where_the_canonical_form_would_be_longer():
    #  7 moved sideways by 5 m, which the rules allow; far away 8 was deleted and drawn anew as 9
    base = world(straight(7, 0, 60), straight(8, 1000, 1060))
    moved = straight(7, 0, 60, 5, 8.5)
    form = canonical_map(Comparison(base, world(moved, straight(9, 1000, 1060))))
    assert form.edited == world(moved, straight(8, 1000, 1060))


def test_a_story_that_a_rule_objects_to_does_not_stand():
    #  7 moved sideways by 20 m
    base, edited = world(straight(7, 0, 60)), world(straight(7, 0, 60, 20, 23.5))
    form = canonical_map(Comparison(base, edited))
    assert story(base, form.edited) == [("new", "insertion"), (7, "deletion")]


#  1 ── 2 ── 3      2 from 50 to 150
LONG = world(
    straight(1, 0, 50, successors=(2,)),
    straight(2, 50, 150, predecessors=(1,), successors=(3,)),
    straight(3, 150, 200, predecessors=(2,)),
)


def painted_half_way(first: int, **fields: int) -> MapState:
    """2 cut at 80 and 120, and painted between; the first part under an id."""
    dashed = {"left_mark": Mark.DASHED_WHITE}
    return world(
        straight(1, 0, 50, successors=(first,)),
        straight(first, 50, 80, predecessors=(1,), successors=(102,), **fields),
        straight(102, 80, 120, predecessors=(first,), successors=(103,), part_of=2, **dashed),
        straight(103, 120, 150, predecessors=(102,), successors=(3,), part_of=2),
        straight(3, 150, 200, predecessors=(103,)),
    )


def test_a_recorded_cut_is_canonical_as_it_is():
    cut = painted_half_way(101, part_of=2)
    form = canonical_map(Comparison(LONG, cut))
    assert form.edited == canonicalise(LONG, cut) == cut
    assert (form.renamed, form.joined, form.cut) == ({}, (), ())


def test_a_part_that_was_drawn_anew_is_a_part_again():
    #  the first part deleted and drawn as 104
    drawn = painted_half_way(104)
    assert canonicalise(LONG, drawn) == painted_half_way(104, part_of=2)
    (violation,) = check(LONG, drawn)
    assert apply_edits(drawn, violation.fixes[0].edits) == painted_half_way(104, part_of=2)
    assert check(LONG, painted_half_way(104, part_of=2)) == ()
