"""``lanewright check``: exit codes for pipelines, the contract's JSON, and mends in words."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from tests.cli.two_maps import FIXTURES, Map, expected, fixture, lanewright, two_files

from lanewright.core.attributes import FIELDS
from lanewright.core.edits import Edit, Operation, apply_edits
from lanewright.core.elements import ElementKind
from lanewright.core.rules import check
from lanewright.formats.map_pair import read_map_pair

NAMES = sorted(path.stem for path in FIXTURES.glob("*.json"))


@pytest.mark.parametrize("name", NAMES)
def test_json_and_exit_code_are_the_contracts(name: str):
    told = lanewright("check", fixture(name), "--json")
    document = json.loads(told.stdout)
    assert list(document) == ["violations"]
    found = [(one["code"], one["elements"]) for one in document["violations"] if not one["inherited"]]
    wanted = [(one["code"], sorted(one["elements"])) for one in expected(name)["violations"]]
    assert sorted(found) == sorted(wanted)
    blocks = any(one["severity"] == "error" and not one["inherited"] for one in document["violations"])
    assert told.exit_code == (1 if blocks else 0)
    assert [one["id"] for one in document["violations"]] == sorted(one["id"] for one in document["violations"])
    assert lanewright("check", fixture(name)).exit_code == told.exit_code


@pytest.mark.parametrize("name", ["lane_added_left", "link_cut", "crossing_moved_replaced", "marks_mid_lane"])
def test_fixes_in_the_json_can_be_applied_as_they_stand(name: str):
    maps = read_map_pair(fixture(name))
    document = json.loads(lanewright("check", fixture(name), "--json").stdout)
    (violation,) = document["violations"]
    edits = [
        Edit(Operation(one["operation"]), ElementKind(one["kind"]), one["id"], one["attributes"])
        for one in violation["fixes"][0]["edits"]
    ]
    assert edits
    assert check(maps.base.state, apply_edits(maps.edited.state, edits)) == ()


def test_violations_are_told_with_their_mend():
    told = lanewright("check", fixture("lane_added_left"))
    assert told.exit_code == 1
    lines = told.stdout.splitlines()
    assert lines[0].endswith("1 violation.")
    assert lines[2] == "insertion.not_rightmost"
    assert "lane 1" in lines[3]
    assert lines[4].startswith("  mend: ")


def cross_sides(edited: Map) -> None:
    lane = edited["lane_segments"]["1"]
    lane["left_lane_boundary"], lane["right_lane_boundary"] = lane["right_lane_boundary"], lane["left_lane_boundary"]


def test_broken_geometry_is_told_with_the_rules_mend(tmp_path: Path):
    """It has no fix, as only a person can say how the lane runs."""
    told = lanewright("check", *two_files(tmp_path, "unchanged", lambda _base, edited: cross_sides(edited)))
    assert told.exit_code == 1
    assert "geometry.invalid" in told.stdout
    mend = told.stdout.partition("geometry.invalid")[2].partition("mend: ")[2]
    assert len(mend.splitlines()[0]) > 10


def test_defects_that_the_base_has_do_not_count(tmp_path: Path):
    def spoil(base: Map, edited: Map) -> None:
        cross_sides(base)
        cross_sides(edited)

    told = lanewright("check", *two_files(tmp_path, "unchanged", spoil))
    assert told.exit_code == 0
    assert "geometry.invalid, inherited" in told.stdout


@pytest.mark.shared
def test_real_maps_against_themselves(real_logs: list[Path]):
    for folder in real_logs:
        (path,) = (folder / "map").glob("log_map_archive_*.json")
        assert "no changes" in lanewright("diff", path, path).stdout
        told = lanewright("check", path, path)
        assert told.exit_code == 0
        assert "no violations" in told.stdout


def test_fixtures_speak_av2():
    """The pair reader takes what AV2 writes: the attributes of a lane are the 11 of its files."""
    lane = expected("unchanged")["base"]["lane_segments"]["1"]
    assert set(lane) == set(FIELDS[ElementKind.LANE_SEGMENT])
