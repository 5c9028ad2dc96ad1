"""From a plan to drafts: where the blocks of each road begin and end, and what lies in them."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

from lanewright.core.elements import Line
from lanewright.demo.ground import Ground
from lanewright.demo.junction import Arm, connectors, crossings
from lanewright.demo.plan import Junction, Plan, Road
from lanewright.demo.street import LaneDraft, block_lanes


@dataclass(frozen=True, slots=True)
class Drafts:
    """Lanes and crossings (both edges) of a plan by name, before ids are given."""

    lanes: dict[str, LaneDraft]
    crossings: dict[str, tuple[Line, Line]]


@dataclass(frozen=True, slots=True)
class _Stretch:
    """A block between its stop lines."""

    road: Road
    index: int
    start: float
    end: float
    before: Junction | None
    after: Junction | None


def draft(plan: Plan, ground: Ground) -> Drafts:
    """All lanes and crossings of a plan, uncropped."""
    stretches = [stretch for road in plan.roads.values() for stretch in _stretches(plan, road)]
    lanes: dict[str, LaneDraft] = {}
    edges: dict[str, tuple[Line, Line]] = {}
    for stretch in stretches:
        for lane in block_lanes(stretch.road, stretch.index, stretch.start, stretch.end, ground):
            lanes[lane.name] = lane
    arms = _arms(stretches)
    for junction in plan.junctions:
        for lane in connectors(junction, arms[junction.name], ground):
            lanes[lane.name] = lane
        for name, edge1, edge2 in crossings(junction, arms[junction.name], ground):
            edges[name] = (edge1, edge2)
    return Drafts(lanes, edges)


def _stretches(plan: Plan, road: Road) -> Iterator[_Stretch]:
    on_road = sorted(
        (junction.stations[road.name], junction.name, junction)
        for junction in plan.junctions
        if road.name in junction.stations
    )
    start, before, index = 0.0, None, 0
    for station, _, junction in on_road:
        reach = _reach(plan, junction, road)
        if station > 1.0:
            yield _Stretch(road, index, start, station - reach, before, junction)
            index += 1
        start, before = station + reach, junction
    if start < road.path.length:
        yield _Stretch(road, index, start, road.path.length, before, None)
        index += 1
    if index != len(road.blocks):
        raise ValueError(f"road {road.name} has {len(road.blocks)} blocks for {index} stretches")


def _reach(plan: Plan, junction: Junction, road: Road) -> float:
    """Distance from the junction's middle to the stop line: clear of the other road, with room for a crossing."""
    heading = road.path.heading_at(junction.stations[road.name])
    own = max(road.curb_left, road.curb_right)
    reach = 0.0
    for name, station in junction.stations.items():
        if name != road.name:
            other = plan.roads[name]
            angle = other.path.heading_at(station) - heading
            width = max(other.curb_left, other.curb_right)
            reach = max(reach, (width + own * abs(math.cos(angle))) / abs(math.sin(angle)))
    return reach + junction.clearance


def _arms(stretches: list[_Stretch]) -> dict[str, list[Arm]]:
    arms: dict[str, list[Arm]] = {}
    for stretch in stretches:
        road, block = stretch.road, stretch.road.blocks[stretch.index]
        if stretch.before is not None:
            section = block.start.section if block.start else block.along
            arms.setdefault(stretch.before.name, []).append(Arm(f"{road.name}+", road, stretch.start, 1, section))
        if stretch.after is not None:
            section = block.end.section if block.end else block.along
            arms.setdefault(stretch.after.name, []).append(Arm(f"{road.name}-", road, stretch.end, -1, section))
    return arms
