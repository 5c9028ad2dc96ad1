"""Heights for new and moved vertices (issue: points whose z is NaN are the ones whose height is unknown).

An unknown z becomes, in this order: the z of a point at the same place that has one; the ground there; the height along
the line between known points; the height of the nearest known vertex of the map. All lines that share the place get
the same z, and where several could decide, the element of the lowest kind and id does, so the outcome is deterministic.
"""

from __future__ import annotations

import dataclasses
import itertools
import math
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from lanewright.core.elements import Element, LaneSegment, Line, MapState
from lanewright.core.geometry import readable

Ground = Callable[[float, float], float]
"""Height in metres at a place of the city frame; NaN outside the surveyed area."""
Place = tuple[float, float]
_LANE_LINES = ("left_boundary", "right_boundary")
_CROSSING_LINES = ("edge1", "edge2")


def fill_elevation(state: MapState, ground: Ground) -> MapState:
    """The state with every unknown height filled in; elements without any stay the same objects."""
    lacking = {element.key for element in state if any(_lacks(line) for line in _lines(element))}
    if not lacking:
        return state
    wanted = {
        point[:2]
        for element in state
        if element.key in lacking
        for line in _lines(element)
        for point in line
        if math.isnan(point[2])
    }
    ordered = sorted(state, key=lambda element: element.key)
    heights = _known_heights(ordered, wanted)
    for place in sorted(wanted - heights.keys()):
        height = ground(*place)
        if math.isfinite(height):
            heights[place] = float(height)
    _fill_along_lines([element for element in ordered if element.key in lacking], heights)
    _fill_from_nearest(ordered, wanted, heights)
    return state.replaced([_filled(element, heights) for element in state if element.key in lacking])


def _lines(element: Element) -> tuple[Line, Line]:
    if isinstance(element, LaneSegment):
        return element.left_boundary, element.right_boundary
    return element.edge1, element.edge2


def _lacks(line: Line) -> bool:
    return any(z != z for _, _, z in line)


def _known_heights(ordered: list[Element], wanted: set[Place]) -> dict[Place, float]:
    """Heights that points at the wanted places have already; the lowest element decides."""
    heights: dict[Place, float] = {}
    for element in ordered:
        for line in _lines(element):
            for x, y, z in line:
                if z == z and (x, y) in wanted:
                    heights.setdefault((x, y), z)
    return heights


def _fill_along_lines(ordered: list[Element], heights: dict[Place, float]) -> None:
    """Linear along each line between known points, level beyond the last one; lines in order of element."""
    for element in ordered:
        for line in _lines(element):
            known = [(index, z if z == z else heights.get((x, y), math.nan)) for index, (x, y, z) in enumerate(line)]
            places = [(index, z) for index, z in known if z == z]
            if not places or len(places) == len(line) or not readable(line):
                continue
            along = _arc_lengths(line)
            filled = np.interp(along, [along[index] for index, _ in places], [z for _, z in places])
            for (index, z), height in zip(known, filled, strict=True):
                if z != z and math.isfinite(height):
                    heights.setdefault(line[index][:2], float(height))


def _arc_lengths(line: Line) -> list[float]:
    along = [0.0]
    for one, other in itertools.pairwise(line):
        along.append(along[-1] + math.hypot(other[0] - one[0], other[1] - one[1]))
    return along


def _fill_from_nearest(ordered: list[Element], wanted: set[Place], heights: dict[Place, float]) -> None:
    """What is left takes the height of the nearest known vertex of the map (0 in a map without any height)."""
    left = sorted(place for place in wanted - heights.keys() if all(map(math.isfinite, place)))
    if not left:
        return
    known = [point for point in _points(ordered) if all(map(math.isfinite, point))]
    known += [(x, y, z) for (x, y), z in sorted(heights.items())]
    if not known:
        heights.update(dict.fromkeys(left, 0.0))
        return
    vertices = np.array(known)
    for place in left:
        nearest = np.hypot(*(vertices[:, :2] - place).T).argmin()
        heights[place] = float(vertices[nearest, 2])


def _points(elements: list[Element]) -> Iterator[tuple[float, float, float]]:
    for element in elements:
        for line in _lines(element):
            yield from line


def _filled(element: Element, heights: dict[Place, float]) -> Element:
    names = _LANE_LINES if isinstance(element, LaneSegment) else _CROSSING_LINES
    lines: dict[str, Any] = {
        name: tuple((x, y, z if z == z else heights.get((x, y), 0.0)) for x, y, z in line)
        for name, line in zip(names, _lines(element), strict=True)
        if _lacks(line)
    }
    return dataclasses.replace(element, **lines)
