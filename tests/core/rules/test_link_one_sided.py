"""A link written on one side, in a map that writes all of them on both."""

from __future__ import annotations

import dataclasses

from tests.core.findings import introduced, mended, only
from tests.core.worlds import straight, street, world

CODE = "link.one_sided"


def test_clean_in_a_map_that_is_one_sided_anyway():
    base = world(straight(1, 0, 20, successors=(2,)), straight(2, 20, 40))
    edited = world(*base, straight(3, 0, 20, 20, 23.5, successors=(4,)), straight(4, 20, 40, 20, 23.5))
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
