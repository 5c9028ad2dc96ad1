"""Annotations made elsewhere: read as the diff writes them, refused with the key and the mend."""

from __future__ import annotations

import copy
import json
from typing import Any

import pytest

from lanewright.core.changes import Category
from lanewright.core.claims import Claims
from lanewright.core.comparison import Comparison
from lanewright.core.diff import diff
from lanewright.core.elements import ElementKey, ElementKind, MapState
from lanewright.core.errors import InvalidInput
from lanewright.core.report import diff_document
from lanewright.core.rules import check_of
from lanewright.formats import annotation
from lanewright.formats.annotation import parse_annotation
from lanewright.formats.av2_map import parse_map
from lanewright.formats.json_document import Limits

Map = dict[str, Any]
LANE, CROSSING = ElementKind.LANE_SEGMENT, ElementKind.PEDESTRIAN_CROSSING
NOTHING = {"shape": False, "appearance": False, "function": False, "lane_graph": False, "lane_number": 0}
CHANGE = {"id": 11, "kind": "lane_segment", "categories": ["marking"]}
UPDATE = {"elements": [11], "macros": NOTHING}


def state(document: Map) -> MapState:
    return parse_map(json.dumps(document).encode(), "map.json").state


def read(document: Any, base: Map, edited: Map | None = None) -> Claims:
    return parse_annotation(
        json.dumps(document).encode(), "changes.json", state(base), state(base if edited is None else edited)
    )


def refusal(document: Any, base: Map) -> InvalidInput:
    with pytest.raises(InvalidInput) as caught:
        read(document, base)
    assert caught.value.place.file == "changes.json"
    assert caught.value.mend
    return caught.value


def repainted(document: Map) -> Map:
    edited = copy.deepcopy(document)
    edited["lane_segments"]["11"]["right_lane_mark_type"] = "SOLID_WHITE"
    return edited


def test_what_the_diff_writes_is_what_it_says(small_map: Map):
    edited = repainted(small_map)
    derived = diff(state(small_map), state(edited))
    claims = read(diff_document(derived), small_map, edited)
    assert [(one.key, one.categories, one.leaves, one.old, one.new) for one in claims.annotated] == [
        (one.key, one.categories, one.leaves, one.old, one.new) for one in derived.changes
    ]
    assert [(one.elements, one.macros) for one in claims.declared] == [
        (one.elements, one.macros) for one in derived.updates
    ]
    assert claims.annotated[0].categories == (Category.MARKING,)


def test_nothing_annotated_and_keys_of_others(small_map: Map):
    assert read({"changes": [], "updates": []}, small_map) == Claims()
    (change,) = read({"changes": [CHANGE | {"note": "mine"}], "made by": "us"}, small_map).annotated
    assert change.key == ElementKey(LANE, 11)
    assert (change.leaves, change.old, change.new) == ((), None, None)


def test_a_deleted_and_an_inserted_element_may_be_named(small_map: Map):
    edited = copy.deepcopy(small_map)
    edited["lane_segments"]["13"] = edited["lane_segments"].pop("12") | {"id": 13}
    claims = read({"updates": [{"elements": [13, 12], "macros": NOTHING}]}, small_map, edited)
    assert claims.declared[0].elements == (ElementKey(LANE, 12), ElementKey(LANE, 13))


@pytest.fixture
def shared_id(small_map: Map) -> Map:
    """The crossing has the id of lane 11, and lies 100 m away from it."""
    crossing = small_map["pedestrian_crossings"].pop("21") | {"id": 11}
    for edge in ("edge1", "edge2"):
        crossing[edge] = [point | {"x": point["x"] + 100.0} for point in crossing[edge]]
    small_map["pedestrian_crossings"]["11"] = crossing
    return small_map


def test_a_lane_and_a_crossing_of_one_id_are_told_apart_by_the_diff(shared_id: Map):
    edited = repainted(shared_id)
    edited["pedestrian_crossings"]["11"]["edge1"][0]["x"] += 1.0
    base, after = state(shared_id), state(edited)
    document = diff_document(diff(base, after))
    assert [one["elements"] for one in document["updates"]] == [[11], [11]]
    claims = read(document, shared_id, edited)
    assert [one.elements for one in claims.declared] == [(ElementKey(LANE, 11),), (ElementKey(CROSSING, 11),)]
    assert not [one for one in check_of(Comparison(base, after, claims)) if one.code == "macro.mismatch"]


def test_an_id_twice_means_the_lane_and_the_crossing(shared_id: Map):
    claims = read({"updates": [{"elements": [11, 12, 11], "macros": NOTHING}]}, shared_id)
    assert claims.declared[0].elements == (ElementKey(LANE, 11), ElementKey(LANE, 12), ElementKey(CROSSING, 11))


def test_an_id_that_could_mean_two_needs_its_kind(shared_id: Map):
    error = refusal({"updates": [{"elements": [12, 11], "macros": NOTHING}]}, shared_id)
    assert error.place.key == "updates[0].elements[1]"
    assert "a lane_segment and a pedestrian_crossing have" in error.problem
    named = {"elements": [12, {"kind": "pedestrian_crossing", "id": 11}], "macros": NOTHING}
    (declared,) = read({"updates": [named]}, shared_id).declared
    assert declared.elements == (ElementKey(LANE, 12), ElementKey(CROSSING, 11))


def changes(*given: Any) -> Any:
    return {"changes": list(given)}


def updates(*given: Any) -> Any:
    return {"updates": list(given)}


def without(document: Map, key: str) -> Map:
    return {name: value for name, value in document.items() if name != key}


