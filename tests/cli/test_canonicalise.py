"""``lanewright canonicalise``: a map file that av2 loads, with what was not touched written as it was."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from tests.cli.two_maps import FIXTURES, Map, expected, fixture, lanewright, two_files

NAMES = sorted(path.stem for path in FIXTURES.glob("*.json"))


@pytest.mark.parametrize("name", NAMES)
def test_what_comes_out_has_no_violation(name: str, tmp_path: Path):
    base, edited = two_files(tmp_path, name)
    out = tmp_path / "out.json"
    assert lanewright("canonicalise", base, edited, "-o", out).exit_code == 0
    document = json.loads(lanewright("check", base, out, "--json").stdout)
    assert [one["code"] for one in document["violations"] if not one["inherited"]] == []


@pytest.mark.parametrize("name", ["unchanged", "widened_right", "lane_added_right", "crossing_inserted"])
def test_canonical_maps_stay_the_same_bytes(name: str, tmp_path: Path):
    base, edited = two_files(tmp_path, name)
    told = lanewright("canonicalise", base, edited, "-o", tmp_path / "out.json")
    assert "canonical already" in told.stdout
    assert (tmp_path / "out.json").read_bytes() == edited.read_bytes()


def test_says_what_became_what_and_keeps_everything_else(tmp_path: Path):
    def add_remark(_base: Map, edited: Map) -> None:
        edited["lane_segments"]["100"]["remark"] = "a key of others"

    base, edited = two_files(tmp_path, "resegmented", add_remark)
    edited.write_text(edited.read_text().replace('"x": 20.0,', '"x": 20.000,'))
    out = tmp_path / "out.json"
    told = lanewright("canonicalise", base, edited, "-o", out)
    assert "lane 9 becomes lane 1\n" in told.stdout
    assert "lane 10 is joined" in told.stdout
    untouched = edited.read_text().partition('"100": ')[2].partition('"successors"')[0]
    assert '"x": 20.000,' in untouched
    assert untouched in out.read_text()
    lanes = json.loads(out.read_text())["lane_segments"]
    assert lanes["100"] == json.loads(edited.read_text())["lane_segments"]["100"] | {"successors": [1]}
    assert set(lanes) == set(expected("resegmented")["base"]["lane_segments"])


def test_a_recorded_cut_stands_in_the_file_and_is_read_back(tmp_path: Path):
    base, edited = two_files(tmp_path, "marks_mid_lane")
    out = tmp_path / "out.json"
    assert "lane 1 is cut" in lanewright("canonicalise", base, edited, "-o", out).stdout
    assert {key: lane.get("part_of") for key, lane in json.loads(out.read_text())["lane_segments"].items()} == {
        "100": None,
        "9": 1,
        "10": 1,
        "200": None,
    }
    told = json.loads(lanewright("diff", base, out, "--json").stdout)
    assert [(change["id"], change["categories"]) for change in told["changes"]] == [(10, ["marking"])]
    assert "Lane 10" in lanewright("diff", base, out).stdout
    assert lanewright("check", base, out).exit_code == 0
    again = tmp_path / "again.json"
    assert "canonical already" in lanewright("canonicalise", base, out, "-o", again).stdout
    assert again.read_bytes() == out.read_bytes()


def test_one_file_of_both_gives_a_map_of_its_own(tmp_path: Path):
    out = tmp_path / "out.json"
    assert lanewright("canonicalise", fixture("crossing_moved_replaced"), "-o", out).exit_code == 0
    assert set(json.loads(out.read_text())) == {"lane_segments", "pedestrian_crossings", "drivable_areas"}


def test_the_edited_file_can_be_written_over(tmp_path: Path):
    base, edited = two_files(tmp_path, "lane_added_left")
    assert lanewright("canonicalise", base, edited, "-o", edited).exit_code == 0
    assert "canonical already" in lanewright("canonicalise", base, edited, "-o", edited).stdout
    assert sorted(path.name for path in tmp_path.iterdir()) == ["base.json", "edited.json"]


def test_place_that_cannot_be_written(tmp_path: Path):
    told = lanewright("canonicalise", fixture("unchanged"), "-o", tmp_path / "nowhere" / "out.json")
    assert told.exit_code == 2
    assert "cannot be written" in told.stderr
    told = lanewright("canonicalise", fixture("unchanged"), "-o", tmp_path)
    assert told.exit_code == 2
    assert "cannot be written" in told.stderr


@pytest.mark.shared
def test_renamed_real_map_gets_its_ids_back_and_loads_with_av2(real_logs: list[Path], tmp_path: Path):
    from av2.map.map_api import ArgoverseStaticMap

    (path,) = (real_logs[0] / "map").glob("log_map_archive_*.json")
    document = json.loads(path.read_text())
    shift = 1_000_000
    for lane in document["lane_segments"].values():
        for key in ("id", "left_neighbor_id", "right_neighbor_id"):
            if lane[key] is not None:
                lane[key] += shift
        for key in ("successors", "predecessors"):
            lane[key] = [other + shift for other in lane[key]]
    document["lane_segments"] = {str(lane["id"]): lane for lane in document["lane_segments"].values()}
    edited, out = tmp_path / "edited.json", tmp_path / "log_map_archive_x____PIT_city_1.json"
    edited.write_text(json.dumps(document))
    assert lanewright("canonicalise", path, edited, "-o", out).exit_code == 0
    assert json.loads(lanewright("diff", path, out, "--json").stdout) == {"changes": [], "updates": []}
    loaded = ArgoverseStaticMap.from_json(out)
    original = ArgoverseStaticMap.from_json(path)
    assert set(loaded.vector_lane_segments) == set(original.vector_lane_segments)
