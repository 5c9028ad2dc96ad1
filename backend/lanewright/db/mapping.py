"""Elements <-> rows: the only place that knows how geometry is stored (WKB, doubles exact) and content hashed."""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import orjson
import shapely
from numpy.typing import NDArray

from lanewright.core.attributes import FIELDS, OPTIONAL_FIELDS, attribute_value
from lanewright.core.elements import (
    Element,
    ElementKey,
    ElementKind,
    LaneSegment,
    LaneType,
    Line,
    Mark,
    PedestrianCrossing,
)

Projection = Callable[[NDArray[np.float64]], NDArray[np.float64]]
"""City metres, shape (n, 2), to EPSG:3857 metres, shape (n, 2)."""

_LINES = {
    ElementKind.LANE_SEGMENT: ("left_boundary", "right_boundary"),
    ElementKind.PEDESTRIAN_CROSSING: ("edge1", "edge2"),
}
"""The two lines of an element, in the order of its stored geometry."""
_PLAIN = {
    kind: {name: field for name, field in FIELDS[kind].items() if field not in (*lines, "id")}
    for kind, lines in _LINES.items()
}
"""AV2 attribute name -> field, without geometry and id: what the column ``attributes`` holds, beside optional ones."""


@dataclass(frozen=True, slots=True)
class ElementRow:
    """An element as it is stored, before a revision gives it its place on a line.

    Attributes:
        geom: WKB, two line strings with z, city metres.
        merc: WKB, the same two lines without z, EPSG:3857, for display.
        sha256: of the element's content (``content_of``).
    """

    kind: str
    element_id: int
    attributes: dict[str, Any]
    geom: bytes
    merc: bytes
    sha256: bytes


def to_rows(elements: Sequence[Element], project: Projection) -> list[ElementRow]:
    """The rows of ``elements``, in their order. Doubles go into ``geom`` bit for bit."""
    if not elements:
        return []
    lines = [line for element in elements for line in _lines_of(element)]
    points = np.array([point for line in lines for point in line], dtype=np.float64)
    line_of_point = np.repeat(np.arange(len(lines)), [len(line) for line in lines])
    element_of_line = np.repeat(np.arange(len(elements)), 2)
    geoms = shapely.multilinestrings(shapely.linestrings(points, indices=line_of_point), indices=element_of_line)
    flat = project(np.ascontiguousarray(points[:, :2]))
    mercs = shapely.multilinestrings(shapely.linestrings(flat, indices=line_of_point), indices=element_of_line)
    return [
        ElementRow(element.key.kind.value, element.id, _plain_attributes(element), geom, merc, element_sha256(element))
        for element, geom, merc in zip(
            elements, shapely.to_wkb(geoms, flavor="iso"), shapely.to_wkb(mercs, flavor="iso"), strict=True
        )
    ]


def from_rows(rows: Sequence[tuple[str, int, dict[str, Any], bytes]]) -> list[Element]:
    """The elements of rows (kind, element_id, attributes, geom as WKB), in their order."""
    if not rows:
        return []
    parts = shapely.get_parts(shapely.from_wkb([row[3] for row in rows]))
    coordinates, line_of_point = shapely.get_coordinates(parts, include_z=True, return_index=True)
    points: list[tuple[float, float, float]] = list(map(tuple, coordinates.tolist()))
    ends = np.cumsum(np.bincount(line_of_point, minlength=len(parts))).tolist()
    lines: Iterator[Line] = (tuple(points[i:j]) for i, j in zip([0, *ends], ends, strict=False))
    return [_element(ElementKind(kind), i, plain, next(lines), next(lines)) for kind, i, plain, _ in rows]


def element_sha256(element: Element) -> bytes:
    """SHA-256 of an element's content; equal elements have equal hashes, whatever wrote them."""
    return hashlib.sha256(content_of(element)).digest()


def content_of(element: Element) -> bytes:
    """An element as canonical JSON: keys sorted, points as [x, y, z], doubles as short as they round-trip.

    Optional attributes that are unset do not appear, so hashes of elements without them are those of before they came.
    """
    kind = element.key.kind
    content: dict[str, Any] = {"kind": kind, **{name: getattr(element, field) for name, field in FIELDS[kind].items()}}
    content |= _optional_attributes(element)
    text = orjson.dumps(content, option=orjson.OPT_SORT_KEYS)
    # -0.0 == 0.0, so they must not differ here; a minus zero stands at the end of a number only before , or ]
    return text.replace(b"-0.0,", b"0.0,").replace(b"-0.0]", b"0.0]") if b"-0.0" in text else text


def map_sha256(hashes: Iterable[tuple[ElementKey, bytes]]) -> bytes:
    """SHA-256 of a whole map state, from the hashes of its elements in any order."""
    whole = hashlib.sha256()
    for key, sha256 in sorted(hashes):
        whole.update(f"{key.kind.value} {key.id} {sha256.hex()}\n".encode())
    return whole.digest()


def _lines_of(element: Element) -> tuple[Line, Line]:
    if isinstance(element, LaneSegment):
        return element.left_boundary, element.right_boundary
    return element.edge1, element.edge2


def _plain_attributes(element: Element) -> dict[str, Any]:
    plain = {name: attribute_value(getattr(element, field)) for name, field in _PLAIN[element.key.kind].items()}
    return plain | _optional_attributes(element)


def _optional_attributes(element: Element) -> dict[str, Any]:
    values = {name: getattr(element, field) for name, field in OPTIONAL_FIELDS[element.key.kind].items()}
    return {name: value for name, value in values.items() if value is not None}


def _element(kind: ElementKind, identity: int, plain: dict[str, Any], first: Line, second: Line) -> Element:
    if kind is ElementKind.PEDESTRIAN_CROSSING:
        return PedestrianCrossing(identity, first, second)
    return LaneSegment(
        id=identity,
        is_intersection=plain["is_intersection"],
        lane_type=LaneType(plain["lane_type"]),
        left_boundary=first,
        left_mark=Mark(plain["left_lane_mark_type"]),
        right_boundary=second,
        right_mark=Mark(plain["right_lane_mark_type"]),
        successors=tuple(plain["successors"]),
        predecessors=tuple(plain["predecessors"]),
        right_neighbor_id=plain["right_neighbor_id"],
        left_neighbor_id=plain["left_neighbor_id"],
        part_of=plain.get("part_of"),
    )