BAD: list[tuple[Any, str | None, str]] = [
    # annotation, key, problem
    ([], None, "is not an object"),
    ({"diff": []}, None, "has neither changes nor updates"),
    ({"changes": {}}, "changes", "is not a list"),
    ({"updates": None}, "updates", "is not a list"),
    (changes(11), "changes[0]", "is not an object"),
    (changes(without(CHANGE, "id")), "changes[0].id", "is missing"),
    (changes(without(CHANGE, "kind")), "changes[0].kind", "is missing"),
    (changes(without(CHANGE, "categories")), "changes[0].categories", "is missing"),
    (changes(CHANGE | {"id": "11"}), "changes[0].id", "is '11', not a whole number"),
    (changes(CHANGE | {"id": True}), "changes[0].id", "not a whole number"),
    (changes(CHANGE | {"id": 2**53}), "changes[0].id", "outside 0 to 2^53 - 1"),
    (changes(CHANGE | {"kind": "lane"}), "changes[0].kind", "is 'lane', not a kind of element"),
    (changes(CHANGE | {"kind": ["lane_segment"]}), "changes[0].kind", "not a kind of element"),
    (changes(CHANGE | {"categories": "marking"}), "changes[0].categories", "is not a list"),
    (changes(CHANGE | {"categories": []}), "changes[0].categories", "is empty"),
    (changes(CHANGE | {"categories": ["marking", "paint"]}), "changes[0].categories[1]", "is 'paint', not a category"),
    (changes(CHANGE | {"categories": [{}]}), "changes[0].categories[0]", "not a category"),
    (changes(CHANGE | {"categories": ["type", "type"]}), "changes[0].categories", "names a category twice"),
    (changes(CHANGE | {"leaves": None}), "changes[0].leaves", "is not a list"),
    (changes(CHANGE | {"leaves": [1]}), "changes[0].leaves[0]", "is 1, not text"),
    (changes(CHANGE | {"old": []}), "changes[0].old", "is not an object"),
    (changes(CHANGE | {"new": "SOLID_WHITE"}), "changes[0].new", "is not an object"),
    (changes(CHANGE, CHANGE), "changes[1]", "stands in changes[0] already"),
    (changes(CHANGE | {"id": 21}), "changes[0]", "is in neither map"),
    (updates([11]), "updates[0]", "is not an object"),
    (updates(without(UPDATE, "elements")), "updates[0].elements", "is missing"),
    (updates(without(UPDATE, "macros")), "updates[0].macros", "is missing"),
    (updates(UPDATE | {"elements": []}), "updates[0].elements", "is empty"),
    (updates(UPDATE | {"elements": 11}), "updates[0].elements", "is not a list"),
    (updates(UPDATE | {"elements": [1.5]}), "updates[0].elements[0]", "is 1.5, not a whole number"),
    (updates(UPDATE | {"elements": [11, 13]}), "updates[0].elements[1]", "is 13, an element of neither map"),
    (updates(UPDATE | {"elements": [{"id": 11}]}), "updates[0].elements[0].kind", "is missing"),
    (updates(UPDATE | {"elements": [11, 11]}), "updates[0].elements[1]", "stands in updates[0].elements[0] already"),
    (updates(UPDATE, UPDATE), "updates[1].elements[0]", "stands in updates[0].elements[0] already"),
    (updates(UPDATE | {"macros": ["shape"]}), "updates[0].macros", "is not an object"),
    (updates(UPDATE | {"macros": NOTHING | {"colour": True}}), "updates[0].macros.colour", "is no macro"),
    (updates(UPDATE | {"macros": without(NOTHING, "shape")}), "updates[0].macros.shape", "is missing"),
    (updates(UPDATE | {"macros": without(NOTHING, "lane_number")}), "updates[0].macros.lane_number", "is missing"),
    (updates(UPDATE | {"macros": NOTHING | {"shape": 1}}), "updates[0].macros.shape", "is 1, not true or false"),
    (updates(UPDATE | {"macros": NOTHING | {"lane_number": True}}), "updates[0].macros.lane_number", "is True, not a"),
    (updates(UPDATE | {"macros": NOTHING | {"lane_number": 1.0}}), "updates[0].macros.lane_number", "is 1.0, not a"),
]


@pytest.mark.parametrize(("document", "key", "problem"), BAD, ids=lambda value: value if isinstance(value, str) else "")
def test_refused_with_the_key(document: Any, key: str | None, problem: str, small_map: Map):
    error = refusal(document, small_map)
    assert error.place.key == key
    assert problem in error.problem


def test_the_element_that_is_in_neither_map_is_named(small_map: Map):
    assert refusal(changes(CHANGE | {"id": 4711}), small_map).place.element == "lane_segment 4711"


@pytest.mark.parametrize(
    ("data", "problem"),
    [
        (b"", "cut short at line 1"),
        (b'{"changes": [NaN]}', "is NaN"),
        (b'{"changes": [], "changes": []}', "stands twice"),
        (b"\xff", "is not UTF-8"),
        (b'{"changes": ' + b"[" * 100, "nests more than"),
    ],
)
def test_broken_json_is_refused(data: bytes, problem: str, small_map: Map):
    with pytest.raises(InvalidInput) as caught:
        parse_annotation(data, "changes.json", state(small_map), state(small_map))
    assert str(caught.value).startswith("changes.json")
    assert problem in caught.value.problem


@pytest.mark.parametrize("limits", [Limits(size=100), Limits(nodes=20)])
def test_too_large_is_refused(limits: Limits, small_map: Map, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(annotation, "LIMITS", limits)
    assert "allowed" in refusal(changes(*[CHANGE] * 10), small_map).problem


def test_a_byte_order_mark_is_no_obstacle(small_map: Map):
    data = "\ufeff" + json.dumps(changes(CHANGE))
    (change,) = parse_annotation(data.encode(), "changes.json", state(small_map), state(small_map)).annotated
    assert change.id == 11
