"""Linked lanes whose ends do not meet."""

from __future__ import annotations

import dataclasses

import pytest
from tests.core.findings import introduced, mended, only
from tests.core.worlds import lane, line, scenario, straight, street, world

from lanewright.core.edits import apply_edits
from lanewright.core.rules import check

CODE = "link.gap"


def test_clean_a_gap_below_a_centimetre():
    base = street()
    edited = base.replaced([dataclasses.replace(base.lanes[1], left_boundary=line("20.009,3.5 60,3.5"))])
    assert introduced(base, edited) == []


def test_broken_an_end_dragged_off_is_moved_back():
    #  100 ──╴ ╶── 1 ── 200
    base = street()
    edited = base.replaced([dataclasses.replace(base.lanes[1], left_boundary=line("21,3.5 60,3.5"))])
    violation = only(base, edited, CODE)
    assert violation.elements == (1, 100)
    assert "1.00 m apart" in violation.message
    assert mended(base, edited, CODE) == base


def test_edge_a_gap_of_the_base_is_inherited_until_its_line_is_edited():
    case = scenario("joint_link_removed")
    inherited = [one for one in check(case.base, case.edited) if one.code == CODE]
    assert [one.inherited for one in inherited] == [True]
    assert not inherited[0].blocks


def gapping(base, key, **lines):
    """The gap where a lane's lines were redrawn, and the map after its fix."""
    edited = base.replaced([dataclasses.replace(base.lanes[key], **lines)])
    return only(base, edited, CODE), mended(base, edited, CODE)


@pytest.mark.parametrize(
    ("key", "lines", "pair"),
    [
        (1, {"right_boundary": line("20,0.5 60,0")}, (1, 100)),
        (1, {"left_boundary": line("20,3.5 60,3"), "right_boundary": line("20,0 60,-0.5")}, (1, 200)),
        (100, {"left_boundary": line("0,3.5 19,3.5")}, (1, 100)),
        (200, {"left_boundary": line("60,3.2 80,3.5")}, (1, 200)),
    ],
)
def test_broken_whichever_end_was_dragged_off_goes_back(key, lines, pair):
    violation, after = gapping(street(), key, **lines)
    assert violation.elements == pair
    assert after == street()
    assert violation.fixes[0].title.startswith(f"Move the end of lane {key} onto")


def test_broken_the_wider_of_both_sides_is_told():
    violation, _ = gapping(street(), 1, left_boundary=line("20,4 60,3.5"), right_boundary=line("20,-1 60,0"))
    assert "1.00 m apart" in violation.message


def test_broken_a_lane_moved_as_a_whole_gaps_at_both_ends():
    base = street()
    moved = dataclasses.replace(base.lanes[1], left_boundary=line("20,5 60,5"), right_boundary=line("20,1.5 60,1.5"))
    found = [one for one in check(base, base.replaced([moved])) if not one.inherited]
    assert [(one.code, one.elements) for one in found] == [(CODE, (1, 100)), (CODE, (1, 200))]
    assert apply_edits(base.replaced([moved]), found[0].fixes[0].edits).lanes[1].left_boundary[0] == (20, 3.5, 0)


def test_broken_lanes_beside_the_end_go_along():
    #  1 ═ 2 side by side, 3 ═ 4 ahead of them: the joint they share is dragged off in 1 and 2
    base = world(
        straight(1, 0, 20, 3.5, 7, successors=(3,), right_neighbor_id=2),
        straight(2, 0, 20, 0, 3.5, successors=(4,), left_neighbor_id=1),
        straight(3, 20, 40, 3.5, 7, right_neighbor_id=4),
        straight(4, 20, 40, 0, 3.5, left_neighbor_id=3),
    )
    shared = line("0,3.5 19,4")
    edited = base.replaced(
        [
            dataclasses.replace(base.lanes[1], right_boundary=shared),
            dataclasses.replace(base.lanes[2], left_boundary=shared),
        ]
    )
    found = [one for one in check(base, edited) if not one.inherited]
    assert [(one.code, one.elements) for one in found] == [(CODE, (1, 3)), (CODE, (2, 4))]
    for one in found:
        assert apply_edits(edited, one.fixes[0].edits) == base


def test_broken_a_new_lane_is_stretched_to_the_lane_it_leads_to():
    base = street()
    new = straight(9, 82, 100, predecessors=(200,))
    edited = base.replaced([new, dataclasses.replace(base.lanes[200], successors=(9,))])
    assert only(base, edited, CODE).elements == (9, 200)
    after = mended(base, edited, CODE)
    assert after.lanes[9].left_boundary == line("80,3.5 100,3.5")
    assert after.lanes[200].left_boundary == base.lanes[200].left_boundary


