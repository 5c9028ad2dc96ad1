"""Unknown heights are filled: from the same place, the ground, the line, the nearest vertex; never left open."""

from __future__ import annotations

import dataclasses
import math

from tests.core.worlds import line, straight, world

from lanewright.core.elevation import fill_elevation

NAN = math.nan


def nowhere(_x: float, _y: float) -> float:
    return NAN


def heights(points):
    return [z for _, _, z in points]


def test_a_state_without_unknown_heights_is_returned_as_it_is():
    state = world(straight(1, 0, 20))
    assert fill_elevation(state, nowhere) is state


def test_the_same_place_wins_over_the_ground_and_the_lowest_id_decides():
    known = dataclasses.replace(straight(5, 0, 20), left_boundary=((0, 3.5, 7.0), (20, 3.5, 8.0)))
    other = dataclasses.replace(straight(3, 0, 20, 3.5, 7), right_boundary=((0, 3.5, 6.0), (20, 3.5, NAN)))
    new = dataclasses.replace(straight(9, 0, 20), left_boundary=((0, 3.5, NAN), (20, 3.5, NAN)))
    filled = fill_elevation(world(known, other, new), lambda x, y: 100.0)
    assert heights(filled.lanes[9].left_boundary) == [6.0, 8.0]
    assert heights(filled.lanes[3].right_boundary) == [6.0, 8.0]
    assert filled.lanes[5] is known


def test_the_ground_fills_what_no_point_knows():
    lane = dataclasses.replace(straight(1, 0, 20), left_boundary=line("0,3.5 20,3.5", z=NAN))
    filled = fill_elevation(world(lane), lambda x, y: x / 10)
    assert heights(filled.lanes[1].left_boundary) == [0.0, 2.0]


def test_off_the_ground_the_height_runs_along_the_line_and_is_shared():
    left = ((0.0, 3.5, 1.0), (5.0, 3.5, NAN), (20.0, 3.5, 5.0))
    lane = dataclasses.replace(straight(1, 0, 20), left_boundary=left)
    beside = dataclasses.replace(straight(2, 0, 20, 3.5, 7), right_boundary=((5.0, 3.5, NAN), (20.0, 3.5, NAN)))
    filled = fill_elevation(world(beside, lane), nowhere)
    assert heights(filled.lanes[1].left_boundary) == [1.0, 2.0, 5.0]
    assert heights(filled.lanes[2].right_boundary) == [2.0, 5.0]


def test_a_lane_out_of_everything_takes_the_nearest_vertex():
    near = dataclasses.replace(
        straight(1, 0, 20), left_boundary=line("0,3.5 20,3.5", z=3.0), right_boundary=line("0,0 20,0", z=3.0)
    )
    far = dataclasses.replace(
        straight(2, 500, 520), left_boundary=line("500,3.5 520,3.5", z=9.0), right_boundary=line("500,0 520,0", z=9.0)
    )
    new = dataclasses.replace(
        straight(3, 30, 40), left_boundary=line("30,3.5 40,3.5", z=NAN), right_boundary=line("30,0 40,0", z=NAN)
    )
    filled = fill_elevation(world(far, near, new), nowhere)
    assert set(heights(filled.lanes[3].left_boundary) + heights(filled.lanes[3].right_boundary)) == {3.0}
