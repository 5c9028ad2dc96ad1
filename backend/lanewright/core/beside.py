"""Where lanes beside a lane end: lanes side by side begin and end together, since neighbours share whole lines."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator, Sequence
from itertools import chain, islice

from lanewright.core.comparison import Comparison
from lanewright.core.elements import LaneSegment, Line, MapState, Point
from lanewright.core.geometry import MOVED_M, lines_of
from lanewright.core.roadgraph import FINISH, START
from lanewright.core.series import CLOSE_M, NEAR_M, Run, Station, along, at_vertex, vertex_stations
from lanewright.core.survey import Survey

Corner = tuple[float, float]
_MOST = 50
"""Lane ends at one point that are looked at; on real roads there are a few."""
_Corners = dict[Corner, list[tuple[int, Corner]]]
"""Where boundaries end -> the lanes that they are of, and the point of the boundary next to the end."""


class LanesBeside:
    """The ends of all lanes of the edited map, by their corners."""

    def __init__(self, comparison: Comparison):
        lanes = comparison.edited.lanes
        self._known = Survey(comparison.base).fact(_corners)
        self._touched = comparison.touched_lanes | comparison.deleted_lanes
        self._more = _corners(lanes[lane] for lane in comparison.touched_lanes)

    def end_at(self, corner: Corner, line: Line, others_than: Collection[int]) -> bool:
        """Whether another lane ends at that point of a line, and has its boundary on the line up to there."""
        known = (one for one in self._known.get(corner, ()) if one[0] not in self._touched)
        ending = islice(chain(known, self._more.get(corner, ())), _MOST)
        return any(lane not in others_than and along(line, (*before, 0.0))[1] <= MOVED_M for lane, before in ending)

    def joints_of(self, lane: LaneSegment) -> list[Station]:
        """Where a lane is to be cut, since lanes beside it end there, in driving order: across from where one ends on
        the other side too, if that is near."""
        run = Run.of([lane])
        left, right = (self._ends_on(line, lane.id) for line in lines_of(lane))
        stations = [(here, _across(lane.right_boundary, right, point)) for here, point in left]
        stations += [(_across(lane.left_boundary, left, point), here) for here, point in right]
        found: list[Station] = []
        for station in sorted(stations):
            before = found[-1] if found else (0.0, 0.0)
            if all(low < here < end for low, here, end in zip(before, station, run.ends, strict=True)):
                found.append(station)
        return found

    def _ends_on(self, line: Line, lane: int) -> list[tuple[float, Point]]:
        """The inner vertices of a boundary at which lanes beside it end, each with its arc length."""
        ends = zip(vertex_stations(line)[1:-1].tolist(), line[1:-1], strict=True)
        return [(station, point) for station, point in ends if self.end_at(point[:2], line, [lane])]


def _across(line: Line, ends: Sequence[tuple[float, Point]], point: Point) -> float:
    """Where a boundary is cut across from a point: where a lane beside it ends near there, else at a vertex close by,
    else at the nearest place."""
    there = along(line, point)[0]
    nearest = min((here for here, _ in ends), key=lambda here: abs(here - there), default=math.inf)
    return nearest if abs(nearest - there) <= NEAR_M else at_vertex(line, there, CLOSE_M)


def _corners(lanes: MapState | Iterator[LaneSegment]) -> _Corners:
    found: _Corners = {}
    for lane in lanes.lanes.values() if isinstance(lanes, MapState) else lanes:
        for line in (lane.left_boundary, lane.right_boundary):
            if len(line) > 1:
                for end, before in ((line[START], line[1]), (line[-FINISH], line[-2])):
                    found.setdefault(end[:2], []).append((lane.id, before[:2]))
    return found
