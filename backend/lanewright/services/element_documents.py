"""Elements as the API's JSON: AV2 attributes, each beside the revision that wrote it."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from lanewright.core.attributes import element_attributes
from lanewright.core.elements import Element, ElementKey, LaneSegment


def element_document(element: Element, version: int) -> dict[str, Any]:
    """A lane or crossing at one revision."""
    return {"version": version, "attributes": element_attributes(element)}


def map_document(elements: Iterable[Element], versions: Mapping[ElementKey, int]) -> dict[str, Any]:
    """Elements of a map, lanes and crossings apart, in the order given."""
    lanes: list[dict[str, Any]] = []
    crossings: list[dict[str, Any]] = []
    for element in elements:
        of_kind = lanes if isinstance(element, LaneSegment) else crossings
        of_kind.append(element_document(element, versions[element.key]))
    return {"lanes": lanes, "crossings": crossings}


def key_documents(keys: Iterable[ElementKey]) -> list[dict[str, Any]]:
    """Keys of elements, sorted."""
    return [{"kind": key.kind, "id": key.id} for key in sorted(keys)]
