"""Hostile maps through the readers and the whole engine: an answer or a clear refusal, never a crash."""

from __future__ import annotations

import json
from copy import deepcopy
from pathlib import Path
from typing import Any

import pytest
from hypothesis import HealthCheck, assume, example, given, settings
from hypothesis import strategies as st
from tests.fuzz.hostile_maps import Document, pairs_of_documents

from lanewright.core.canonical import canonicalise
from lanewright.core.changes import Direction
from lanewright.core.claims import DeclaredMacros
from lanewright.core.comparison import Comparison
from lanewright.core.diff import diff, diff_of, invert
from lanewright.core.edits import apply_edits, edits_between
from lanewright.core.elements import MapState
from lanewright.core.errors import InvalidInput
from lanewright.core.report import check_document, diff_document
from lanewright.core.restore import restore
from lanewright.core.rules import check, findings
from lanewright.core.sentences import describe_update, exported_as, sentence
from lanewright.formats.annotation import parse_annotation
from lanewright.formats.av2_map import parse_map
from lanewright.formats.map_pair import read_map_pair

FIXES_TRIED = 4
SLOW = [HealthCheck.too_slow, HealthCheck.data_too_large, HealthCheck.large_base_example]


def parsed(document: Document) -> MapState:
    return parse_map(json.dumps(document).encode(), "map.json").state


@settings(max_examples=60, suppress_health_check=SLOW)
@given(pairs_of_documents())
def test_every_question_has_an_answer(pair: tuple[Document, Document]):
    base, edited = map(parsed, pair)
    comparison = Comparison(base, edited)
    changes = diff_of(comparison)
    json.dumps(diff_document(changes), allow_nan=False)
    for change in changes.changes:
        assert str(sentence(change, comparison.base, comparison.edited)).endswith(".")
        for direction in Direction:
            exported_as(change, comparison.base, comparison.edited, direction)
    for update in changes.updates:
        assert str(describe_update(update, changes.changes, comparison.base, comparison.edited))
    assert {key for update in changes.updates for key in update.elements} == {one.key for one in changes.changes}
    assert invert(changes) == diff(edited, base)
    violations = check(base, edited)
    json.dumps(check_document(violations), allow_nan=False)
    assert all(violation.message for violation in violations)
    for violation in violations[:FIXES_TRIED]:
        for fix in violation.fixes:
            left = findings(Comparison(base, apply_edits(edited, fix.edits)))
            assert violation.id not in {one.id for one in left}
    restored = restore(base, edited)
    assert apply_edits(edited, edits_between(edited, restored)) == restored


@settings(max_examples=60, suppress_health_check=SLOW)
@given(pairs_of_documents())
def test_what_is_not_touched_is_not_blamed(pair: tuple[Document, Document]):
    base = parsed(pair[0])
    assert diff(base, base).changes == ()
    assert not [one.id for one in check(base, base) if not one.inherited]
    assert restore(base, base) == base


@settings(max_examples=40, suppress_health_check=SLOW)
@given(pairs_of_documents())
def test_canonical_form_can_be_written_and_read(pair: tuple[Document, Document]):
    base, edited = map(parsed, pair)
    canonical = canonicalise(base, edited)
    document = parse_map(json.dumps(pair[1]).encode(), "edited.json")
    read = parse_map(document.render(canonical), "out.json").state
    assert set(read.lanes) == set(canonical.lanes)
    assert read.crossings == canonical.crossings
    assume(not has_twins(base) and not has_twins(edited))
    assert diff(canonical, canonicalise(base, canonical)).changes == ()
    assert diff(base, canonicalise(base, base)).changes == ()


def has_twins(state: MapState) -> bool:
    """Whether two lanes have the same lines: nothing but their ids tells which is which."""
    return len({(lane.left_boundary, lane.right_boundary) for lane in state.lanes.values()}) < len(state.lanes)


SPOILERS: list[Any] = [
    None, True, -1, 0, 1.5, 1e309, float("nan"), 2**53, 10**30, "", "1", "\0", "\ud800", [], [None], {}, {"x": 1},
    [{"x": 1, "y": 1, "z": 1}], [[0, 0, 0], [1, 1, 1]], {"1": {}}, "9" * 400, [0] * 1001,
]  # fmt: skip


