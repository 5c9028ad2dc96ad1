"""Neighbours that do not agree on their shared line."""

from __future__ import annotations

import dataclasses

import pytest
from tests.core.findings import introduced, mended, only
from tests.core.worlds import lane, line, straight, world

from lanewright.core.elements import LaneType, Mark
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


def oncoming(**second):
    """::

    1 ──>
    <── 2    sharing y = 0, reversed; SOLID_DASH_YELLOW reads from each lane's own side
    """
    one = lane(1, "0,0 60,0", "0,-3.5 60,-3.5", left_neighbor_id=2, left_mark=Mark.SOLID_DASH_YELLOW)
    two = lane(2, "60,0 0,0", "60,3.5 0,3.5", left_mark=Mark.DASH_SOLID_YELLOW, **{"left_neighbor_id": 1} | second)
    return world(one, two)


def changed(base, key, **fields):
    return base.replaced([dataclasses.replace(base.lanes[key], **fields)])


def test_broken_the_shared_line_of_oncoming_lanes_moves_in_one_only():
    base = oncoming()
    edited = changed(base, 1, left_boundary=line("0,0 20,0.5 60,0"))
    assert "shared line differs" in only(base, edited, CODE).message
    assert mended(base, edited, CODE).lanes[2].left_boundary == line("60,0 20,0.5 0,0")
    edited = changed(base, 2, left_boundary=line("60,0 20,-0.5 0,0"))
    assert mended(base, edited, CODE).lanes[1].left_boundary == line("0,0 20,-0.5 60,0")


def test_broken_the_centre_line_is_repainted_in_one_lane_only():
    base = oncoming()
    edited = changed(base, 2, left_mark=Mark.SOLID_DASH_WHITE)
    assert mended(base, edited, CODE).lanes[1].left_mark is Mark.DASH_SOLID_WHITE


def test_broken_an_oncoming_lane_does_not_answer():
    base = oncoming()
    edited = changed(base, 2, left_neighbor_id=None)
    assert only(base, edited, CODE).elements == (1, 2)
    assert mended(base, edited, CODE) == base


def test_broken_a_lane_answers_on_the_wrong_side():
    base = pair()
    edited = changed(base, 2, left_neighbor_id=None, right_neighbor_id=1)
    assert only(base, edited, CODE).elements == (1, 2)
    after = mended(base, edited, CODE)
    assert (after.lanes[1].right_neighbor_id, after.lanes[2].left_neighbor_id) in ((2, 1), (None, None))


def test_broken_a_lane_that_has_another_neighbour_there_is_not_made_to_answer():
    #  1 names 2, but 2 names 3 on that side: 1 and 2 are parted, 2 and 3 stay neighbours
    base = pair().replaced([straight(4, 0, 60, 20, 23.5)])
    edited = changed(base, 4, right_neighbor_id=2)
    assert only(base, edited, CODE).elements == (2, 4)
    assert mended(base, edited, CODE) == base


def test_broken_a_lane_that_is_its_own_neighbour():
    base = world(straight(1, 0, 60))
    edited = changed(base, 1, left_neighbor_id=1)
    assert introduced(base, edited) == [(CODE, (1,))]
    assert mended(base, edited, CODE) == base


def test_edge_neighbours_beyond_the_crop_are_not_asked():
    assert check(world(), world(straight(1, 0, 60, left_neighbor_id=None))) == ()
    base = world(straight(1, 0, 60, left_neighbor_id=777, right_neighbor_id=778))
    assert check(base, base) == ()


@pytest.mark.parametrize(
    ("defect", "edit"),
    [
        ({"left_boundary": line("0,3.5 30,3 60,3.5")}, {"left_mark": Mark.NONE}),
        ({"left_boundary": line("0,3.5 30,3 60,3.5")}, {"left_boundary": line("0,3.5 30,2.9 60,3.5")}),
        ({"left_boundary": line("0,3.5 30,3 60,3.5")}, {"left_neighbor_id": None}),
        ({"left_mark": Mark.NONE}, {"left_mark": Mark.SOLID_WHITE}),
        ({"left_mark": Mark.NONE}, {"left_boundary": line("0,3.5 30,3 60,3.5")}),
        ({"left_neighbor_id": None}, {"left_neighbor_id": 1, "left_mark": Mark.NONE}),
    ],
)
def test_edge_an_old_defect_is_introduced_by_whoever_edits_what_disagrees(defect, edit):
    base = changed(pair(), 2, **defect)
    edited = changed(base, 2, **edit)
    assert [one.inherited for one in check(base, base)] == [True]
    assert introduced(base, edited) == [(CODE, (1, 2))]


@pytest.mark.parametrize(
    ("defect", "key", "edit"),
    [
        ({"left_boundary": line("0,3.5 30,3 60,3.5")}, 2, {"right_boundary": line("0,-1 60,-1")}),
        ({"left_boundary": line("0,3.5 30,3 60,3.5")}, 1, {"left_mark": Mark.SOLID_WHITE}),
        ({"left_boundary": line("0,3.5 30,3 60,3.5")}, 1, {"lane_type": LaneType.BUS}),
        ({"left_mark": Mark.NONE}, 1, {"left_boundary": line("0,8 60,8")}),
        ({"left_neighbor_id": None}, 2, {"left_mark": Mark.NONE}),
        ({"left_neighbor_id": None}, 1, {"right_boundary": line("0,3.5 30,3 60,3.5")}),
    ],
)
def test_edge_an_old_defect_stays_inherited_when_something_else_is_edited(defect, key, edit):
    base = changed(pair(), 2, **defect)
    found = [one for one in check(base, changed(base, key, **edit)) if one.code == CODE]
    assert [one.inherited for one in found] == [True]


def test_edge_of_an_old_and_a_new_disagreement_the_new_one_is_told():
    #  2 never named 1; now their line is moved in 1, and 1's other neighbour does not follow either
    base = pair().replaced([straight(3, 0, 60, 7, 10.5, right_neighbor_id=1)])
    edited = changed(base, 1, right_boundary=line("0,3.5 30,4 60,3.5"))
    told = {one.elements: one.inherited for one in check(base, edited)}
    assert told == {(1, 2): False, (1, 3): True}


def test_edge_both_lanes_edited_differently_take_the_line_of_the_first():
    base = pair()
    edited = changed(changed(base, 1, right_boundary=line("0,3.5 30,4 60,3.5")), 2, left_mark=Mark.SOLID_WHITE)
    after = mended(base, edited, CODE)
    assert after.lanes[2].left_boundary == line("0,3.5 30,4 60,3.5")
    assert after.lanes[2].left_mark is Mark.DASH_SOLID_WHITE
