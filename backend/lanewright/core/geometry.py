"""Plane geometry of lines and elements: metres, city frame, z ignored throughout (spec §1: z alone is never a change).

Kernels take lines and return numbers or shapely shapes. A line with fewer than two points or a coordinate that is not
finite cannot be read; such lines compare by value and have no shape.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
import numpy.typing as npt
import shapely

from lanewright.core.elements import Element, LaneSegment, Line, PedestrianCrossing, Point

Plan = npt.NDArray[np.float64]
"""Points in the plane, shape (n, 2)."""
Shape = Any
"""A shapely geometry (shapely ships no types)."""

FURTHEST_M = 1e7
"""Coordinates beyond this cannot be reckoned with."""
MOVED_M = 0.05
"""A boundary moved when the Hausdorff distance between its old and new line is larger (spec §3)."""
_DENSIFIED_M = 0.5
_MOST_DENSIFIED = 2_000
_FLAT_M = 1e-9
_MOST_AT_ONCE = 500_000
_A_FEW = 8
_GRID_M = 1e-3
_MOST_MENDED = 100

quietly = np.errstate(divide="ignore", over="ignore", invalid="ignore")
"""Around GEOS: on lines without length it divides by nothing, handles it, and NumPy would warn all the same."""


def plan(line: Line) -> Plan:
    """The points of a line in the plane, shape (n, 2)."""
    return np.array([point[:2] for point in line], dtype=np.float64).reshape(-1, 2)


def same_plan(one: Line, other: Line) -> bool:
    """Whether two lines have the same points in the plane, z aside."""
    return one == other or (
        len(one) == len(other) and all(a[0] == b[0] and a[1] == b[1] for a, b in zip(one, other, strict=True))
    )


def readable(line: Line) -> bool:
    """Whether a line has at least two points, all within 10,000 km of the origin (so finite) in the plane."""
    return len(line) >= 2 and all(-FURTHEST_M < x < FURTHEST_M and -FURTHEST_M < y < FURTHEST_M for x, y, _ in line)


def readable_element(element: Element) -> bool:
    """Whether both lines of an element can be read."""
    return all(readable(line) for line in lines_of(element))


def lines_of(element: Element) -> tuple[Line, Line]:
    """Left and right boundary of a lane, or the two edges of a crossing."""
    if isinstance(element, LaneSegment):
        return element.left_boundary, element.right_boundary
    return element.edge1, element.edge2


def hausdorff_m(one: Line, other: Line) -> float:
    """2-D Hausdorff distance between two lines, each densified to 0.5 m (coarser on lines beyond 1 km)."""
    if same_plan(one, other):
        return 0.0
    if not (readable(one) and readable(other)):
        return math.inf
    if len(one) == len(other) == 2:
        # The distance to a straight line is convex: it is largest at an end.
        return max(*(_from_segment_m(end, *other) for end in one), *(_from_segment_m(end, *one) for end in other))
    return max(_furthest_m(_densified(points), line) for points, line in _both_ways(one, other))


def moved(one: Line, other: Line) -> bool:
    """Whether a boundary moved between two states: a Hausdorff distance of more than 5 cm (spec §3).

    Mostly a few of its own points tell; the distance is worked out only where it is close to the limit.
    """
    if same_plan(one, other):
        return False
    if len(one) > 2 < len(other) and readable(one) and readable(other):
        ways = _both_ways(one, other)
        for step in (1 + len(one) // _A_FEW, 1):
            if any(_strays(points[::step], line, MOVED_M + _FLAT_M) for points, line in ways):
                return True
        if not any(_strays(_densified(points), line, MOVED_M - _FLAT_M) for points, line in ways):
            return False
    return hausdorff_m(one, other) > MOVED_M


def _both_ways(one: Line, other: Line) -> list[tuple[Plan, Plan]]:
    """Each line with the other one to measure from; points that both begin or end with lie on both and are left out."""
    shortest = min(len(one), len(other))
    first = next((i for i in range(shortest) if one[i][:2] != other[i][:2]), shortest)
    last = next((i for i in range(shortest - first) if one[-1 - i][:2] != other[-1 - i][:2]), shortest - first)
    points = plan(one), plan(other)
    return [(here[max(first - 1, 0) : len(here) - max(last - 1, 0)], there) for here, there in (points, points[::-1])]


@quietly
def _strays(points: Plan, line: Plan, limit_m: float) -> bool:
    """Whether any of the points is further than that from a polyline."""
    target = shapely.linestrings(line)
    shapely.prepare(target)
    return not shapely.dwithin(shapely.points(points), target, limit_m).all()


def _from_segment_m(point: Point, start: Point, finish: Point) -> float:
    """Distance from a point to a straight line between two others."""
    away_x, away_y = point[0] - start[0], point[1] - start[1]
    step_x, step_y = finish[0] - start[0], finish[1] - start[1]
    squared = max(step_x**2 + step_y**2, _FLAT_M**2)
    share = min(max((away_x * step_x + away_y * step_y) / squared, 0.0), 1.0)
    return math.hypot(away_x - share * step_x, away_y - share * step_y)


def _furthest_m(points: Plan, line: Plan) -> float:
    """The largest distance of any of the points to a polyline."""
    starts, steps = line[:-1], np.diff(line, axis=0)
    squared = np.maximum((steps**2).sum(axis=1), _FLAT_M**2)
    furthest = 0.0
    for chunk in np.array_split(points, max(1, len(points) * len(steps) // _MOST_AT_ONCE)):
        away = chunk[:, None, :] - starts
        share = np.clip((away * steps).sum(axis=2) / squared, 0.0, 1.0)
        gap = away - share[:, :, None] * steps
        furthest = max(furthest, float((gap**2).sum(axis=2).min(axis=1).max()))
    return math.sqrt(furthest)


def _densified(points: Plan) -> Plan:
    """A polyline with points added so that none are further apart than 0.5 m, or a 2000th of its length."""
    if len(points) < 2:
        return points
    lengths = np.hypot(*np.diff(points, axis=0).T)
    step = max(_DENSIFIED_M, float(lengths.sum()) / _MOST_DENSIFIED)
    counts = np.maximum(np.ceil(lengths / step), 1).astype(np.int64)
    index = np.repeat(np.arange(len(counts)), counts)
    share = (np.arange(len(index)) - np.repeat(np.cumsum(counts) - counts, counts)) / counts[index]
    dense: Plan = points[index] + share[:, None] * np.diff(points, axis=0)[index]
    return np.vstack([dense, points[-1:]])


def length_m(points: Plan) -> float:
    """Arc length of a polyline in the plane."""
    return float(np.hypot(*np.diff(points, axis=0).T).sum())


def resample(points: Plan, count: int) -> Plan:
    """``count`` points at equal arc length along a polyline, ends included; shape (count, 2)."""
    steps = np.hypot(*np.diff(points, axis=0).T)
    along = np.concatenate([[0.0], np.cumsum(steps)])
    wanted = np.linspace(0.0, along[-1], count)
    return np.column_stack([np.interp(wanted, along, points[:, axis]) for axis in (0, 1)])


def centreline(lane: LaneSegment, count: int = 21) -> Plan:
    """Midpoints of left and right boundary at equal fractions of their lengths, shape (count, 2)."""
    middle: Plan = (resample(plan(lane.left_boundary), count) + resample(plan(lane.right_boundary), count)) / 2
    return middle


def end_midpoint(lane: LaneSegment, end: int) -> Point:
    """Midpoint between left and right at the start (0) or the finish (1) of a lane; z is the mean."""
    left, right = lane.left_boundary[-end], lane.right_boundary[-end]
    return ((left[0] + right[0]) / 2, (left[1] + right[1]) / 2, (left[2] + right[2]) / 2)


def distance_m(one: Point, other: Point) -> float:
    """Distance of two points in the plane."""
    return math.hypot(one[0] - other[0], one[1] - other[1])


def heading(points: Plan) -> float:
    """Direction from the first to the last point, radians from grid east; of the middle where those coincide."""
    dx, dy = points[-1] - points[0]
    if math.hypot(dx, dy) < _FLAT_M and len(points) > 2:
        middle = len(points) // 2
        dx, dy = points[middle] - points[middle - 1]
    return math.atan2(dy, dx)


def turned(before: float, after: float) -> float:
    """The signed angle from one heading to another, radians in (-pi, pi]; left is positive."""
    angle = math.remainder(after - before, math.tau)
    return math.pi if angle == -math.pi else angle


@quietly
def polygon(element: Element) -> Shape:
    """The area an element covers: left plus reversed right, or the hull of a crossing's corners.

    Invalid rings are repaired, so areas and distances are defined; of a long ring that crosses itself (it may do so as
    often as its points squared) the hull is taken. Unreadable elements give an empty polygon.
    """
    if not readable_element(element):
        return shapely.Polygon()
    one, other = (plan(line) for line in lines_of(element))
    if isinstance(element, PedestrianCrossing):
        return shapely.convex_hull(shapely.multipoints(np.vstack([one, other])))
    corners = np.vstack([one, other[::-1]])
    shape = shapely.polygons(shapely.linearrings(corners))
    if shapely.is_valid(shape):
        return shape
    return shapely.make_valid(shape, method="structure") if len(corners) <= _MOST_MENDED else shapely.convex_hull(shape)


def overlap(one: Shape, other: Shape) -> float:
    """Intersection over union of two areas, 0 where neither has any."""
    return float(overlaps(one, [other])[0])


@quietly
def apart_m(one: Shape, other: Shape) -> float:
    """Distance between two areas; NaN where one is empty."""
    return float(shapely.distance(one, other))


@quietly
def within(shapes: npt.NDArray[Any], one: Shape, limit_m: float) -> npt.NDArray[np.bool_]:
    """Which of the areas are no further than that from another one, shape (n,)."""
    near: npt.NDArray[np.bool_] = shapely.dwithin(shapes, one, limit_m)
    return near


@quietly
def pairs_within(shapes: npt.NDArray[Any], limit_m: float) -> list[tuple[int, int]]:
    """The positions of all pairs of areas, shape (n,), that are no further apart than that, each pair once."""
    pairs = shapely.STRtree(shapes).query(shapes, predicate="dwithin", distance=limit_m)
    return [(one, other) for one, other in pairs.T.tolist() if one < other]


@quietly
def overlaps(one: Shape, others: Sequence[Shape]) -> npt.NDArray[np.float64]:
    """Intersection over union of an area with each of others, shape (n,)."""
    try:
        common = shapely.area(shapely.intersection(one, others))
    except shapely.GEOSException:
        # Lanes of thousands of kilometres and no width: on a grid every shape can be intersected.
        on_grid = shapely.set_precision([one, *others], _GRID_M)
        common = shapely.area(shapely.intersection(on_grid[0], on_grid[1:], grid_size=_GRID_M))
    union = shapely.area(one) + shapely.area(others) - common
    shares: npt.NDArray[np.float64] = np.divide(common, union, out=np.zeros(len(others)), where=union > 0)
    return shares
