"""The second map of each log: a legal update of several kinds, and the world that the sweeps show."""

from __future__ import annotations

import json
from functools import cache

import numpy as np
import pytest
import shapely
from pyarrow import feather

from lanewright.core.changes import Category, Direction
from lanewright.core.diff import diff
from lanewright.core.elements import ElementKind, MapState, PedestrianCrossing
from lanewright.core.rules import check
from lanewright.core.violations import Severity
from lanewright.demo import DemoLog, demo_maps

Update = tuple[MapState, MapState]
maps_of = cache(demo_maps)


@pytest.fixture(params=[(seed, place) for seed in (7, 1) for place in range(3)], ids=str)
def update(request: pytest.FixtureRequest) -> Update:
    """Base and changed map of each place, for several seeds."""
    seed, place = request.param
    return maps_of(seed)[place]


def test_every_category_is_there(update: Update) -> None:
    changes = diff(*update).changes
    found = {(change.kind, category) for change in changes for category in change.categories}
    lane, crossing = ElementKind.LANE_SEGMENT, ElementKind.PEDESTRIAN_CROSSING
    for category in (Category.INSERTION, Category.DELETION, Category.GEOMETRY):
        assert {(lane, category), (crossing, category)} <= found
    assert {(lane, Category.MARKING), (lane, Category.TYPE)} <= found


def test_the_update_breaks_no_rule_in_either_direction(update: Update) -> None:
    base, changed = update
    for before, after in ((base, changed), (changed, base)):
        assert [found for found in check(before, after) if found.severity is Severity.ERROR] == []


def test_most_elements_are_bit_identical_in_both_maps(update: Update) -> None:
    base, changed = update
    same = sum(changed.get(element.key) == element for element in base)
    assert same > len(base) / 3


def test_inserted_elements_have_ids_above_those_of_the_base(update: Update) -> None:
    base, changed = update
    named = {id_ for lane in base.lanes.values() for id_ in (*lane.successors, *lane.predecessors)}
    inserted = changed.lanes.keys() - base.lanes.keys()
    assert inserted
    assert min(inserted) > max(named | base.lanes.keys())
    assert max(changed.lanes) < 2**31


def test_a_function_preserving_rerouting_is_among_the_changes(logs: list[DemoLog]) -> None:
    leaves = {leaf for log in logs for change in diff(log.base, log.changed).changes for leaf in change.leaves}
    assert leaves >= {"geometry.topology", "type.restriction", "type.opening", "marking.color.left"}


def test_both_map_files_share_their_drivable_areas(logs: list[DemoLog]) -> None:
    for log in logs:
        (path,) = (log.folder / "map").glob("log_map_archive_*.json")
        base, changed = (json.loads(file.read_text())["drivable_areas"] for file in (path, log.changed_path))
        assert base == changed


def points_of(log: DemoLog) -> tuple[np.ndarray, np.ndarray]:
    """City xy (n, 2) and intensities (n,) of all sweeps."""
    table = feather.read_table(log.folder / "city_SE3_egovehicle.feather").to_pydict()
    row_of = {timestamp: row for row, timestamp in enumerate(table["timestamp_ns"])}
    places, intensities = [], []
    for path in (log.folder / "sensors" / "lidar").iterdir():
        sweep, row = feather.read_table(path), row_of[int(path.stem)]
        w, x, y, z = (table[name][row] for name in ("qw", "qx", "qy", "qz"))
        ego = np.column_stack([sweep[name].to_numpy().astype(float) for name in "xyz"])
        turn = np.array(
            [
                [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            ]
        )
        places.append(ego @ turn.T + (table["tx_m"][row], table["ty_m"][row]))
        intensities.append(sweep["intensity"].to_numpy())
    return np.concatenate(places), np.concatenate(intensities)


def share_of_paint(zebra: PedestrianCrossing, xy: np.ndarray, intensity: np.ndarray) -> float:
    """How many of the returns from inside a crossing are as bright as paint; NaN where the sweeps hardly saw it."""
    area = shapely.Polygon([point[:2] for point in (*zebra.edge1, *zebra.edge2[::-1])]).buffer(-0.3)
    inside = shapely.contains_xy(area, xy)
    return float((intensity[inside] > 35).mean()) if inside.sum() > 300 else float("nan")


@pytest.mark.parametrize("index", range(3))
def test_sweeps_show_the_current_world(logs: list[DemoLog], index: int) -> None:
    log = logs[index]
    stale, current = log.base, log.changed
    if log.direction is Direction.CURRENT_TO_PRIOR:
        stale, current = current, stale
    xy, intensity = points_of(log)
    there = [share_of_paint(zebra, xy, intensity) for zebra in current.crossings.values()]
    gone = [
        share_of_paint(zebra, xy, intensity) for id_, zebra in stale.crossings.items() if id_ not in current.crossings
    ]
    assert np.isfinite(there).sum() >= 2
    assert np.nanmin(there) > 0.25
    assert all(share < 0.15 for share in gone if np.isfinite(share))


def test_a_crossing_that_is_new_on_the_stale_map_shows_in_the_sweeps(logs: list[DemoLog]) -> None:
    log = next(log for log in logs if log.direction is Direction.PRIOR_TO_CURRENT)
    xy, intensity = points_of(log)
    new = [zebra for id_, zebra in log.changed.crossings.items() if id_ not in log.base.crossings]
    assert new
    assert all(share_of_paint(zebra, xy, intensity) > 0.25 for zebra in new)
