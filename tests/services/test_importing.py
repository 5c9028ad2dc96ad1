"""Importing logs: without loss, once, and not at all when something in them is wrong."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from types import MappingProxyType
from typing import Any

import numpy as np
import pytest
from sqlalchemy import select
from sqlalchemy.orm import Session
from tests.api.desk import table_counts
from tests.services.log_folder import LOG_ID, map_path, write_log, write_map
from tests.stored_logs import lane, small_map

from lanewright.core.changes import Direction
from lanewright.core.errors import Conflict, InvalidInput
from lanewright.db.models import Log
from lanewright.db.repositories import elements, logs
from lanewright.formats.av2_map import parse_map
from lanewright.formats.splits import SourceSplits, Split
from lanewright.services.ground import ground_of
from lanewright.services.id_blocks import LARGEST_NEW_ID, free_range
from lanewright.services.importing import Outcome, Placing, find_logs, import_log
from lanewright.services.verify import subjects, verify

TEST = Placing(SourceSplits(), release=Split.TEST, direction=Direction.PRIOR_TO_CURRENT)


@pytest.mark.shared
def test_real_logs_come_back_byte_for_byte(session: Session, real_logs: list[Path]) -> None:
    for folder in real_logs:
        assert import_log(session, folder, TEST).outcome is Outcome.IMPORTED
    for log in session.scalars(select(Log)):
        stored = elements.load(session, log.line_id, 0).state
        (file,) = next(folder for folder in real_logs if folder.name == log.log_id).glob("map/log_map_archive_*.json")
        assert parse_map(log.map_document, log.map_file_name).render(stored) == file.read_bytes()
        assert len(stored) == log.summary["lanes"] + log.summary["crossings"] > 190
    assert [found for subject in subjects(session) for found in verify(session, subject)] == []


def test_the_same_log_again_changes_nothing(session: Session, tmp_path: Path) -> None:
    folder = write_log(tmp_path)
    first = import_log(session, folder, TEST)
    counts = table_counts(session)
    again = import_log(session, folder, Placing(SourceSplits()))
    assert (first.outcome, again.outcome) == (Outcome.IMPORTED, Outcome.UNCHANGED)
    assert (again.lanes, again.crossings) == (2, 1)
    assert table_counts(session) == counts


def test_another_map_under_the_same_id_is_refused(session: Session, tmp_path: Path) -> None:
    folder = write_log(tmp_path)
    import_log(session, folder, TEST)
    counts = table_counts(session)
    write_map(folder, json.dumps(small_map(), indent=1))
    with pytest.raises(Conflict, match="its map differs"):
        import_log(session, folder, TEST)
    np.save(folder / "map" / f"{LOG_ID}_ground_height_surface____WDC.npy", np.full((9, 9), 3.25, np.float16))
    write_map(folder, json.dumps(small_map()))
    with pytest.raises(Conflict, match="sensors or calibration differ"):
        import_log(session, folder, TEST)
    assert table_counts(session) == counts


def test_a_log_keeps_its_place(session: Session, tmp_path: Path) -> None:
    folder = write_log(tmp_path)
    import_log(session, folder, TEST)
    elsewhere = [
        Placing(SourceSplits(), release=Split.TRAIN),
        Placing(SourceSplits(), direction=Direction.CURRENT_TO_PRIOR),
        Placing(SourceSplits(), source=Split.VAL),
    ]
    for placing in elsewhere:
        with pytest.raises(Conflict) as refused:
            import_log(session, folder, placing)
        assert refused.value.code == "log.placed_differently"


@pytest.mark.parametrize(
    ("source", "asked", "place"),
    [
        (Split.TRAIN, None, ("train", "train", "current_to_prior")),
        (Split.TRAIN, Split.VAL, ("train", "val", "current_to_prior")),
        (Split.VAL, None, ("val", "test", "prior_to_current")),
    ],
)
def test_source_split_release_split_and_direction_are_three_things(
    session: Session, tmp_path: Path, source: Split, asked: Split | None, place: tuple[str, str, str]
) -> None:
    listed = SourceSplits(MappingProxyType({LOG_ID: source}))
    import_log(session, write_log(tmp_path), Placing(listed, release=asked))
    log = session.scalars(select(Log)).one()
    assert (log.source_split, log.release_split, log.direction) == place


def test_a_log_in_no_list_needs_its_place_said(session: Session, tmp_path: Path) -> None:
    folder = write_log(tmp_path)
    with pytest.raises(InvalidInput, match="Say --split and --direction"):
        import_log(session, folder, Placing(SourceSplits()))
    listed = SourceSplits(MappingProxyType({LOG_ID: Split.VAL}))
    with pytest.raises(InvalidInput, match="splits file"):
        import_log(session, folder, Placing(listed, source=Split.TRAIN))
    import_log(session, folder, Placing(SourceSplits(), source=Split.VAL))
    assert session.scalars(select(Log.source_split)).one() == "val"


def test_what_is_kept_of_a_log(session: Session, tmp_path: Path) -> None:
    import_log(session, write_log(tmp_path), TEST)
    log = session.scalars(select(Log)).one()
    assert set(logs.asset_hashes(session, log.id)) == {"drivable_areas.json", "sensors.json", "ground.npy", "sim2.json"}
    assert log.summary["bounds"] == [0.0, 0.0, 20.0, 8.0]
    kept = json.loads(logs.asset_body(session, log.id, "sensors.json"))
    assert kept["frames"][0]["timestamp_ns"] == "315966265259836000"
    assert [frame["pose"]["tx_m"] for frame in kept["frames"]] == pytest.approx([0.0, 5.1, 10.3, 15.4], abs=0.1)
    assert kept["trajectory"][-1] == [20.0, 2.0, 1.5]
    assert ground_of(session, log.id)(5.0, 2.0) == 3.25


def test_new_ids_start_above_all_that_the_map_names(session: Session, tmp_path: Path) -> None:
    world = small_map()
    world["lane_segments"]["11"] = lane(11, successors=[99], predecessors=[5000], right_neighbor_id=6000)
    import_log(session, write_log(tmp_path, map_text=json.dumps(world)), TEST)
    assert session.scalars(select(Log.next_new_id)).one() == 6001


@pytest.mark.parametrize(
    ("used", "expected"),
    [
        ([], (1, LARGEST_NEW_ID)),
        ([7, 38_109_167], (38_109_168, LARGEST_NEW_ID)),
        ([7, 2**40], (8, LARGEST_NEW_ID)),
        ([5, LARGEST_NEW_ID], (6, LARGEST_NEW_ID - 1)),
        ([2**29, LARGEST_NEW_ID - 1], (2**29 + 1, LARGEST_NEW_ID - 2)),
    ],
)
def test_free_ids(used: list[int], expected: tuple[int, int]) -> None:
    assert free_range(used) == expected


def test_folders_of_logs_and_logs_are_told_apart(tmp_path: Path) -> None:
    folder = write_log(tmp_path / "logs")
    (tmp_path / "logs" / ".hidden").mkdir()
    (tmp_path / "logs" / "splits.json").write_text("{}")
    assert list(find_logs(tmp_path / "logs")) == [folder]
    assert list(find_logs(folder)) == [folder]
    (tmp_path / "empty").mkdir()
    for nothing in (tmp_path / "empty", tmp_path / "logs" / "splits.json", tmp_path / "nowhere"):
        with pytest.raises(InvalidInput):
            list(find_logs(nothing))


def spoil_lane(**changes: Any) -> Callable[[Path], None]:
    def spoil(root: Path) -> None:
        world = small_map()
        world["lane_segments"]["11"] = lane(11) | changes
        write_map(root, json.dumps(world))

    return spoil


def spoil_text(old: str, new: str) -> Callable[[Path], None]:
    def spoil(root: Path) -> None:
        text = map_path(root).read_text()
        assert old in text
        write_map(root, text.replace(old, new, 1))

    return spoil


def truncate(root: Path) -> None:
    write_map(root, map_path(root).read_text()[:-40])


def leave_out(root: Path) -> None:
    world = small_map()
    del world["lane_segments"]["11"]["successors"]
    write_map(root, json.dumps(world))


def add_second_map(root: Path) -> None:
    (root / "map" / f"log_map_archive_{LOG_ID}____WDC_city_2.json").write_text("{}")


def link_out(root: Path) -> None:
    outside = root.parent / "outside.json"
    map_path(root).rename(outside)
    map_path(root).symlink_to(outside)


def pickle_ground(root: Path) -> None:
    np.save(
        root / "map" / f"{LOG_ID}_ground_height_surface____WDC.npy", np.array([{"a": 1}], object), allow_pickle=True
    )


def giant_ground(root: Path) -> None:
    path = root / "map" / f"{LOG_ID}_ground_height_surface____WDC.npy"
    path.write_bytes(path.read_bytes().replace(b"(200, 200), }      ", b"(2000000, 200000), }"[:19]))


def break_poses(root: Path) -> None:
    path = root / "city_SE3_egovehicle.feather"
    path.write_bytes(path.read_bytes()[:200])


POINT = '"x": 20.0, "y": 4.0'
BAD_LOGS = {
    "truncated JSON": (truncate, [".json"]),
    "depth bomb": (lambda root: write_map(root, "[" * 200_000), [".json"]),
    "NaN": (spoil_text(POINT, '"x": NaN, "y": 4.0'), ["lane_segment", "left_lane_boundary"]),
    "1e308": (spoil_text(POINT, '"x": 1e308, "y": 4.0'), ["lane_segment", "left_lane_boundary"]),
    "id beyond 2^63": (spoil_lane(successors=[2**63 + 1]), ["lane_segment 11", "successors"]),
    "NUL": (spoil_text("VEHICLE", "VEHICLE\\u0000"), ["lane_segment", "lane_type"]),
    "lone surrogate": (spoil_text("VEHICLE", "\\ud800"), ["lane_segment", "lane_type"]),
    "duplicate key": (spoil_text('"lane_type"', '"lane_type": "BUS", "lane_type"'), ["lane_segment", "lane_type"]),
    "bool as coordinate": (spoil_text(POINT, '"x": true, "y": 4.0'), ["lane_segment", "left_lane_boundary"]),
    "wrong enum": (spoil_lane(lane_type="TRAM"), ["lane_segment 11", "lane_type", "VEHICLE"]),
    "missing key": (leave_out, ["lane_segment 11", "successors"]),
    "two maps": (add_second_map, ["city_1.json", "city_2.json"]),
    "symlink out": (link_out, ["log_map_archive", "symlink"]),
    "pickled npy": (pickle_ground, ["ground_height_surface", "pickle"]),
    "giant npy header": (giant_ground, ["ground_height_surface"]),
    "broken feather": (break_poses, ["city_SE3_egovehicle.feather"]),
}


@pytest.mark.parametrize("name", BAD_LOGS)
def test_a_bad_log_is_named_and_leaves_no_trace(session: Session, tmp_path: Path, name: str) -> None:
    spoil, words = BAD_LOGS[name]
    folder = write_log(tmp_path)
    spoil(folder)
    counts = table_counts(session)
    with pytest.raises(InvalidInput) as refused, session.begin_nested():
        import_log(session, folder, TEST)
    for word in words:
        assert word in str(refused.value)
    assert refused.value.place.file
    assert refused.value.mend
    assert table_counts(session) == counts
