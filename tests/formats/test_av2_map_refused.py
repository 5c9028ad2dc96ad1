"""Bad map files: each is refused with the file, the element, the key and the mend."""

from __future__ import annotations

import copy
import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from lanewright.core.errors import InvalidInput
from lanewright.formats.av2_map import parse_map, read_map

Map = dict[str, Any]


def refusal(data: bytes) -> InvalidInput:
    with pytest.raises(InvalidInput) as caught:
        parse_map(data, "map.json")
    return caught.value


def text_replaced(old: str, new: str) -> Callable[[Map], bytes]:
    def spoil(value: Map) -> bytes:
        text = json.dumps(value)
        assert old in text
        return text.replace(old, new, 1).encode()

    return spoil


def lane_with(**changes: Any) -> Callable[[Map], bytes]:
    def spoil(value: Map) -> bytes:
        value["lane_segments"]["11"] |= changes
        return json.dumps(value).encode()

    return spoil


def without(*path: str) -> Callable[[Map], bytes]:
    def spoil(value: Map) -> bytes:
        parent = value
        for key in path[:-1]:
            parent = parent[key]
        del parent[path[-1]]
        return json.dumps(value).encode()

    return spoil


BAD_FILES: list[tuple[str, Callable[[Map], bytes], str | None, str | None, str, str]] = [
    # name, how it is spoilt, element, key, problem, mend
    ("truncated", lambda m: json.dumps(m).encode()[:-40], None, None, "cut short at line 1", "the whole of it again"),
    ("empty", lambda m: b"", None, None, "cut short at line 1", "the whole of it again"),
    ("depth bomb", lambda m: b'{"a":' * 2_000_000, None, None, "more than the 32 levels", "what was meant"),
    ("list bomb", lambda m: b"[" * 100_000 + b"]" * 100_000, None, None, "more than the 32 levels", "what was meant"),
    ("many values", lambda m: b"[" + b"0," * 2_100_000 + b"0]", None, None, "the 1,000,000 allowed", "what was meant"),
    ("bomb behind a string", lambda m: b'["\\\\", "\\"[", ' + b"[" * 40, None, None, "the 32 levels", "what was"),
    ("NaN under a key that stands twice", lambda m: b'{"a": NaN, "a": 1}', None, None, "is NaN", "finite number"),
    ("too large", lambda m: b" " * (32 * 2**20 + 1), None, None, "32 MiB", "what was meant"),
    ("latin-1", lambda m: b'{"caf\xe9": 1}', None, None, "not UTF-8 text at byte 5", "UTF-8"),
    ("utf-16", lambda m: json.dumps(m).encode("utf-16"), None, None, "not UTF-8 text at byte 0", "UTF-8"),
    ("NaN", text_replaced('"x": 0.0, "y": 4.0', '"x": NaN, "y": 4.0'), "lane_segment 12",
     "left_lane_boundary[1].x", "is NaN", "finite number"),
    ("infinity", text_replaced('"x": 2.0', '"x": -Infinity'), "pedestrian_crossing 21",
     "edge1[0].x", "is -Infinity", "finite number"),
    ("1e308", text_replaced('"x": 2.0', '"x": 1e308'), "pedestrian_crossing 21", "edge1[0].x", "outside ±1000000 m",
     "city frame"),
    ("1e309", text_replaced('"x": 2.0', '"x": 1e309'), "pedestrian_crossing 21", "edge1[0].x", "is 1e309", "finite"),
    ("400 digits", text_replaced('"x": 2.0', f'"x": {"9" * 400}'), "pedestrian_crossing 21", "edge1[0].x",
     "400 digits", "sensible size"),
    ("200 digits", text_replaced('"x": 2.0', f'"x": {"9" * 200}'), "pedestrian_crossing 21", "edge1[0].x",
     "outside ±1000000 m", "city frame"),
    ("id beyond 2^63", text_replaced('"id": 11', f'"id": {2**63 + 1}'), "lane_segment 11", "id", "outside 0 to 2^53",
     "Renumber"),
    ("successor beyond 2^63", lane_with(successors=[2**63 + 1]), "lane_segment 11", "successors[0]", "outside 0 to",
     "Renumber"),
    ("negative id", text_replaced('"id": 11', '"id": -11'), "lane_segment 11", "id", "outside 0 to 2^53", "Renumber"),
    ("text id", text_replaced('"id": 11', '"id": "11"'), "lane_segment 11", "id", "not a whole number", "integer"),
    ("key is not the id", text_replaced('"id": 11', '"id": 13'), "lane_segment 11", "id", "under the key '11'",
     "the same"),
    ("NUL", lane_with(note="a\0b"), "lane_segment 11", "note", "NUL character \\u0000", "Remove it"),
    ("NUL in a key", lane_with(**{"a\0b": 1}), "lane_segment 11", None, "NUL character \\u0000", "Remove it"),
    ("lone surrogate", lane_with(note="\ud800"), "lane_segment 11", "note", "half a surrogate pair", "whole char"),
    ("duplicate key", text_replaced('"id": 11,', '"id": 11, "id": 11,'), "lane_segment 11", "id", "stands twice",
     "Keep one"),
    ("duplicate element", text_replaced('"11":', '"12": {}, "11":'), "lane_segment 12", None, "stands twice", "Keep"),
    ("duplicate group", text_replaced('"drivable_areas"', '"lane_segments": {}, "drivable_areas"'), None,
     "lane_segments", "stands twice", "Keep one"),
    ("bool as coordinate", text_replaced('"y": 4.0', '"y": true'), "lane_segment 12", "left_lane_boundary[0].y",
     "True, not a number", "metres"),
    ("null as z", text_replaced('"z": 1.5', '"z": null'), "lane_segment 12", "left_lane_boundary[0].z",
     "None, not a number", "metres"),
    ("bool as id", text_replaced('"id": 11', '"id": true'), "lane_segment 11", "id", "True, not a whole number", "int"),
    ("unknown mark", lane_with(left_lane_mark_type="DOUBLE_DASHED_YELLOW"), "lane_segment 11", "left_lane_mark_type",
     "'DOUBLE_DASHED_YELLOW', not a mark type", "DOUBLE_DASH_YELLOW"),
    ("list as mark", lane_with(left_lane_mark_type=["NONE"]), "lane_segment 11", "left_lane_mark_type",
     "not a mark type", "NONE"),
    ("lower-case lane type", lane_with(lane_type="vehicle"), "lane_segment 11", "lane_type", "'vehicle'", "VEHICLE"),
    ("text as flag", lane_with(is_intersection="no"), "lane_segment 11", "is_intersection", "'no'", "true or false"),
    ("null links", lane_with(predecessors=None), "lane_segment 11", "predecessors", "not a list", "empty list"),
    ("one point", lane_with(left_lane_boundary=[{"x": 0, "y": 0, "z": 0}]), "lane_segment 11", "left_lane_boundary",
     "has 1 points", "2 to 10000 points"),
    ("missing lane key", without("lane_segments", "11", "left_neighbor_id"), "lane_segment 11", "left_neighbor_id",
     "is missing", "needs id, is_intersection"),
    ("missing z", text_replaced(', "z": 1.5', ""), "lane_segment 12", "left_lane_boundary[0].z", "is missing", "x, y"),
    ("missing edge", without("pedestrian_crossings", "21", "edge2"), "pedestrian_crossing 21", "edge2", "is missing",
     "needs edge1, edge2, id"),
    ("missing area ring", without("drivable_areas", "31", "area_boundary"), "drivable_area 31", "area_boundary",
     "is missing", "needs area_boundary and id"),
    ("missing lanes", without("lane_segments"), None, "lane_segments", "is missing", "An AV2 map needs it"),
    ("missing areas", without("drivable_areas"), None, "drivable_areas", "is missing", "An AV2 map needs it"),
    ("list of lanes", lambda m: json.dumps(m | {"lane_segments": []}).encode(), None, "lane_segments",
     "not an object", "braces"),
    ("null lane", lambda m: json.dumps(m | {"lane_segments": {"1": None}}).encode(), "lane_segment 1", None,
     "not an object", "braces"),
    ("list at the root", lambda m: b"[]", None, None, "not an object", "braces"),
]  # fmt: skip


