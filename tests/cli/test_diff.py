"""``lanewright diff``: the contract's JSON, the same told to a person, and words for files that cannot be read."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest
from tests.cli.two_maps import FIXTURES, Map, expected, fixture, lanewright, two_files

NAMES = sorted(path.stem for path in FIXTURES.glob("*.json"))


@pytest.mark.parametrize("name", NAMES)
def test_json_is_the_contracts_for_one_file_and_for_two(name: str, tmp_path: Path):
    told = lanewright("diff", fixture(name), "--json")
    assert told.exit_code == 0
    document = json.loads(told.stdout)
    assert list(document) == ["changes", "updates"]
    assert {str(one["id"]): one["categories"] for one in document["changes"]} == expected(name)["changes"]
    assert document["updates"] == expected(name)["updates"]
    for change in document["changes"]:
        assert list(change) == ["id", "kind", "categories", "leaves", "old", "new"]
    assert lanewright("diff", *two_files(tmp_path, name), "--json").stdout == told.stdout


def test_json_is_the_same_bytes_in_every_process():
    outputs = {
        subprocess.run(
            [sys.executable, "-m", "lanewright.cli.main", "diff", str(fixture("split_by_branch")), "--json"],
            env=os.environ | {"PYTHONHASHSEED": seed},
            capture_output=True,
            check=True,
        ).stdout
        for seed in ("1", "2", "3")
    }
    assert len(outputs) == 1


def test_current_to_prior_is_told_from_prior_to_current():
    """The base is the current map then, so what the annotator took away came in."""
    made = json.loads(lanewright("diff", fixture("crossing_deleted"), "--json").stdout)
    told = json.loads(
        lanewright("diff", fixture("crossing_deleted"), "--direction", "current_to_prior", "--json").stdout
    )
    assert [one["categories"] for one in made["changes"]] == [["deletion"]]
    assert [one["categories"] for one in told["changes"]] == [["insertion"]]
    assert told["changes"][0]["new"] == made["changes"][0]["old"]
    words = lanewright("diff", fixture("crossing_deleted"), "--direction", "current_to_prior").stdout
    assert "inserted" in words
    assert "deleted" not in words.partition("told from")[2]


def test_told_to_a_person_update_by_update():
    lines = lanewright("diff", fixture("lane_added_right")).stdout.splitlines()
    assert lines[0].endswith("2 elements changed in 1 structural update.")
    assert lines[2].startswith("1. One lane more")
    assert "lane number +1" in lines[3]
    assert any(line.startswith("   - Lane 9 inserted") for line in lines)
    assert any(line.startswith("   - Lane 1 ") and " m " in line for line in lines)


def test_nothing_changed_is_said():
    assert "no changes" in lanewright("diff", fixture("unchanged")).stdout
    assert json.loads(lanewright("diff", fixture("vertex_on_line"), "--json").stdout) == {"changes": [], "updates": []}


def test_output_without_arrows_and_minus_signs():
    """An old terminal that knows only ASCII gets the text all the same."""
    told = subprocess.run(
        [sys.executable, "-m", "lanewright.cli.main", "diff", str(fixture("marking_left"))],
        env=os.environ | {"PYTHONIOENCODING": "ascii"},
        capture_output=True,
        check=False,
    )
    assert told.returncode == 0
    assert b"Lane 1 repainted" in told.stdout


def lost_boundary(_base: Map, edited: Map) -> None:
    del edited["lane_segments"]["1"]["left_lane_boundary"]


def wrong_mark(base: Map, _edited: Map) -> None:
    base["lane_segments"]["1"]["left_lane_mark_type"] = "PINK"


def lane_of_text(_base: Map, edited: Map) -> None:
    edited["lane_segments"]["1"] = "lane"


@pytest.mark.parametrize(
    ("spoil", "words"),
    [
        (lost_boundary, ["edited.json", "lane_segment 1", '"left_lane_boundary"', "is missing"]),
        (wrong_mark, ["base.json", "lane_segment 1", '"left_lane_mark_type"', "PINK", "Use one of"]),
        (lane_of_text, ["edited.json", "lane_segment 1", "is not an object"]),
    ],
)
@pytest.mark.parametrize("command", ["diff", "check", "canonicalise"])
def test_unreadable_maps_are_named(command: str, spoil: Callable[[Map, Map], None], words: list[str], tmp_path: Path):
    out = ["-o", tmp_path / "out.json"] if command == "canonicalise" else []
    told = lanewright(command, *two_files(tmp_path, "widened_right", spoil), *out)
    assert told.exit_code == 2
    assert told.stdout == ""
    assert told.stderr.count("\n") == 1
    for word in words:
        assert word in told.stderr


def test_two_files_of_one_name_are_told_apart(tmp_path: Path):
    (tmp_path / "prior").mkdir()
    good, bad = tmp_path / "map.json", tmp_path / "prior" / "map.json"
    good.write_text(json.dumps(expected("unchanged")["base"]))
    bad.write_text("{")
    assert str(bad) in lanewright("diff", good, bad).stderr


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (None, "is missing. Check the path."),
        ("[]", "is not a JSON object"),
        ("{}", '"base": is missing'),
        ('{"base": {}}', '"edited": is missing'),
        ('{"base": {}, "edited": {}}', 'pair.json, base, "lane_segments": is missing'),
        ('{"base": {}, "base": {}}', "stands twice"),
        ('{"base": 7, "edited": {}}', "is not an object"),
        ('{"base": NaN}', "NaN"),
        ("\ufeff{}", '"base": is missing'),
    ],
)
def test_bad_pairs_are_named(text: str | None, words: str, tmp_path: Path):
    path = tmp_path / "pair.json"
    if text is not None:
        path.write_text(text)
    told = lanewright("diff", path)
    assert told.exit_code == 2
    assert words in told.stderr
    assert "pair.json" in told.stderr


def test_pair_behind_a_byte_order_mark(tmp_path: Path):
    path = tmp_path / "pair.json"
    path.write_text("\ufeff" + fixture("marking_left").read_text())
    assert lanewright("diff", path, "--json").stdout == lanewright("diff", fixture("marking_left"), "--json").stdout


def test_folder_instead_of_a_file(tmp_path: Path):
    told = lanewright("diff", tmp_path)
    assert told.exit_code == 2
    assert "is not a file" in told.stderr
