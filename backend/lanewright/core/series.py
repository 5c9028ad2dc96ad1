"""Lanes in series as one run of road: where it can be cut, and the pieces that come out (spec §2, cuts)."""

from __future__ import annotations

import dataclasses
import itertools
import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from lanewright.core.elements import LaneSegment, Line, Point
from lanewright.core.geometry import Plan, length_m, plan
from lanewright.core.identity import joined

Station = tuple[float, float]
"""Arc lengths on the left and the right boundary, metres."""
SAME_POINT_M = 1e-6
NEAR_M = 3.0
"""Joints of base and edited run within this distance are one joint."""
CLOSE_M = 1.0
"""A cut across from a joint takes a vertex within this distance: lanes that were drawn there have their ends there."""


@dataclass(frozen=True, slots=True)
class Run:
    """Lanes in series as one.

    Attributes:
        lanes: in driving direction.
        whole: all of them joined, whatever differs between them.
        joints: stations of the joints between them, on ``whole``.
    """

    lanes: tuple[LaneSegment, ...]
    whole: LaneSegment
    joints: tuple[Station, ...]

    @classmethod
    def of(cls, lanes: Sequence[LaneSegment]) -> Run:
        """The run of lanes in series."""
        left = np.cumsum([length_m(plan(lane.left_boundary)) for lane in lanes])
        right = np.cumsum([length_m(plan(lane.right_boundary)) for lane in lanes])
        joints = tuple((float(a), float(b)) for a, b in zip(left[:-1], right[:-1], strict=True))
        return cls(tuple(lanes), joined(lanes), joints)

    @property
    def ends(self) -> Station:
        return (length_m(plan(self.whole.left_boundary)), length_m(plan(self.whole.right_boundary)))

    def properties_at(self, station: Station) -> LaneSegment:
        """The lane that covers the road just past a station."""
        for lane, joint in zip(self.lanes, self.joints, strict=False):
            if station[0] + station[1] < joint[0] + joint[1] - 2 * SAME_POINT_M:
                return lane
        return self.lanes[-1]

    def place(self, station: Station) -> tuple[Point, Point]:
        """The points on left and right at a station."""
        return point_at(self.whole.left_boundary, station[0]), point_at(self.whole.right_boundary, station[1])

    def station_of(self, left: Point, right: Point) -> Station:
        """The station whose points are nearest to these."""
        return (along(self.whole.left_boundary, left)[0], along(self.whole.right_boundary, right)[0])

    def pieces(self, stations: Sequence[Station]) -> list[LaneSegment]:
        """The run cut at those stations only: each piece has the properties of the road there, and no ids or links
        of its own (they are the whole's)."""
        cuts = [(0.0, 0.0), *stations, self.ends]
        return [
            dataclasses.replace(
                self.properties_at(start),
                left_boundary=between(self.whole.left_boundary, start[0], finish[0]),
                right_boundary=between(self.whole.right_boundary, start[1], finish[1]),
                left_neighbor_id=None,
                right_neighbor_id=None,
            )
            for start, finish in itertools.pairwise(cuts)
        ]


def apart_m(one: Station, other: Station) -> float:
    """How far two stations of one run are apart, on the mean of both sides."""
    return (abs(one[0] - other[0]) + abs(one[1] - other[1])) / 2


def along(line: Line, point: Point) -> tuple[float, float]:
    """Arc length of the nearest point on a line, and how far away that is."""
    points = plan(line)
    starts, steps = points[:-1], np.diff(points, axis=0)
    squared = (steps**2).sum(axis=1)
    squared[squared == 0] = 1.0
    share = np.clip((((point[0], point[1]) - starts) * steps).sum(axis=1) / squared, 0.0, 1.0)
    feet = starts + share[:, None] * steps
    distances = np.hypot(*(feet - (point[0], point[1])).T)
    nearest = int(distances.argmin())
    lengths = np.hypot(*steps.T)
    return float(lengths[:nearest].sum() + share[nearest] * lengths[nearest]), float(distances[nearest])


def point_at(line: Line, station: float) -> Point:
    """The point at an arc length: a vertex itself where one is there, else interpolated, z too."""
    for vertex, here in zip(line, vertex_stations(line), strict=True):
        if abs(here - station) <= SAME_POINT_M:
            return vertex
    stations = vertex_stations(line)
    x, y, z = (float(np.interp(station, stations, [vertex[axis] for vertex in line])) for axis in (0, 1, 2))
    return (x, y, z) if math.isfinite(z) else (x, y, math.nan)


def between(line: Line, start: float, finish: float) -> Line:
    """The part of a line between two arc lengths, ends included."""
    stations = vertex_stations(line)
    inner = [
        vertex
        for vertex, here in zip(line, stations, strict=True)
        if start + SAME_POINT_M < here < finish - SAME_POINT_M
    ]
    return (point_at(line, start), *inner, point_at(line, finish))


def at_vertex(line: Line, station: float, limit_m: float) -> float:
    """The arc length of an inner vertex of a line that is that close to another arc length; else that one."""
    inner = vertex_stations(line)[1:-1].tolist()
    nearest = min(inner, key=lambda vertex: abs(vertex - station), default=station)
    return nearest if abs(nearest - station) <= limit_m else station


def vertex_stations(line: Line) -> Plan:
    """The arc length of each vertex of a line."""
    points = plan(line)
    stations: Plan = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(points, axis=0).T))])
    return stations
