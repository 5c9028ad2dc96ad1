"""The crop of a log: what lies within 100 m of the drive. Links that lead out of it stay, as the rim."""

from __future__ import annotations

import shapely

from lanewright.core.elements import Element, LaneSegment, MapState

REACH_M = 100.0


def crop(base: MapState, changed: MapState, trajectory: shapely.LineString) -> tuple[MapState, MapState]:
    """Both maps, cropped alike: an element of both is in both or in neither, however it changed."""
    near = {element.key for element in base if _footprint(element).distance(trajectory) <= REACH_M}
    kept = [
        element
        for element in changed
        if (element.key in near if element.key in base else _footprint(element).distance(trajectory) <= REACH_M)
    ]
    return MapState.of(element for element in base if element.key in near), MapState.of(kept)


def _footprint(element: Element) -> shapely.Polygon:
    if isinstance(element, LaneSegment):
        ring = [*element.right_boundary, *element.left_boundary[::-1]]
    else:
        ring = [*element.edge1, *element.edge2[::-1]]
    return shapely.Polygon([point[:2] for point in ring])
