"""Ids that no rule of identity objects to tell the canonical story, or the note says they do not (spec §5, §6.3)."""

from __future__ import annotations

import dataclasses

import pytest
from tests.core.update_machine import told
from tests.core.worlds import crossing, straight, world

from lanewright.core.canonical import canonical_updates, canonicalise
from lanewright.core.comparison import Comparison
from lanewright.core.edits import apply_edits
from lanewright.core.elements import LaneType
from lanewright.core.identity import renamed
from lanewright.core.macros import update_groups
from lanewright.core.rules import check

#  ── 2 ──
#  ── 1 ──    1.5 m apart, nothing holds them
TWO = world(straight(1, 0, 60, 0, 3.5), straight(2, 0, 60, 5, 8.5))
OVERLAPPING = world(crossing(5, 30), crossing(6, 31))
#  1 ── 2
ROW = world(straight(1, 0, 20, successors=(2,)), straight(2, 20, 40, predecessors=(1,)))

CASES = {
    "1 goes, 2 takes its place": (TWO, world(straight(2, 0, 60, 0, 3.5))),
    "2 makes place for 1": (world(straight(2, 0, 60, 0, 3.5)), TWO),
    "lanes exchange their ids": (TWO, world(straight(2, 0, 60, 0, 3.5), straight(1, 0, 60, 5, 8.5))),
    "a crossing takes another's place": (OVERLAPPING, world(crossing(6, 30))),
    "crossings exchange their ids": (OVERLAPPING, world(crossing(6, 30), crossing(5, 31))),
    "the link goes, and the upstream lane is replaced": (ROW, world(straight(9, 0, 20), straight(2, 20, 40))),
    "a new lane is drawn as two": (
        TWO,
        world(*TWO, straight(8, 0, 30, 20, 23.5, successors=(9,)), straight(9, 30, 60, 20, 23.5, predecessors=(8,))),
    ),
    "a lane drawn anew is longer where nothing joins it": (
        ROW,
        world(straight(1, 0, 20, successors=(9,)), straight(9, 20, 90, predecessors=(1,))),
    ),
    "a joint between like lanes moved along": (
        ROW,
        world(straight(1, 0, 22, successors=(2,)), straight(2, 22, 40, predecessors=(1,))),
    ),
    "lanes on the same lines exchange their types": (
        world(straight(1, 0, 60, lane_type=LaneType.BIKE), straight(2, 0, 60)),
        world(straight(2, 0, 60, lane_type=LaneType.BIKE), straight(1, 0, 60)),
    ),
}


@pytest.mark.parametrize("case", CASES)
def test_what_is_not_canonical_is_noted(case):
    base, edited = CASES[case]
    assert told(base, edited) != told(base, canonicalise(base, edited))
    (note,) = check(base, edited)
    assert note.code == "identity.not_canonical"
    assert told(base, apply_edits(edited, note.fixes[0].edits)) == told(base, canonicalise(base, edited))


def test_all_updates_told_anew_at_once_are_the_canonical_form():
    far = [dataclasses.replace(one, id=one.id + 10, **moved(one)) for one in TWO.lanes.values()]
    base = world(*TWO, *far)
    edited = renamed(base, {1: 2, 2: 1, 11: 12, 12: 11})
    comparison = Comparison(base, edited)
    assert len(update_groups(comparison)) == 2
    form = canonical_updates(comparison, update_groups(comparison))
    assert form.edited == base
    assert {key.id: new for key, new in form.renamed.items()} == {1: 2, 2: 1, 11: 12, 12: 11}


def moved(lane):
    """A lane's lines 1 km further east."""
    return {
        side: tuple((x + 1000, y, z) for x, y, z in getattr(lane, side)) for side in ("left_boundary", "right_boundary")
    }
