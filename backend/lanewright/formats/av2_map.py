"""The AV2 vector map file (``log_map_archive_*.json``): read into a map state, written back onto the file's own text.

What nobody edited is written exactly as it was read: order of keys and elements, digits, one-sided links, keys of
others. Source: av2-api ``map_api`` and the official TbV verifier (shared facts: three top-level keys, 11 lane keys).
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType
from typing import Any

from lanewright.core.attributes import (
    FIELDS,
    OPTIONAL_FIELDS,
    attribute_value,
    element_attributes,
    parse_element,
    parse_id,
    parse_line,
)
from lanewright.core.elements import Element, ElementKind, Line, MapState
from lanewright.core.errors import InvalidInput, Place
from lanewright.formats import json_text
from lanewright.formats.json_document import BYTE_ORDER_MARK, JsonPath, Limits, parse_json, path_text
from lanewright.formats.untrusted_file import read_bytes

LIMITS = Limits()
"""Real maps are 0.2 to 2 MB with some 50,000 values, 6 levels deep."""

_GROUPS: Mapping[str, ElementKind] = {
    "lane_segments": ElementKind.LANE_SEGMENT,
    "pedestrian_crossings": ElementKind.PEDESTRIAN_CROSSING,
}
_DRIVABLE_AREAS = "drivable_areas"
_WORDS = {**{group: kind.value for group, kind in _GROUPS.items()}, _DRIVABLE_AREAS: "drivable_area"}
_REQUIRED = ("lane_segments", _DRIVABLE_AREAS)


@dataclass(frozen=True, slots=True)
class MapDocument:
    """A map file: its text as the template, and what it says.

    Attributes:
        text: the file, character for character.
        state: its lane segments and crossings.
        drivable_areas: their rings in city metres, not closed, by id; rendered as they stand in the file.
    """

    file_name: str
    text: str
    state: MapState
    drivable_areas: Mapping[int, Line]

    def render(self, state: MapState) -> bytes:
        """A map file of the given state.

        Untouched elements are written as in the file; changed ones keep their order of keys and all they did not
        change; deleted ones are left out; new ones stand at the end of their kind, sorted by id, with AV2's own keys
        in AV2's order. Keys that are not AV2's stay with their element even when it changed.
        """
        start = _root(self.text)
        groups = {member.key: member.start for member in json_text.members(self.text, start) if member.key in _GROUPS}
        old = {kind: _of_kind(self.state, kind) for kind in ElementKind}
        new = {kind: _of_kind(state, kind) for kind in ElementKind}
        changed: dict[str, str | None] = {}
        appended: dict[str, str] = {}
        for group, kind in _GROUPS.items():
            if old[kind] == new[kind]:
                continue
            if group in groups:
                changed[group] = _rewrite_group(self.text, groups[group], old[kind], new[kind])
            else:
                appended[group] = _rewrite_group("{}", 0, {}, new[kind])
        if not changed and not appended:
            return self.text.encode()
        body = json_text.rewrite_object(self.text, start, changed, appended)
        return f"{self.text[:start]}{body}{self.text[self.text.rindex('}') + 1 :]}".encode()


def read_map(path: Path) -> MapDocument:
    """The map file at ``path``. Raises InvalidInput naming file, element, key and the mend."""
    return parse_map(read_bytes(path, most_bytes=LIMITS.size), path.name)


def parse_map(data: bytes, file_name: str) -> MapDocument:
    """The map in ``data``. Raises InvalidInput naming file, element, key and the mend."""
    document = parse_json(data, file_name, LIMITS, _locate)
    try:
        root = _require_object(document.value, Place())
        for group in _REQUIRED:
            if group not in root:
                raise InvalidInput("is missing", "An AV2 map needs it, if only as {}.", Place(key=group))
        state = MapState.of(
            _parse_element(group, kind, key, value)
            for group, kind in _GROUPS.items()
            for key, value in _require_object(root.get(group, {}), Place(key=group)).items()
        )
        areas = _require_object(root[_DRIVABLE_AREAS], Place(key=_DRIVABLE_AREAS))
        rings = dict(_parse_area(key, value) for key, value in areas.items())
    except InvalidInput as error:
        raise error.within(file=file_name) from None
    return MapDocument(file_name, document.text, state, MappingProxyType(rings))


def _locate(path: JsonPath) -> Place:
    """Name the element that a path leads into, and the rest of the path as the key."""
    if len(path) >= 2 and path[0] in _WORDS:
        return Place(element=f"{_WORDS[str(path[0])]} {path[1]!s:.40}", key=path_text(path[2:]) or None)
    return Place(key=path_text(path) or None)


def _require_object(value: Any, place: Place) -> dict[str, Any]:
    if not isinstance(value, dict):
        raise InvalidInput("is not an object", "Write a JSON object in braces.", place)
    return value


def _parse_element(group: str, kind: ElementKind, key: str, value: Any) -> Element:
    name = f"{_WORDS[group]} {key:.40}"
    try:
        element = parse_element(kind, _require_object(value, Place()))
        _require_own_key(key, element.id, group)
    except InvalidInput as error:
        raise error.within(element=name) from None
    return element


def _parse_area(key: str, value: Any) -> tuple[int, Line]:
    try:
        area = _require_object(value, Place())
        for name in ("area_boundary", "id"):
            if name not in area:
                raise InvalidInput("is missing", "A drivable_area needs area_boundary and id.", Place(key=name))
        identity = parse_id(area["id"])
        _require_own_key(key, identity, _DRIVABLE_AREAS)
        return identity, parse_line(area["area_boundary"], "area_boundary")
    except InvalidInput as error:
        raise error.within(element=f"drivable_area {key:.40}") from None


def _require_own_key(key: str, identity: int, group: str) -> None:
    if key != str(identity):
        raise InvalidInput(
            f"is {identity}, but the element stands under the key {key[:40]!r} of {group}",
            "Make the object key and the id the same.",
            Place(key="id"),
        )


def _root(text: str) -> int:
    return json_text.skip_space(text, len(BYTE_ORDER_MARK) if text.startswith(BYTE_ORDER_MARK) else 0)


def _of_kind(state: MapState, kind: ElementKind) -> Mapping[int, Element]:
    return state.lanes if kind is ElementKind.LANE_SEGMENT else state.crossings


def _rewrite_group(text: str, start: int, old: Mapping[int, Element], new: Mapping[int, Element]) -> str:
    changed: dict[str, str | None] = {}
    for member in json_text.members(text, start):
        was, now = old[int(member.key)], new.get(int(member.key))
        if now is None:
            changed[member.key] = None
        elif now != was:
            changed[member.key] = _rewrite_element(text, member.start, was, now)
    appended = {str(i): json.dumps(element_attributes(new[i]), allow_nan=False) for i in sorted(new.keys() - old)}
    return json_text.rewrite_object(text, start, changed, appended)


def _rewrite_element(text: str, start: int, was: Element, now: Element) -> str:
    optional = OPTIONAL_FIELDS[was.key.kind]
    fields = {**FIELDS[was.key.kind], **optional}
    changed: dict[str, str | None] = {}
    written: set[str] = set()
    for member in json_text.members(text, start):
        written.add(member.key)
        field = fields.get(member.key)
        if field is None or getattr(was, field) == getattr(now, field):
            continue
        value = attribute_value(getattr(now, field))
        if isinstance(value, list) and isinstance(member.value, list):
            changed[member.key] = _rewrite_list(text, member.start, value)
        else:
            changed[member.key] = (
                None if value is None and member.key in optional else json.dumps(value, allow_nan=False)
            )
    known = element_attributes(now)
    appended = {name: json.dumps(known[name], allow_nan=False) for name in optional if name in known.keys() - written}
    return json_text.rewrite_object(text, start, changed, appended)


def _rewrite_list(text: str, start: int, values: list[Any]) -> str:
    """The list anew, with the points and ids that it had before still written as they were."""
    known = {_identity(value): written for written, value in json_text.items(text, start)}
    return "[" + ", ".join(known.get(_identity(v)) or json.dumps(v, allow_nan=False) for v in values) + "]"


def _identity(item: Any) -> Any:
    return (item["x"], item["y"], item["z"]) if isinstance(item, dict) else item
