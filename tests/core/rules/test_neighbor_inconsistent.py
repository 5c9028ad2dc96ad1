"""Neighbours that do not agree on their shared line."""

from __future__ import annotations

import dataclasses

from tests.core.findings import introduced, mended, only
from tests.core.worlds import lane, line, straight, world

from lanewright.core.elements import Mark
from lanewright.core.rules import check

CODE = "neighbor.inconsistent"


def pair(**right):
    """::

    ┆ 1 ┆ 2 ┆   sharing y = 3.5
    """
    return world(
        straight(1, 0, 60, 3.5, 7, right_neighbor_id=2, right_mark=Mark.SOLID_DASH_WHITE),
        straight(2, 0, 60, 0, 3.5, left_neighbor_id=1, left_mark=Mark.DASH_SOLID_WHITE, **right),
    )


def test_clean_mixed_marks_read_mirrored():
    assert check(world(), pair()) == ()


def test_clean_oncoming_lanes_are_left_of_each_other():
    #  1 ──>
    #  <── 2    sharing the centre line, reversed
    one = lane(1, "0,0 60,0", "0,-3.5 60,-3.5", left_neighbor_id=2)
    two = lane(2, "60,0 0,0", "60,3.5 0,3.5", left_neighbor_id=1)
    assert check(world(), world(one, two)) == ()


def test_broken_the_shared_line_moves_in_one_lane_only():
    base = pair()
    edited = base.replaced([dataclasses.replace(base.lanes[1], right_boundary=line("0,3.5 30,4 60,3.5"))])
    assert "shared line differs" in only(base, edited, CODE).message
    after = mended(base, edited, CODE)
    assert after.lanes[2].left_boundary == line("0,3.5 30,4 60,3.5")


def test_broken_the_shared_line_is_repainted_in_one_lane_only():
    base = pair()
    edited = base.replaced([dataclasses.replace(base.lanes[2], left_mark=Mark.SOLID_WHITE)])
    assert "mark on their shared line" in only(base, edited, CODE).message
    assert mended(base, edited, CODE).lanes[1].right_mark is Mark.SOLID_WHITE


def test_broken_a_neighbour_that_does_not_answer():
    base = pair()
    edited = base.replaced([dataclasses.replace(base.lanes[2], left_neighbor_id=None)])
    assert only(base, edited, CODE).elements == (1, 2)
    assert mended(base, edited, CODE) == base


def test_edge_inherited_until_it_is_edited():
    base = pair()
    broken = base.replaced([dataclasses.replace(base.lanes[2], left_mark=Mark.NONE)])
    elsewhere = broken.replaced([dataclasses.replace(broken.lanes[2], right_mark=Mark.SOLID_WHITE)])
    assert [one.inherited for one in check(broken, elsewhere)] == [True]
    assert introduced(broken, elsewhere) == []
