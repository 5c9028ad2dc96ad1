"""What lies in a demo log's folder, and what reads it."""

from __future__ import annotations

import json
import re
from pathlib import Path

import numpy as np
import pyarrow as pa
import pytest
from av2.map.map_api import ArgoverseStaticMap
from pyarrow import feather
from typer.testing import CliRunner

from lanewright.cli.main import app
from lanewright.demo import DemoLog, generate
from lanewright.formats.av2_log import LIDAR
from lanewright.formats.av2_map import read_map
from lanewright.sensors.log_bundle import read_log

LANE_KEYS = [
    "id",
    "is_intersection",
    "lane_type",
    "left_lane_boundary",
    "left_lane_mark_type",
    "right_lane_boundary",
    "right_lane_mark_type",
    "successors",
    "predecessors",
    "right_neighbor_id",
    "left_neighbor_id",
]
MEGABYTE = 1_000_000


def contents(folder: Path) -> dict[str, bytes]:
    return {str(path.relative_to(folder)): path.read_bytes() for path in sorted(folder.rglob("*")) if path.is_file()}


def map_file(log: DemoLog) -> Path:
    (path,) = (log.folder / "map").glob("log_map_archive_*.json")
    return path


def test_the_same_seed_gives_the_same_bytes(logs: list[DemoLog], demo_folder: Path, tmp_path: Path) -> None:
    generate(7, tmp_path, logs=1)
    again = {name: data for name, data in contents(tmp_path).items() if "/" in name or ".changed." in name}
    assert len(again) > 30
    before = contents(demo_folder)
    assert all(before[name] == data for name, data in again.items())


def test_another_seed_gives_other_logs(logs: list[DemoLog], tmp_path: Path) -> None:
    (other,) = generate(8, tmp_path, logs=1)
    assert other.log_id != logs[0].log_id
    assert other.base != logs[0].base


def test_names_follow_the_tbv_layout(logs: list[DemoLog]) -> None:
    for log in logs:
        assert re.fullmatch(r"[A-Za-z0-9]{32}__(Spring|Summer|Autumn|Winter)_20\d\d", log.log_id)
        assert re.fullmatch(rf"log_map_archive_{log.log_id}____{log.city}_city_\d+\.json", map_file(log).name)
        assert {str(path.relative_to(log.folder)) for path in log.folder.rglob("*") if path.is_file()} >= {
            "city_SE3_egovehicle.feather",
            "calibration/egovehicle_SE3_sensor.feather",
            "calibration/intrinsics.feather",
            f"map/{log.log_id}_ground_height_surface____{log.city}.npy",
            f"map/{log.log_id}___img_Sim2_city.json",
        }
        assert not log.changed_path.is_relative_to(log.folder)


def test_map_files_have_the_keys_of_the_official_verifier_in_order(logs: list[DemoLog]) -> None:
    for log in logs:
        for path in (map_file(log), log.changed_path):
            document = json.loads(path.read_text())
            assert list(document) == ["pedestrian_crossings", "lane_segments", "drivable_areas"]
            assert all(list(lane) == LANE_KEYS for lane in document["lane_segments"].values())
            assert all(key == str(lane["id"]) for key, lane in document["lane_segments"].items())


def test_both_maps_on_disk_are_those_in_memory(logs: list[DemoLog]) -> None:
    for log in logs:
        assert read_map(map_file(log)).state == log.base
        assert read_map(log.changed_path).state == log.changed


def test_the_lists_name_splits_and_directions(logs: list[DemoLog], demo_folder: Path) -> None:
    listed = json.loads((demo_folder / "demo.json").read_text())["logs"]
    assert {entry["log_id"]: (entry["split"], entry["direction"]) for entry in listed} == {
        log.log_id: (log.split, log.direction.value) for log in logs
    }
    assert {log.split for log in logs} == {"train", "val", "test"}
    assert {log.direction.value for log in logs} == {"prior_to_current", "current_to_prior"}
    splits = json.loads((demo_folder / "splits.json").read_text())
    assert sorted(splits["train"] + splits["val"]) == sorted(log.log_id for log in logs)