def test_broken_an_end_moved_onto_its_next_point_leaves_no_point_twice():
    base = street()
    edited = base.replaced([dataclasses.replace(base.lanes[1], left_boundary=line("25,3.5 20,3.5 60,3.5"))])
    gap = next(one for one in check(base, edited) if one.code == CODE)
    assert apply_edits(edited, gap.fixes[0].edits) == base


def test_edge_a_gap_is_measured_along_both_axes():
    base = street()
    for start in ("20.02,3.5", "20,3.52", "19.98,3.5"):
        edited = base.replaced([dataclasses.replace(base.lanes[1], left_boundary=line(f"{start} 60,3.5"))])
        assert introduced(base, edited) == [(CODE, (1, 100))]


def test_edge_each_side_of_an_old_gap_is_judged_by_itself():
    #  100 ╴╶ 1: the left sides gape in the base already
    base = street().replaced([dataclasses.replace(street().lanes[1], left_boundary=line("21,3.5 60,3.5"))])
    right = dataclasses.replace(base.lanes[1], right_boundary=line("21,0 60,0"))
    bent = dataclasses.replace(base.lanes[1], right_boundary=line("20,0 40,-0.5 60,0"))
    assert introduced(base, base) == []
    assert introduced(base, base.replaced([right])) == [(CODE, (1, 100))]
    assert introduced(base, base.replaced([bent])) == []


def test_edge_lines_that_cannot_be_read_have_no_gap():
    base = street()
    edited = base.replaced([dataclasses.replace(base.lanes[1], left_boundary=())])
    assert introduced(base, edited) == [("geometry.invalid", (1,))]


def test_clean_a_gap_below_a_centimetre_is_not_even_inherited():
    base = street().replaced([dataclasses.replace(street().lanes[1], left_boundary=line("20.006,3.506 60,3.5"))])
    assert check(base, base) == ()


def test_broken_the_last_of_several_points_is_moved():
    bent = dataclasses.replace(street().lanes[100], left_boundary=line("0,3.5 5,3.6 10,3.4 20,3.5"))
    base = street().replaced([bent])
    dragged = dataclasses.replace(bent, left_boundary=line("0,3.5 5,3.6 10,3.4 19,3.5"))
    violation = only(base, base.replaced([dragged]), CODE)
    assert mended(base, base.replaced([dragged]), CODE) == base
    assert [edit.id for edit in violation.fixes[0].edits] == [100]


def test_broken_ends_side_by_side_are_not_pinched_together():
    case = scenario("joint_link_removed")
    (gap,) = [one for one in check(case.base, case.edited) if one.code == CODE]
    assert gap.fixes[0].title.startswith("Take out the link from lane 2 to lane 3")
    after = apply_edits(case.edited, gap.fixes[0].edits)
    assert introduced(case.base, after) == []
    assert {lane.left_boundary for lane in after.lanes.values()} == {
        lane.left_boundary for lane in case.edited.lanes.values()
    }


def test_broken_an_end_dragged_off_further_than_a_lane_is_wide_goes_back():
    violation, after = gapping(street(), 1, left_boundary=line("25,3.5 60,3.5"), right_boundary=line("25,0 60,0"))
    assert violation.fixes[0].title == "Move the end of lane 1 onto lane 100"
    assert after == street()


@pytest.mark.parametrize("elsewhere", [{}, {"successors": (5,)}])
def test_broken_where_no_end_can_be_moved_the_link_goes(elsewhere):
    #  9 ──   100 ── 1 ── 200, and 200 leads to 9, far behind it: stretched there, either lane would lie on its back
    base = street()
    edited = base.replaced(
        [
            straight(9, -90, -70, predecessors=(200,), **elsewhere),
            dataclasses.replace(base.lanes[200], successors=(9,)),
        ]
    )
    gap = next(one for one in check(base, edited) if one.code == CODE)
    assert [fix.title for fix in gap.fixes] == ["Take out the link from lane 200 to lane 9"]
    after = apply_edits(edited, gap.fixes[0].edits)
    assert (after.lanes[200].successors, after.lanes[9].predecessors) == ((), ())


def test_broken_a_ring_that_does_not_close():
    #  one lane round a roundabout: its end was dragged off its own start
    def ring(tip):
        left, right = f"2,0 0,2 -2,0 0,-2 {tip}", "6,0 0,6 -6,0 0,-6 6,0"
        return world(lane(1, left, right, successors=(1,), predecessors=(1,)))

    assert only(ring("2,0"), ring("2,-0.5"), CODE).elements == (1,)
    after = mended(ring("2,0"), ring("2,-0.5"), CODE)
    assert after.lanes[1].left_boundary[0] == after.lanes[1].left_boundary[-1]
