"""Demo maps are plausible: the regularities of real maps hold, for any seed."""

from __future__ import annotations

import math
from functools import cache
from itertools import pairwise

import numpy as np
import pytest
import shapely

from lanewright.core.elements import LaneSegment, LaneType, Line, MapState
from lanewright.demo import build_map, demo_maps

SEEDS = (7, 20)
maps_of = cache(demo_maps)


@pytest.fixture(params=[(seed, place, side) for seed in SEEDS for place in range(4) for side in (0, 1)], ids=str)
def state(request: pytest.FixtureRequest) -> MapState:
    """Base (0) and changed (1) map of each place; the fourth place is a grid."""
    seed, place, side = request.param
    return build_map(seed + side, blocks=(2, 1)) if place == 3 else maps_of(seed)[place][side]


def flat(line: Line) -> np.ndarray:
    return np.array(line)[:, :2]


def widths(lane: LaneSegment) -> np.ndarray:
    """From the middle stretch of the left boundary straight across: oblique cuts at the ends do not count."""
    left, right = shapely.LineString(flat(lane.left_boundary)), shapely.LineString(flat(lane.right_boundary))
    middle = shapely.line_interpolate_point(left, np.linspace(0.3, 0.7, 9), normalized=True)
    return np.asarray(shapely.distance(middle, right))


def test_linked_lanes_meet_exactly(state: MapState) -> None:
    links = 0
    for lane in state.lanes.values():
        for follower in (state.lanes[id_] for id_ in lane.successors if id_ in state.lanes):
            assert lane.left_boundary[-1] == follower.left_boundary[0]
            assert lane.right_boundary[-1] == follower.right_boundary[0]
            links += 1
        for leader in (state.lanes[id_] for id_ in lane.predecessors if id_ in state.lanes):
            assert lane.id in leader.successors
    assert links > len(state.lanes) / 2


def test_neighbours_share_their_line_and_its_paint(state: MapState) -> None:
    shared = 0
    for lane in state.lanes.values():
        right = state.lanes.get(lane.right_neighbor_id or -1)
        if right is not None:
            assert right.left_neighbor_id == lane.id
            assert right.left_boundary == lane.right_boundary
            assert right.left_mark == lane.right_mark.mirrored
            shared += 1
        left = state.lanes.get(lane.left_neighbor_id or -1)
        if left is not None and left.right_neighbor_id != lane.id:
            assert left.left_neighbor_id == lane.id
            assert left.left_boundary == lane.left_boundary[::-1]
            assert left.left_mark == lane.left_mark.mirrored
            shared += 1
    assert shared > len(state.lanes) / 8


def test_lanes_are_simple_and_left_is_on_the_left(state: MapState) -> None:
    for lane in state.lanes.values():
        ring = shapely.LinearRing([*flat(lane.right_boundary), *flat(lane.left_boundary)[::-1]])
        assert ring.is_simple, lane.id
        assert ring.is_ccw, lane.id
        for line in (lane.left_boundary, lane.right_boundary):
            assert all(first[:2] != second[:2] for first, second in pairwise(line))


def test_widths_are_those_of_roads(state: MapState) -> None:
    for lane in state.lanes.values():
        measured = widths(lane)
        if lane.is_intersection:
            assert measured.min() > 1.2, lane.id
            assert measured.max() < 7.5, lane.id
        elif lane.lane_type is LaneType.BIKE:
            assert measured.min() > 1.4, lane.id
            assert measured.max() < 2.4, lane.id
        else:
            assert measured.min() > 2.6, lane.id
            assert measured.max() < 5.3, lane.id


def test_no_lane_bends_sharper_than_a_car_can_steer(state: MapState) -> None:
    for lane in state.lanes.values():
        sides = [shapely.LineString(flat(line)) for line in (lane.left_boundary, lane.right_boundary)]
        count = max(3, round(max(side.length for side in sides) / 3))
        shares = np.linspace(0, 1, count)
        centre = (
            sum(
                shapely.get_coordinates(shapely.line_interpolate_point(side, shares, normalized=True)) for side in sides
            )
            / 2
        )
        steps = np.diff(centre, axis=0)
        turn = np.abs((np.diff(np.arctan2(steps[:, 1], steps[:, 0])) + math.pi) % (2 * math.pi) - math.pi)
        lengths = np.linalg.norm(steps, axis=1)
        reach = (lengths[1:] + lengths[:-1]) / 2
        radius = np.min(reach[reach > 1.0] / np.maximum(turn[reach > 1.0], 1e-6), initial=1e6)
        assert radius > (4.0 if lane.is_intersection else 20.0), lane.id


def test_coordinates_are_centimetres(state: MapState) -> None:
    for element in state:
        lines = (
            (element.left_boundary, element.right_boundary)
            if isinstance(element, LaneSegment)
            else (element.edge1, element.edge2)
        )
        assert all(value == round(value, 2) for line in lines for point in line for value in point)


def test_slopes_are_those_of_streets(state: MapState) -> None:
    heights = []
    for lane in state.lanes.values():
        for line in (lane.left_boundary, lane.right_boundary):
            points = np.array(line)
            run, rise = np.linalg.norm(np.diff(points[:, :2], axis=0), axis=1), np.abs(np.diff(points[:, 2]))
            assert (rise <= 0.09 * run + 0.03).all()
            heights += [point[2] for point in line]
    assert np.ptp(heights) > 0.5


def test_crossings_span_a_road(state: MapState) -> None:
    assert len(state.crossings) >= 2 or not any(lane.is_intersection for lane in state.lanes.values())
    for zebra in state.crossings.values():
        along, spacing = math.dist(*zebra.edge1), math.dist(zebra.edge1[0], zebra.edge2[0])
        assert 6 < along < 30
        assert 2 < spacing < 5 < along
        assert np.dot(np.subtract(*flat(zebra.edge1)), np.subtract(*flat(zebra.edge2))) > 0


def test_the_grid_grows_to_the_size_that_benches_need() -> None:
    sizes = [len(build_map(5, blocks=blocks).lanes) for blocks in ((1, 1), (3, 2), (6, 6))]
    assert 60 < sizes[0] < 200 < sizes[1] < 700 < sizes[2] < 3000


def test_the_grid_is_the_same_for_the_same_seed() -> None:
    assert build_map(5) == build_map(5)
    assert build_map(5) != build_map(6)