@st.composite
def spoilt_documents(draw: st.DrawFn) -> Document:
    """A pair as one file, with one value somewhere replaced by nonsense, or gone."""
    base, edited = draw(pairs_of_documents())
    document: dict[str, Any] = {"base": base, "edited": edited}
    _spoil(draw, document)
    return document


def _spoil(draw: st.DrawFn, document: Document) -> None:
    at: Any = document
    places: list[Any] = []
    while isinstance(at, dict | list) and at:
        key = draw(st.sampled_from(sorted(at) if isinstance(at, dict) else range(len(at))))
        places.append((at, key))
        at = at[key]
    holder, key = draw(st.sampled_from(places))
    if draw(st.booleans()):
        holder[key] = deepcopy(draw(st.sampled_from(SPOILERS)))  # what was put in may be spoilt next
    else:
        del holder[key]


@settings(max_examples=150, suppress_health_check=[*SLOW, HealthCheck.function_scoped_fixture])
@given(document=spoilt_documents())
def test_spoilt_files_are_read_or_refused_in_words(document: Document, tmp_path: Path):
    path = tmp_path / "pair.json"
    path.write_text(json.dumps(document))
    _read_or_refuse(path)


@settings(max_examples=150, suppress_health_check=[*SLOW, HealthCheck.function_scoped_fixture])
@given(document=pairs_of_documents(), cut=st.floats(0, 1), junk=st.binary(max_size=8))
@example(document=({}, {}), cut=0.0, junk=b"")
def test_torn_files_are_refused_in_words(document: Document, cut: float, junk: bytes, tmp_path: Path):
    data = json.dumps({"base": document[0], "edited": document[1]}).encode()
    at = int(cut * len(data))
    path = tmp_path / "pair.json"
    path.write_bytes(data[:at] + junk + data[at + len(junk) :])
    _read_or_refuse(path)
    path.write_bytes(data[:at])
    if at < len(data):
        with pytest.raises(InvalidInput):
            read_map_pair(path)


def _read_or_refuse(path: Path) -> None:
    refusal = None
    try:
        maps = read_map_pair(path)
        check(maps.base.state, maps.edited.state)
    except InvalidInput as error:
        refusal = error
    assert refusal is None or (str(refusal).startswith(str(path)) and refusal.mend)


@settings(max_examples=100, suppress_health_check=SLOW)
@given(pairs_of_documents())
def test_the_diff_is_read_back_as_the_annotation_that_it_is(pair: tuple[Document, Document]):
    """Lanes and crossings share ids here, and updates name elements by their ids alone."""
    base, edited = map(parsed, pair)
    derived = diff(base, edited)
    claims = parse_annotation(json.dumps(diff_document(derived)).encode(), "changes.json", base, edited)
    assert [(one.key, one.categories) for one in claims.annotated] == [
        (one.key, tuple(sorted(one.categories))) for one in derived.changes
    ]
    assert set(claims.declared) == {DeclaredMacros(one.elements, one.macros) for one in derived.updates}


@st.composite
def spoilt_annotations(draw: st.DrawFn) -> tuple[MapState, MapState, Document]:
    """Two maps, and what the diff says of them with up to three values replaced by nonsense, or gone."""
    base, edited = map(parsed, draw(pairs_of_documents()))
    document: Document = json.loads(json.dumps(diff_document(diff(base, edited))))
    for _ in range(draw(st.integers(1, 3))):
        if document:
            _spoil(draw, document)
    return base, edited, document


@settings(max_examples=100, suppress_health_check=SLOW)
@given(spoilt_annotations())
def test_spoilt_annotations_are_checked_or_refused_in_words(spoilt: tuple[MapState, MapState, Document]):
    base, edited, document = spoilt
    refusal = None
    try:
        claims = parse_annotation(json.dumps(document).encode(), "changes.json", base, edited)
        json.dumps(check_document(check(base, edited, claims)), allow_nan=False)
    except InvalidInput as error:
        refusal = error
    assert refusal is None or (str(refusal).startswith("changes.json") and refusal.mend)
