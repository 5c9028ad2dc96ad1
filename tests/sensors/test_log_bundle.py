"""A whole log, as the import stores it."""

from __future__ import annotations

import hashlib
import io
import pickle
import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import shapely
from PIL import Image
from tests.sensors.small_drive import PAINT_Y, pose_columns, write_feather

from lanewright.core.errors import InvalidInput
from lanewright.formats.av2_log import open_log
from lanewright.sensors.log_bundle import LogBundle, log_fingerprint, read_log


def seen(bundle: LogBundle) -> tuple[Any, Any]:
    """Centres of the pixels with a return, shape (N, 2), and their gray values."""
    assert bundle.lidar is not None
    table = np.asarray(Image.open(io.BytesIO(bundle.lidar.png)))
    rows, columns = np.nonzero(table[..., 1] == 255)
    x = bundle.lidar.bounds[0] + (columns + 0.5) * bundle.lidar.resolution
    y = bundle.lidar.bounds[3] - (rows + 0.5) * bundle.lidar.resolution
    return np.stack([x, y], axis=1), table[rows, columns, 0].astype(float)


def test_the_small_log_has_all_but_calibration(small_log: Path) -> None:
    steps: list[tuple[str, int, int]] = []
    bundle = read_log(small_log, progress=lambda *step: steps.append(step))
    assert bundle.absent == ("extrinsic calibration", "intrinsic calibration")
    assert (bundle.directory.city, bundle.directory.layout.value) == ("WDC", "tbv")
    assert bundle.frames.sensors == {"lidar": 31, "ring_front_center": 61}
    assert len(bundle.files) == 92
    at = [frame.pose.tx_m for frame in bundle.frames.frames]
    assert at == pytest.approx([1000.0, 1006.0, 1012.0, 1018.0, 1024.0, 1030.0])
    assert all(frame.files.keys() == {"lidar", "ring_front_center"} for frame in bundle.frames.frames)
    assert bundle.map_sha256 == hashlib.sha256(bundle.map_bytes).digest()
    assert steps[0] == ("lidar sweeps", 0, 31)
    assert steps[-1] == ("lidar sweeps", 31, 31)


def test_the_painted_line_shows_where_it_is_and_the_wall_does_not(small_log: Path) -> None:
    places, gray = seen(read_log(small_log))
    off = np.abs(places[:, 1] - PAINT_Y)
    assert gray[off < 0.06].mean() > 200
    assert gray[off > 0.3].mean() < 120


def test_the_trajectory_is_thinned_but_exact(small_log: Path) -> None:
    trajectory = read_log(small_log).trajectory
    rows = pose_columns()
    exact = set(zip(rows["tx_m"].tolist(), rows["ty_m"].tolist(), rows["tz_m"].tolist(), strict=True))
    assert set(trajectory) <= exact
    assert trajectory[0] == (1000.0, 2000.0, 10.32)
    assert trajectory[-1][0] == rows["tx_m"][-1]
    assert 25 <= len(trajectory) <= 31


def test_what_is_missing_is_named(small_log: Path) -> None:
    shutil.rmtree(small_log / "sensors")
    next((small_log / "map").glob("*Sim2*")).unlink()
    bundle = read_log(small_log)
    assert bundle.absent == ("extrinsic calibration", "intrinsic calibration", "ground height", "lidar", "cameras")
    assert bundle.lidar is None
    assert bundle.ground is None
    assert len(bundle.frames.frames) == 6  # 5.1 m apart


def test_sweeps_without_a_pose_are_counted(small_log: Path, poses_file: Callable[[dict[str, Any]], None]) -> None:
    poses_file(pose_columns(201))
    bundle = read_log(small_log)
    assert "poses of 10 lidar sweeps" in bundle.absent
    assert bundle.lidar is not None
    assert bundle.lidar.sweeps == 21


def test_a_log_without_poses_is_refused(small_log: Path) -> None:
    (small_log / "city_SE3_egovehicle.feather").unlink()
    with pytest.raises(InvalidInput, match=r"^city_SE3_egovehicle\.feather: is missing\. Copy the log again\.$"):
        read_log(small_log)


def test_broken_files_are_named_by_their_place_in_the_log(small_log: Path) -> None:
    sweep = sorted((small_log / "sensors" / "lidar").iterdir())[3]
    whole = sweep.read_bytes()
    sweep.write_bytes(whole[: len(whole) // 2])
    with pytest.raises(InvalidInput, match=rf"^sensors/lidar/{sweep.name}: is not a whole feather file"):
        read_log(small_log)
    sweep.write_bytes(whole)
    raster = next((small_log / "map").glob("*.npy"))
    raster.write_bytes(pickle.dumps("anything"))
    with pytest.raises(InvalidInput, match=rf"^map/{raster.name}: is no NumPy array file .* pickles are refused"):
        read_log(small_log)


def test_a_return_that_is_no_number_is_named(small_log: Path) -> None:
    sweep = sorted((small_log / "sensors" / "lidar").iterdir())[0]
    columns = {axis: np.zeros(3, np.float16) for axis in "xyz"} | {"intensity": np.zeros(3, np.uint8)}
    columns["y"][2] = np.inf
    write_feather(sweep, columns)
    with pytest.raises(InvalidInput, match=rf'^sensors/lidar/{sweep.name}, row 2, "y": is inf'):
        read_log(small_log)


def test_the_fingerprint_tells_every_change(small_log: Path) -> None:
    before = log_fingerprint(open_log(small_log))
    assert read_log(small_log).fingerprint == before
    (small_log / "notes.txt").write_text("not part of the log")
    assert log_fingerprint(open_log(small_log)) == before
    seen_so_far = {before}
    (next((small_log / "map").glob("*.json"))).open("a").write(" ")
    seen_so_far.add(log_fingerprint(open_log(small_log)))
    next((small_log / "sensors" / "lidar").iterdir()).open("ab").write(b" ")
    seen_so_far.add(log_fingerprint(open_log(small_log)))
    next((small_log / "sensors" / "cameras" / "ring_front_center").iterdir()).unlink()
    seen_so_far.add(log_fingerprint(open_log(small_log)))
    assert len(seen_so_far) == 4


def test_real_logs_are_read_whole(real_logs: list[Path]) -> None:
    first, second = (read_log(folder) for folder in real_logs)
    assert first.absent == ("cameras",)
    assert second.absent == ("extrinsic calibration", "intrinsic calibration", "cameras")
    assert (len(first.map.state.lanes), len(second.map.state.lanes)) == (183, 199)
    assert (len(first.frames.frames), len(second.frames.frames)) == (15, 9)
    assert first.frames.sensors == {"lidar": 2}
    assert first.lidar is not None
    assert first.lidar.sweeps == 2


def test_on_the_real_logs_paint_lies_on_the_boundaries_of_the_map(real_logs: list[Path]) -> None:
    for folder in real_logs:
        bundle = read_log(folder)
        painted = shapely.union_all(
            [
                shapely.LineString([point[:2] for point in line])
                for lane in bundle.map.state.lanes.values()
                for line, mark in ((lane.left_boundary, lane.left_mark), (lane.right_boundary, lane.right_mark))
                if "SOLID" in mark and "DASH" not in mark
            ]
        )
        places, gray = seen(bundle)
        off = shapely.distance(painted, shapely.points(places))
        assert gray[off < 0.15].mean() > 1.2 * gray[(off > 0.4) & (off < 1.2)].mean()
