"""Where the lanes of a map begin and end, to find those on or near a stretch of road."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import shapely

from lanewright.core.elements import LaneSegment, MapState
from lanewright.core.geometry import Plan, plan, readable_element
from lanewright.core.roadgraph import FINISH, START, Endpoint
from lanewright.core.series import Station

_MOST = 200
"""Ends that are looked at along one stretch; on real roads there are a few."""


class NearEnd(NamedTuple):
    """The end of a lane near a stretch: how far its corners are away, where along the stretch, and which."""

    away_m: float
    station: Station
    end: Endpoint


class LaneEnds:
    """The endpoints of all readable lanes of one map state, by their corners."""

    def __init__(self, state: MapState):
        lanes = [(key, lane) for key, lane in sorted(state.lanes.items()) if readable_element(lane)]
        self._ends = [(key, end) for key, _ in lanes for end in (START, FINISH)]
        self._left, self._right = (
            np.array([line[-end][:2] for line in lines for end in (START, FINISH)]).reshape(-1, 2)
            for lines in ([lane.left_boundary for _, lane in lanes], [lane.right_boundary for _, lane in lanes])
        )
        self._tree = shapely.STRtree(shapely.points(self._left))

    def near(self, stretch: LaneSegment, limit_m: float) -> list[NearEnd]:
        """The ends, in the direction of the stretch, both of whose corners are that near to its boundaries; the nearest
        first."""
        left, right = (shapely.linestrings(plan(line)) for line in (stretch.left_boundary, stretch.right_boundary))
        found = np.sort(self._tree.query(left, predicate="dwithin", distance=limit_m))[:_MOST]
        corners = self._left[found], self._right[found]
        points = [shapely.points(side) for side in corners]
        stations = [shapely.line_locate_point(line, side) for line, side in zip((left, right), points, strict=True)]
        places: list[Plan] = [
            shapely.get_coordinates(shapely.line_interpolate_point(line, station))
            for line, station in zip((left, right), stations, strict=True)
        ]
        away_m = np.maximum(*(np.hypot(*(side - place).T) for side, place in zip(corners, places, strict=True)))
        onward = ((corners[1] - corners[0]) * (places[1] - places[0])).sum(axis=1) > 0
        near = np.flatnonzero((away_m <= limit_m) & onward).tolist()
        return sorted(
            NearEnd(
                round(float(away_m[index]), 6),
                (float(stations[0][index]), float(stations[1][index])),
                self._ends[found[index]],
            )
            for index in near
        )
