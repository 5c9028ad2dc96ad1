"""The one strict translation between elements and AV2 attributes (11 of a lane, 3 of a crossing), and our ``part_of``.

Readers of files, the API and fixes all pass here, so bad input gets the same clear words everywhere.
Source: AV2 ``log_map_archive`` JSON, shared/reference/data-and-metrics §1.1.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from typing import Any

from lanewright.core.elements import (
    Element,
    ElementKind,
    LaneSegment,
    LaneType,
    Line,
    Mark,
    PedestrianCrossing,
    Point,
)
from lanewright.core.errors import InvalidInput, Place

LARGEST_ID = 2**53 - 1
"""Ids travel through JavaScript, which counts exactly up to here."""
LARGEST_COORDINATE_M = 1e6
"""City frames span some tens of kilometres; anything beyond is a mistake."""
MOST_POINTS = 10_000
MOST_LINKS = 1_000

_LANE_FIELDS = {
    "id": "id",
    "is_intersection": "is_intersection",
    "lane_type": "lane_type",
    "left_lane_boundary": "left_boundary",
    "left_lane_mark_type": "left_mark",
    "right_lane_boundary": "right_boundary",
    "right_lane_mark_type": "right_mark",
    "successors": "successors",
    "predecessors": "predecessors",
    "right_neighbor_id": "right_neighbor_id",
    "left_neighbor_id": "left_neighbor_id",
}
_CROSSING_FIELDS = {"edge1": "edge1", "edge2": "edge2", "id": "id"}
FIELDS: Mapping[ElementKind, Mapping[str, str]] = {
    ElementKind.LANE_SEGMENT: _LANE_FIELDS,
    ElementKind.PEDESTRIAN_CROSSING: _CROSSING_FIELDS,
}
"""AV2 attribute name -> field of our dataclass, in the order of the file."""
OPTIONAL_FIELDS: Mapping[ElementKind, Mapping[str, str]] = {
    ElementKind.LANE_SEGMENT: {"part_of": "part_of"},
    ElementKind.PEDESTRIAN_CROSSING: {},
}
"""Attributes that AV2 does not have: absent (or null) where unset, so a file without them stays as it is."""


def _bad(key: str, problem: str, mend: str) -> InvalidInput:
    return InvalidInput(problem, mend, Place(key=key))


def parse_id(value: Any, key: str = "id") -> int:
    """An element id: a whole number from 0 to 2^53 - 1. Raises InvalidInput."""
    if isinstance(value, bool) or not isinstance(value, int):
        raise _bad(key, f"is {value!r:.60}, not a whole number", "Write an integer id.")
    if not 0 <= value <= LARGEST_ID:
        raise _bad(key, f"is {str(value)[:40]}, outside 0 to 2^53 - 1", "Renumber the element within that range.")
    return value


def parse_coordinate(value: Any, key: str) -> float:
    """A finite coordinate in metres within ±1,000 km. Raises InvalidInput."""
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise _bad(key, f"has the coordinate {value!r:.60}, not a number", "Write metres as a number.")
    if not abs(value) <= LARGEST_COORDINATE_M:  # also false for NaN, and exact for whole numbers beyond all floats
        raise _bad(
            key,
            f"has the coordinate {str(value)[:40]}, outside ±{LARGEST_COORDINATE_M:.0f} m",
            "Write finite metres in the city frame.",
        )
    return float(value)


def parse_line(value: Any, key: str, *, exactly: int | None = None, drawn: bool = False) -> Line:
    """A polyline from a list of ``{x, y, z}``: 2 to 10,000 points, or ``exactly`` so many.

    ``drawn``: z may be null, "not known yet", and becomes NaN (core.elevation fills it). Raises InvalidInput.
    """
    if not isinstance(value, list | tuple):
        raise _bad(key, "is not a list of points", "Write a list of {x, y, z} objects.")
    if exactly is not None and len(value) != exactly:
        raise _bad(key, f"has {len(value)} points, not {exactly}", f"Give exactly {exactly} points.")
    if not 2 <= len(value) <= MOST_POINTS:
        raise _bad(key, f"has {len(value)} points", f"Give 2 to {MOST_POINTS} points.")
    return tuple(_parse_point(point, f"{key}[{i}]", drawn) for i, point in enumerate(value))


def _parse_point(value: Any, key: str, drawn: bool) -> Point:
    if not isinstance(value, Mapping):
        raise _bad(key, "is not a point", "Write an object with x, y and z in metres.")
    try:
        x, y, z = value["x"], value["y"], value["z"]
    except KeyError as error:
        raise _bad(f"{key}.{error.args[0]}", "is missing", "Every point needs x, y and z.") from None
    if type(x) is type(y) is type(z) is float and abs(x) + abs(y) + abs(z) < LARGEST_COORDINATE_M:
        return (x, y, z)  # the common case, fast; NaN and infinity fail the comparison
    return (
        parse_coordinate(x, f"{key}.x"),
        parse_coordinate(y, f"{key}.y"),
        math.nan if z is None and drawn else parse_coordinate(z, f"{key}.z"),
    )


def _parse_links(value: Any, key: str) -> tuple[int, ...]:
    if not isinstance(value, list | tuple) or len(value) > MOST_LINKS:
        raise _bad(key, "is not a list of lane ids", "Write a list of integers; an empty list is fine.")
    return tuple(parse_id(item, f"{key}[{i}]") for i, item in enumerate(value))


def _parse_neighbor(value: Any, key: str) -> int | None:
    return None if value is None else parse_id(value, key)


def _parse_flag(value: Any, key: str) -> bool:
    if not isinstance(value, bool):
        raise _bad(key, f"is {value!r:.60}, not true or false", "Write true or false.")
    return value


def _parse_mark(value: Any, key: str) -> Mark:
    try:
        return Mark(value)
    except ValueError:
        raise _bad(key, f"is {value!r:.60}, not a mark type", f"Use one of {', '.join(Mark)}.") from None


def _parse_lane_type(value: Any, key: str) -> LaneType:
    try:
        return LaneType(value)
    except ValueError:
        raise _bad(key, f"is {value!r:.60}, not a lane type", f"Use one of {', '.join(LaneType)}.") from None


_PARSERS: Mapping[str, Callable[[Any, str], Any]] = {
    "id": parse_id,
    "is_intersection": _parse_flag,
    "lane_type": _parse_lane_type,
    "left_lane_mark_type": _parse_mark,
    "right_lane_mark_type": _parse_mark,
    "successors": _parse_links,
    "predecessors": _parse_links,
    "right_neighbor_id": _parse_neighbor,
    "left_neighbor_id": _parse_neighbor,
    "part_of": _parse_neighbor,
}
_EXACT_POINTS: Mapping[str, int | None] = {
    "left_lane_boundary": None,
    "right_lane_boundary": None,
    "edge1": 2,
    "edge2": 2,
}
"""The geometry attributes, with the number of points they must have."""


def parse_attributes(kind: ElementKind, attributes: Mapping[str, Any], *, drawn: bool = False) -> dict[str, Any]:
    """AV2 attributes -> values by dataclass field. Raises InvalidInput naming the key; unknown keys are refused."""
    fields = {**FIELDS[kind], **OPTIONAL_FIELDS[kind]}
    parsed: dict[str, Any] = {}
    for name, value in attributes.items():
        if name not in fields:
            raise _bad(name, f"is no attribute of a {kind.value}", f"Known are: {', '.join(fields)}.")
        if name in _EXACT_POINTS:
            parsed[fields[name]] = parse_line(value, name, exactly=_EXACT_POINTS[name], drawn=drawn)
        else:
            parsed[fields[name]] = _PARSERS[name](value, name)
    return parsed


def parse_element(kind: ElementKind, attributes: Mapping[str, Any], *, drawn: bool = False) -> Element:
    """A whole element from its attributes; unknown keys are ignored here (the file template keeps them).

    Raises:
        InvalidInput: names the key (missing or wrong) and the mend; the caller completes file and element.
    """
    fields = FIELDS[kind]
    missing = [name for name in fields if name not in attributes]
    if missing:
        raise _bad(missing[0], "is missing", f"A {kind.value} needs {', '.join(fields)}.")
    known = [*fields, *(name for name in OPTIONAL_FIELDS[kind] if name in attributes)]
    parsed = parse_attributes(kind, {name: attributes[name] for name in known}, drawn=drawn)
    return LaneSegment(**parsed) if kind is ElementKind.LANE_SEGMENT else PedestrianCrossing(**parsed)


def attribute_value(value: Any) -> Any:
    """A field's value as it stands in the JSON file."""
    if isinstance(value, tuple):
        return [{"x": v[0], "y": v[1], "z": v[2]} if isinstance(v, tuple) else v for v in value]
    return value.value if isinstance(value, Mark | LaneType) else value


def element_attributes(element: Element) -> dict[str, Any]:
    """All AV2 attributes of an element, in the order of the file; then the optional ones that are set."""
    kind = element.key.kind
    attributes = {name: attribute_value(getattr(element, field)) for name, field in FIELDS[kind].items()}
    for name, field in OPTIONAL_FIELDS[kind].items():
        if (value := getattr(element, field)) is not None:
            attributes[name] = attribute_value(value)
    return attributes
