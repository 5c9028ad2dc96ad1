"""The irregularities of real maps are in the demo maps too, so that everything built on them has met them."""

from __future__ import annotations

import math

import numpy as np
import pytest
import shapely
from pyarrow import feather

from lanewright.core.elements import LaneSegment, LaneType, Mark
from lanewright.demo import DemoLog
from lanewright.formats.av2_map import read_map


def ring(lane: LaneSegment) -> shapely.Polygon:
    return shapely.Polygon([point[:2] for point in (*lane.right_boundary, *lane.left_boundary[::-1])])


def lanes_of(logs: list[DemoLog]) -> list[LaneSegment]:
    return [lane for log in logs for lane in log.base.lanes.values()]


def test_every_map_is_cropped_to_100_m_around_the_drive(logs: list[DemoLog]) -> None:
    for log in logs:
        table = feather.read_table(log.folder / "city_SE3_egovehicle.feather")
        drive = shapely.LineString(np.column_stack([table["tx_m"].to_numpy(), table["ty_m"].to_numpy()]))
        distances = [ring(lane).distance(drive) for lane in log.base.lanes.values()]
        assert 60 < max(distances) <= 100
        assert max(drive.hausdorff_distance(ring(lane)) for lane in log.base.lanes.values()) > 110
        assert 60 <= len(log.base.lanes) <= 200


def test_links_dangle_over_the_rim_of_every_map(logs: list[DemoLog]) -> None:
    for log in logs:
        lanes = log.base.lanes
        assert sum(id_ not in lanes for lane in lanes.values() for id_ in lane.successors) >= 5
        assert sum(id_ not in lanes for lane in lanes.values() for id_ in lane.predecessors) >= 2


def test_neighbours_dangle_over_the_rim_of_some_map(logs: list[DemoLog]) -> None:
    outside = [
        neighbor
        for log in logs
        for lane in log.base.lanes.values()
        for neighbor in (lane.left_neighbor_id, lane.right_neighbor_id)
        if neighbor is not None and neighbor not in log.base.lanes
    ]
    assert outside


def test_one_map_lists_predecessors_on_one_side_only(logs: list[DemoLog]) -> None:
    missing = []
    for log in logs:
        lanes = log.base.lanes
        links = [(a.id, b) for a in lanes.values() for b in a.successors if b in lanes]
        unlisted = [(a, b) for a, b in links if a not in lanes[b].predecessors]
        assert all(a > b for a, b in unlisted)
        missing.append(len(unlisted) / len(links))
    assert missing.count(0.0) == 2
    assert 0.2 < max(missing) < 0.8


def test_crossings_wind_both_ways(logs: list[DemoLog]) -> None:
    windings = {
        shapely.LinearRing([p[:2] for p in (*zebra.edge1, *zebra.edge2[::-1])]).is_ccw
        for log in logs
        for zebra in log.base.crossings.values()
    }
    assert windings == {True, False}


def test_oncoming_lanes_are_mutual_left_neighbours(logs: list[DemoLog]) -> None:
    for log in logs[:2]:
        lanes = log.base.lanes
        pairs = [
            lane
            for lane in lanes.values()
            if (o := lanes.get(lane.left_neighbor_id or -1)) and o.left_neighbor_id == lane.id
        ]
        assert len(pairs) > 10


@pytest.mark.parametrize("index", range(3))
def test_two_way_streets_without_centre_line_are_two_lanes_on_each_other(logs: list[DemoLog], index: int) -> None:
    lanes = [lane for lane in logs[index].base.lanes.values() if not lane.is_intersection]
    assert any(
        ring(a).intersection(ring(b)).area > 0.99 * ring(a).area
        for i, a in enumerate(lanes)
        for b in lanes[i + 1 :]
        if a.left_boundary == b.right_boundary[::-1]
    )


def test_some_boundaries_are_very_short(logs: list[DemoLog]) -> None:
    lengths = [shapely.LineString(lane.left_boundary).length for lane in lanes_of(logs)]
    assert 0.1 < min(lengths) < 0.5
    assert 60 < max(lengths) < 130


def test_lanes_are_cut_along_the_30_m_grid_in_places(logs: list[DemoLog]) -> None:
    for log in logs:
        on_grid = [
            lane
            for lane in log.base.lanes.values()
            for axis in (0, 1)
            if lane.left_boundary[-1][axis] % 30 == 0 == lane.right_boundary[-1][axis] % 30
        ]
        assert len(on_grid) >= 4


def test_lane_types_and_mixed_marks_are_there(logs: list[DemoLog]) -> None:
    on_disk = lanes_of(logs)
    assert {lane.lane_type for lane in on_disk} == set(LaneType)
    marks = {mark for lane in on_disk for mark in (lane.left_mark, lane.right_mark)}
    assert marks >= {
        Mark.NONE,
        Mark.DASHED_WHITE,
        Mark.SOLID_WHITE,
        Mark.DOUBLE_SOLID_YELLOW,
        Mark.SOLID_DASH_YELLOW,
        Mark.DASH_SOLID_YELLOW,
        Mark.SOLID_DASH_WHITE,
        Mark.DASH_SOLID_WHITE,
    }
    inside = [lane for lane in on_disk if lane.is_intersection]
    assert all(lane.left_mark is Mark.NONE for lane in inside)


def test_a_signalised_junction_has_turn_lanes_and_every_movement(logs: list[DemoLog]) -> None:
    avenue = logs[0].base.lanes
    turns = {"left": 0, "through": 0, "right": 0}
    for lane in avenue.values():
        if lane.is_intersection:
            (x1, y1, _), (x2, y2, _) = lane.left_boundary[:2]
            (x3, y3, _), (x4, y4, _) = lane.left_boundary[-2:]
            change = math.degrees(math.atan2(y4 - y3, x4 - x3) - math.atan2(y2 - y1, x2 - x1))
            change = (change + 180) % 360 - 180
            turns["through" if abs(change) < 40 else "left" if change > 0 else "right"] += 1
    assert min(turns.values()) >= 8
    forks = [lane for lane in avenue.values() if not lane.is_intersection and len(lane.successors) > 1]
    pockets = [
        lane for lane in forks if not any(avenue[id_].is_intersection for id_ in lane.successors if id_ in avenue)
    ]
    assert len(pockets) >= 3


def test_drivable_areas_are_open_rings_under_the_lanes(logs: list[DemoLog]) -> None:
    for log in logs:
        (path,) = (log.folder / "map").glob("log_map_archive_*.json")
        areas = list(read_map(path).drivable_areas.values())
        assert all(area[0] != area[-1] for area in areas)
        polygons = [shapely.Polygon([point[:2] for point in area]) for area in areas]
        assert all(polygon.is_valid for polygon in polygons)
        union = shapely.union_all(polygons)
        covered = [ring(lane).intersection(union).area / ring(lane).area for lane in log.base.lanes.values()]
        assert np.mean(np.array(covered) > 0.97) > 0.85