@pytest.mark.parametrize(
    ("spoil", "element", "key", "problem", "mend"), [b[1:] for b in BAD_FILES], ids=[b[0] for b in BAD_FILES]
)
def test_refused_with_place_and_mend(
    small_map: Map, spoil: Callable[[Map], bytes], element: str | None, key: str | None, problem: str, mend: str
) -> None:
    error = refusal(spoil(copy.deepcopy(small_map)))
    assert (error.place.file, error.place.element, error.place.key) == ("map.json", element, key)
    assert problem in error.message
    assert mend in error.mend
    assert error.message.startswith("map.json")
    assert len(str(error)) < 600


def test_the_small_map_itself_is_fine(small_map_bytes: bytes) -> None:
    document = parse_map(small_map_bytes, "map.json")
    assert list(document.state.lanes) == [12, 11]
    assert document.state.lanes[11].successors == (99,)
    assert document.drivable_areas[31][1] == (20.0, 0.0, 1.5)


def test_an_escaped_backslash_before_u0000_is_no_nul(small_map: Map) -> None:
    small_map["lane_segments"]["11"]["note"] = "\\u0000 and \\ud800, spelt out; a whole pair: \U0001f600"
    assert 11 in parse_map(json.dumps(small_map).encode(), "map.json").state.lanes


def test_size_is_checked_before_reading(tmp_path: Path) -> None:
    path = tmp_path / "log_map_archive_x.json"
    with path.open("wb") as file:
        file.truncate(50 * 2**30)  # sparse: reading it would exhaust the memory
    with pytest.raises(InvalidInput, match=r"log_map_archive_x\.json: is 51200\.0 MiB, more than the 32 MiB"):
        read_map(path)


def test_missing_file_and_folder_are_named(tmp_path: Path) -> None:
    with pytest.raises(InvalidInput, match=r"none\.json: is missing"):
        read_map(tmp_path / "none.json")
    (tmp_path / "folder.json").mkdir()
    with pytest.raises(InvalidInput, match=r"folder\.json: is not a regular file"):
        read_map(tmp_path / "folder.json")
