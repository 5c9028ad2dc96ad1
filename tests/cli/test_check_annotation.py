"""``lanewright check --annotation``: what somebody else annotated, against what follows from the maps."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from tests.cli.two_maps import FIXTURES, fixture, lanewright, two_files

NAMES = sorted(path.stem for path in FIXTURES.glob("*.json"))
UPDATE = "lane_added_right"
"""Lane 9 is inserted to the right of lane 1, which makes room."""


def derived(name: str) -> dict[str, Any]:
    document: dict[str, Any] = json.loads(lanewright("diff", fixture(name), "--json").stdout)
    return document


def written(folder: Path, document: Any) -> Path:
    path = folder / "changes.json"
    path.write_text(json.dumps(document))
    return path


def violations(*arguments: str | Path) -> list[dict[str, Any]]:
    found: list[dict[str, Any]] = json.loads(lanewright("check", *arguments, "--json").stdout)["violations"]
    return found


@pytest.mark.parametrize("name", NAMES)
def test_what_diff_writes_is_right(name: str, tmp_path: Path):
    annotation = written(tmp_path, derived(name))
    with_it = lanewright("check", fixture(name), "--annotation", annotation)
    assert with_it.exit_code == lanewright("check", fixture(name)).exit_code
    told, alone = violations(fixture(name), "--annotation", annotation), violations(fixture(name))
    assert [(one["id"], one["message"]) for one in told] == [(one["id"], one["message"]) for one in alone]


def test_a_right_annotation_is_no_violation_and_the_file_is_named(tmp_path: Path):
    annotation = written(tmp_path, derived(UPDATE))
    told = lanewright("check", *two_files(tmp_path, UPDATE), "--annotation", annotation)
    assert told.exit_code == 0
    assert told.stdout.strip().endswith(f"annotated in {annotation}: no violations.")


@pytest.mark.parametrize("given", ["changes", "updates"])
def test_half_an_annotation_is_enough(given: str, tmp_path: Path):
    annotation = written(tmp_path, {given: derived(UPDATE)[given]})
    assert lanewright("check", fixture(UPDATE), "--annotation", annotation).exit_code == 0


def test_an_inserted_lane_that_is_annotated_as_moved_too(tmp_path: Path):
    document = derived(UPDATE)
    (inserted,) = (one for one in document["changes"] if one["id"] == 9)
    inserted["categories"] = ["insertion", "geometry"]
    told = lanewright("check", fixture(UPDATE), "--annotation", written(tmp_path, document))
    assert told.exit_code == 1
    lines = told.stdout.splitlines()
    assert lines[2] == "change.exclusive"
    assert "Lane segment 9 is annotated as insertion and as geometry" in lines[3]
    assert lines[4].startswith("  mend: Take the derived categories")


def test_macros_that_do_not_follow_are_told_with_those_that_do(tmp_path: Path):
    document = derived(UPDATE)
    document["updates"][0]["macros"] |= {"shape": False, "function": True, "lane_number": 2}
    told = violations(fixture(UPDATE), "--annotation", written(tmp_path, document))
    assert [one["code"] for one in told] == ["macro.mismatch"]
    assert told[0]["elements"] == [1, 9]
    for words in ("shape is missing", "function is extra", "lane number is +1, not +2"):
        assert words in told[0]["message"]

    mended = {"updates": told[0]["fixes"][0]["declarations"]}
    assert lanewright("check", fixture(UPDATE), "--annotation", written(tmp_path, mended)).exit_code == 0


def test_macros_of_an_update_that_is_none(tmp_path: Path):
    """Lane 1 is in both maps and the same in both."""
    macros = derived(UPDATE)["updates"][0]["macros"]
    annotation = written(tmp_path, {"updates": [{"elements": [1], "macros": macros}]})
    told = lanewright("check", fixture("unchanged"), "--annotation", annotation)
    assert told.exit_code == 1
    assert "macro.mismatch" in told.stdout


def test_an_annotation_of_other_maps_is_refused(tmp_path: Path):
    document = derived(UPDATE)
    document["changes"][0]["id"] = 4711
    told = lanewright("check", fixture(UPDATE), "--annotation", written(tmp_path, document))
    assert told.exit_code == 2
    assert told.stdout == ""
    assert 'changes.json, lane_segment 4711, "changes[0]": is in neither map. Check the id' in told.stderr
    assert told.stderr.count("\n") == 1


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (None, "changes.json: is missing. Check the path."),
        ("{", "changes.json: is broken or cut short at line 1"),
        ("{}", "changes.json: has neither changes nor updates"),
        ('{"changes": [{"id": 1, "kind": "lane", "categories": ["geometry"]}]}', "\"changes[0].kind\": is 'lane'"),
    ],
)
def test_unreadable_annotations_are_named(text: str | None, words: str, tmp_path: Path):
    path = tmp_path / "changes.json"
    if text is not None:
        path.write_text(text)
    told = lanewright("check", fixture(UPDATE), "--annotation", path)
    assert told.exit_code == 2
    assert told.stdout == ""
    assert f"{tmp_path}/" in told.stderr
    assert words in told.stderr


def test_a_folder_is_no_annotation(tmp_path: Path):
    told = lanewright("check", fixture(UPDATE), "--annotation", tmp_path)
    assert told.exit_code == 2
    assert f"{tmp_path}: is not a file" in told.stderr