@pytest.mark.parametrize("index", range(3))
def test_av2_loads_the_map_with_its_raster(logs: list[DemoLog], index: int) -> None:
    log = logs[index]
    static_map = ArgoverseStaticMap.from_map_dir(log.folder / "map", build_raster=True)
    assert set(static_map.vector_lane_segments) == set(log.base.lanes)
    assert 2 <= len(static_map.vector_drivable_areas) <= 15
    residuals, covered = [], []
    for lane in log.base.lanes.values():
        for boundary in (lane.left_boundary, lane.right_boundary):
            points = np.array(boundary)
            heights = static_map.raster_ground_height_layer.get_ground_height_at_xy(points[:, :2])
            covered.append(np.isfinite(heights).mean())
            residuals.append((heights - points[:, 2])[np.isfinite(heights)])
    assert np.mean(covered) > 0.8
    assert np.percentile(np.abs(np.concatenate(residuals)), 99) < 0.05
    (raster_path,) = (log.folder / "map").glob("*_ground_height_surface____*.npy")
    raster = np.load(raster_path, allow_pickle=False)
    assert raster.dtype == np.float16
    assert np.isnan(raster).any()


def test_the_importer_reads_logs_with_all_their_parts(logs: list[DemoLog]) -> None:
    for log in logs:
        bundle = read_log(log.folder)
        assert bundle.map.state == log.base
        assert bundle.ground is not None
        assert bundle.lidar is not None
        assert len(bundle.frames.frames) > 25
        assert all(LIDAR in frame.files for frame in bundle.frames.frames)


def test_poses_are_dense_and_every_sweep_has_an_exact_one(logs: list[DemoLog]) -> None:
    for log in logs:
        table = feather.read_table(log.folder / "city_SE3_egovehicle.feather")
        timestamps = table["timestamp_ns"].to_numpy()
        steps = np.diff(timestamps)
        assert steps.min() == 1
        assert steps.max() <= 10_000_000
        assert 140 < len(timestamps) / ((timestamps[-1] - timestamps[0]) / 1e9) < 170
        position = np.column_stack([table[name].to_numpy() for name in ("tx_m", "ty_m")])
        speed = np.linalg.norm(position[150:] - position[:-150], axis=1) / (
            (timestamps[150:] - timestamps[:-150]) / 1e9
        )
        assert 2 < speed.min() < speed.max() < 14
        sweeps = [int(path.stem) for path in (log.folder / "sensors" / "lidar").iterdir()]
        assert len(sweeps) > 25
        assert set(sweeps) <= set(timestamps.tolist())


def test_tables_have_the_columns_of_tbv(logs: list[DemoLog]) -> None:
    log = logs[0]
    sweep = feather.read_table(next((log.folder / "sensors" / "lidar").iterdir()))
    assert sweep.schema.names == ["x", "y", "z", "intensity", "laser_number"]
    assert sweep.schema.types == [pa.float16()] * 3 + [pa.uint8()] * 2
    extrinsics = feather.read_table(log.folder / "calibration" / "egovehicle_SE3_sensor.feather")
    assert extrinsics.schema.names == ["sensor_name", "qw", "qx", "qy", "qz", "tx_m", "ty_m", "tz_m"]
    names = extrinsics["sensor_name"].to_pylist()
    assert len(names) == 9
    assert {"up_lidar", "down_lidar"} < set(names)
    intrinsics = feather.read_table(log.folder / "calibration" / "intrinsics.feather")
    assert intrinsics["sensor_name"].to_pylist() == names[:7]
    assert intrinsics.schema.field("width_px").type == pa.uint16()


def test_three_logs_stay_small(logs: list[DemoLog], demo_folder: Path) -> None:
    assert sum(len(data) for data in contents(demo_folder).values()) < 40 * MEGABYTE


def test_the_command_writes_logs_and_says_which(tmp_path: Path) -> None:
    result = CliRunner().invoke(app, ["demo", str(tmp_path), "--seed", "3", "--logs", "1"])
    assert result.exit_code == 0, result.output
    (log_id,) = (path.name for path in tmp_path.iterdir() if path.is_dir())
    assert log_id in result.output


def test_a_folder_that_cannot_be_written_is_said_in_a_sentence(tmp_path: Path) -> None:
    occupied = tmp_path / "occupied"
    occupied.write_text("a file")
    result = CliRunner().invoke(app, ["demo", str(occupied), "--logs", "1"])
    assert result.exit_code == 2
    assert "occupied" in result.output
    assert "Traceback" not in result.output
