"""The canonical form of updates in which a rule of identity was broken (spec §6.3)."""

from __future__ import annotations

from tests.core.worlds import lane, straight, world

from lanewright.core.canonical import canonicalise
from lanewright.core.diff import diff
from lanewright.core.elements import Mark

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
