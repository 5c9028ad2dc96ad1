"""A link written on one side, in a map that writes all of them on both."""

from __future__ import annotations

import dataclasses
from typing import Any

from tests.core.findings import introduced, mended, only
from tests.core.worlds import lane, straight, street, world

from lanewright.core.edits import apply_edits
from lanewright.core.elements import LaneType
from lanewright.core.rules import check
from lanewright.core.rules.link_one_sided import with_links_completed

CODE = "link.one_sided"
TURN: dict[str, Any] = {"is_intersection": True}
"""Of new lanes in series, so that they are not one lane."""


def test_clean_in_a_map_that_is_one_sided_anyway():
    base = world(straight(1, 0, 20, successors=(2,)), straight(2, 20, 40))
    edited = world(*base, straight(3, 0, 20, 20, 23.5, successors=(4,)), straight(4, 20, 40, 20, 23.5, **TURN))
    assert introduced(base, edited) == []


def test_broken_a_complete_map_loses_one_side():
    #  1 ──> 200, but 200 does not say so
    base = street()
    edited = base.replaced([dataclasses.replace(base.lanes[200], predecessors=())])
    assert only(base, edited, CODE).elements == (1, 200)
    assert mended(base, edited, CODE) == base


def test_edge_links_over_the_rim_have_one_side_only():
    base = street()
    edited = base.replaced([dataclasses.replace(base.lanes[200], successors=(777,))])
    assert [code for code, _ in introduced(base, edited)] == ["link.dangling"]


def test_broken_either_side_may_be_the_silent_one():
    base = street()
    edited = base.replaced([dataclasses.replace(base.lanes[1], successors=(), predecessors=())])
    assert introduced(base, edited) == [(CODE, (1, 100)), (CODE, (1, 200))]
    found = check(base, edited)
    assert apply_edits(edited, found[0].fixes[0].edits) == base
    assert [one.message.split("only ")[1] for one in found] == [
        "lane 100 says so: name it in lane 1 too.",
        "lane 200 says so: name it in lane 1 too.",
    ]


def test_broken_a_new_lane_that_its_neighbours_in_series_do_not_name():
    #  200 ── 9, and only 9 says so; 9 ── 10, and only 9 says so
    base = street()
    new = [
        straight(9, 80, 90, predecessors=(200,), successors=(10,), lane_type=LaneType.BUS),
        straight(10, 90, 99, **TURN),
    ]
    edited = base.replaced(new)
    assert introduced(base, edited) == [(CODE, (9, 10)), (CODE, (9, 200))]
    after = apply_edits(edited, check(base, edited)[0].fixes[0].edits)
    assert introduced(base, after) == []
    assert after.lanes[200].successors == (9,)
    assert after.lanes[10].predecessors == (9,)


def test_edge_links_already_written_are_kept_by_the_fix():
    #  1 ─┬─ 200
    #     └─ 9       9 names 1, but 1 does not name 9
    base = street()
    edited = base.replaced([straight(9, 60, 80, 3.5, 7, predecessors=(1,))])
    completed = with_links_completed(base, edited)
    assert completed.lanes[1].successors == (200, 9)
    assert completed.lanes[200] is edited.lanes[200]
    assert with_links_completed(base, base) is base
    one_sided = base.replaced([dataclasses.replace(base.lanes[200], predecessors=())])
    assert with_links_completed(one_sided, edited) is edited


def test_edge_a_lane_that_leads_into_itself_counts_too():
    base = street()
    ring = lane(9, "2,50 0,52 -2,50 0,48 2,50", "6,50 0,56 -6,50 0,44 6,50", successors=(9,))
    edited = base.replaced([ring])
    assert introduced(base, edited) == [(CODE, (9,))]
    assert with_links_completed(base, edited).lanes[9].predecessors == (9,)


def test_broken_a_lane_that_two_lead_to_names_both():
    base = street()
    edited = base.replaced(
        [
            straight(8, 20, 60, 3.5, 7, successors=(10,)),
            straight(9, 20, 60, -3.5, 0, successors=(10,)),
            straight(10, 60, 80, 3.5, 7),
        ]
    )
    assert with_links_completed(base, edited).lanes[10].predecessors == (8, 9)
