"""The areas of crossings, found by where they lie: looking at one does not cost by how many there are."""

from __future__ import annotations

from collections.abc import Mapping

import shapely

from lanewright.core.geometry import Shape


class CrossingAreas:
    """The areas of some crossings of a map, by id."""

    def __init__(self, shapes: Mapping[int, Shape]):
        self._ids = tuple(shapes)
        self._tree = shapely.STRtree(list(shapes.values()))

    def near(self, shape: Shape) -> tuple[int, ...]:
        """Ids of crossings whose bounding box meets that of an area, ascending."""
        return tuple(sorted(self._ids[index] for index in self._tree.query(shape)))
