"""The crop of a log: what lies within 100 m of the drive. Links that lead out of it stay, as the rim."""

from __future__ import annotations

from dataclasses import replace

import shapely

from lanewright.core.elements import Element, LaneSegment, MapState

REACH_M = 100.0


def crop(base: MapState, changed: MapState, trajectory: shapely.LineString) -> tuple[MapState, MapState]:
    """Both maps, cropped alike: an element of both is in both or in neither, however it changed.

    The rim is what both maps name: an annotator cannot draw a link to a lane that no map shows.
    """
    near = {element.key for element in base if _footprint(element).distance(trajectory) <= REACH_M}
    kept_base = [element for element in base if element.key in near]
    kept_changed = [
        element
        for element in changed
        if (element.key in near if element.key in base else _footprint(element).distance(trajectory) <= REACH_M)
    ]
    rim = _rim(kept_base) & _rim(kept_changed)
    return _with_rim(kept_base, rim), _with_rim(kept_changed, rim)


def _lanes(elements: list[Element]) -> list[LaneSegment]:
    return [element for element in elements if isinstance(element, LaneSegment)]


def _rim(elements: list[Element]) -> set[int]:
    """Ids of lanes that are named but not there."""
    lanes = _lanes(elements)
    return {id_ for lane in lanes for id_ in _named(lane)} - {lane.id for lane in lanes}


def _with_rim(elements: list[Element], rim: set[int]) -> MapState:
    known = rim | {lane.id for lane in _lanes(elements)}
    return MapState.of(_without_unknown(element, known) for element in elements)


def _named(lane: LaneSegment) -> set[int]:
    neighbors = (lane.left_neighbor_id, lane.right_neighbor_id)
    return {*lane.successors, *lane.predecessors, *(id_ for id_ in neighbors if id_ is not None)}


def _without_unknown(element: Element, known: set[int]) -> Element:
    if not isinstance(element, LaneSegment) or _named(element) <= known:
        return element
    return replace(
        element,
        successors=tuple(id_ for id_ in element.successors if id_ in known),
        predecessors=tuple(id_ for id_ in element.predecessors if id_ in known),
        left_neighbor_id=element.left_neighbor_id if element.left_neighbor_id in known else None,
        right_neighbor_id=element.right_neighbor_id if element.right_neighbor_id in known else None,
    )


def _footprint(element: Element) -> shapely.Polygon:
    if isinstance(element, LaneSegment):
        ring = [*element.right_boundary, *element.left_boundary[::-1]]
    else:
        ring = [*element.edge1, *element.edge2[::-1]]
    return shapely.Polygon([point[:2] for point in ring])
