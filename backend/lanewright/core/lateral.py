"""Lateral groups: the lanes of one direction and type side by side (spec §5)."""

from __future__ import annotations

import math
from collections.abc import Mapping

from lanewright.core.elements import LaneSegment
from lanewright.core.geometry import centreline, end_midpoint, heading, readable_element, turned

_RING_M = 1e-6


def same_direction(one: LaneSegment, other: LaneSegment) -> bool:
    """Whether two lanes head within 90° of each other; unreadable lanes head nowhere."""
    here, there = lane_heading(one), lane_heading(other)
    return here is not None and there is not None and abs(turned(here, there)) < math.pi / 2


def lane_heading(lane: LaneSegment) -> float | None:
    """Direction from the start to the finish of a lane, radians; of its middle in a ring; None if unreadable."""
    if len(lane.left_boundary) < 2 or len(lane.right_boundary) < 2:
        return None
    (x0, y0, _), (x1, y1, _) = end_midpoint(lane, 0), end_midpoint(lane, 1)
    dx, dy = x1 - x0, y1 - y0
    if math.hypot(dx, dy) > _RING_M:
        return math.atan2(dy, dx)
    return heading(centreline(lane)) if readable_element(lane) else None


def right_of(lanes: Mapping[int, LaneSegment], lane: int) -> int | None:
    """The next lane to the right in the lateral group, or None."""
    return _beside(lanes, lane, lanes[lane].right_neighbor_id, "left_neighbor_id")


def left_of(lanes: Mapping[int, LaneSegment], lane: int) -> int | None:
    """The next lane to the left in the lateral group, or None (an oncoming neighbour is none)."""
    return _beside(lanes, lane, lanes[lane].left_neighbor_id, "right_neighbor_id")


def _beside(lanes: Mapping[int, LaneSegment], lane: int, named: int | None, back: str) -> int | None:
    other = lanes.get(named) if named is not None else None
    if other is None or other.id == lane or getattr(other, back) != lane:
        return None
    here = lanes[lane]
    return other.id if other.lane_type == here.lane_type and same_direction(here, other) else None


def lateral_group(lanes: Mapping[int, LaneSegment], lane: int) -> tuple[int, ...]:
    """The lanes of one direction and type beside this one, itself included, from left to right."""
    group = [lane]
    seen = {lane}
    while (other := left_of(lanes, group[0])) is not None and other not in seen:
        group.insert(0, other)
        seen.add(other)
    while (other := right_of(lanes, group[-1])) is not None and other not in seen:
        group.append(other)
        seen.add(other)
    return tuple(group)
