"""Where the lanes of a map begin and end, to find those on or near another line."""

from __future__ import annotations

import numpy as np
import shapely

from lanewright.core.elements import Line, MapState
from lanewright.core.geometry import plan, readable_element
from lanewright.core.roadgraph import FINISH, START, Endpoint


class LaneEnds:
    """The endpoints of all readable lanes of one map state, by their left corners."""

    def __init__(self, state: MapState):
        self._ends = [
            (key, end) for key, lane in sorted(state.lanes.items()) if readable_element(lane) for end in (START, FINISH)
        ]
        corners = [state.lanes[key].left_boundary[-end][:2] for key, end in self._ends]
        self._tree = shapely.STRtree(shapely.points(np.array(corners).reshape(-1, 2)))

    def near(self, left_boundary: Line, limit_m: float) -> list[Endpoint]:
        """The ends whose left corner is that near to a left boundary, ascending."""
        line = shapely.linestrings(plan(left_boundary))
        found = self._tree.query(line, predicate="dwithin", distance=limit_m)
        return [self._ends[index] for index in sorted(found.tolist())]
