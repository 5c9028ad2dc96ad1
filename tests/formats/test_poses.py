"""Ego poses."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pyarrow as pa
import pytest
from pyarrow import feather

from lanewright.core.errors import InvalidInput
from lanewright.formats.av2_log import POSES
from lanewright.formats.calibration import read_extrinsics, read_intrinsics
from lanewright.formats.poses import Pose, read_poses


def write(path: Path, **changes: Any) -> Path:
    columns: dict[str, Any] = {"timestamp_ns": [10, 20, 30], "qw": [1.0] * 3}
    columns |= dict.fromkeys(["qx", "qy", "qz", "tx_m", "ty_m", "tz_m"], [0.0] * 3) | changes
    feather.write_feather(pa.table(columns), path)
    return path


@pytest.mark.parametrize(
    ("changes", "element", "key", "problem"),
    [
        ({"timestamp_ns": [10, 30, 20]}, "row 2", "timestamp_ns", "not after the row before"),
        ({"timestamp_ns": [10, 10, 20]}, "row 1", "timestamp_ns", "not after the row before"),
        ({"tx_m": [0.0, np.nan, 0.0]}, "row 1", "tx_m", "is nan"),
        ({"ty_m": [0.0, 0.0, 1e308]}, "row 2", "ty_m", "is 1e+308"),
        ({"qz": [0.0, 0.0, np.inf]}, "row 2", "qz", "is inf"),
        ({"qw": [1.0, 0.5, 1.0]}, "row 1", "qw", "quaternion of length 0.5"),
        ({"timestamp_ns": [1.0, 2.0, 3.0]}, None, "timestamp_ns", "is double, not int64"),
    ],
)
def test_bad_rows_are_named(
    tmp_path: Path, changes: dict[str, Any], element: str | None, key: str, problem: str
) -> None:
    with pytest.raises(InvalidInput) as caught:
        read_poses(write(tmp_path / "poses.feather", **changes))
    error = caught.value
    assert (error.place.file, error.place.element, error.place.key) == ("poses.feather", element, key)
    assert problem in error.message
    assert error.mend


def test_a_log_without_poses_is_refused(tmp_path: Path) -> None:
    with pytest.raises(InvalidInput, match="is missing"):
        read_poses(tmp_path / POSES)
    columns = {name: pa.array([], pa.float64()) for name in ("qw", "qx", "qy", "qz", "tx_m", "ty_m", "tz_m")}
    empty = {"timestamp_ns": pa.array([], pa.int64())} | columns
    with pytest.raises(InvalidInput, match=r'"timestamp_ns": has no row'):
        read_poses(write(tmp_path / POSES, **empty))


def test_times_beyond_double_precision_stay_exact(tmp_path: Path) -> None:
    times = [315966253572412941, 315966253572412942, 315966253572412943]
    poses = read_poses(write(tmp_path / "poses.feather", timestamp_ns=times))
    assert poses.timestamps_ns.tolist() == times
    assert [poses.nearest(time) for time in times] == [0, 1, 2]


def test_nearest_row(tmp_path: Path) -> None:
    poses = read_poses(write(tmp_path / "poses.feather"))
    assert [poses.nearest(time) for time in (-5, 10, 15, 16, 29, 99)] == [0, 0, 0, 1, 2, 2]


def test_rotation_turns_the_vehicle_counter_clockwise() -> None:
    quarter_turn = Pose(np.sqrt(0.5), 0.0, 0.0, np.sqrt(0.5), 100.0, 200.0, 3.0)
    ahead = quarter_turn.rotation @ [10.0, 0.0, 0.0] + quarter_turn.translation
    assert ahead == pytest.approx([100.0, 210.0, 3.0])


def test_real_poses_agree_with_scipy(real_log: Path) -> None:
    rotation = pytest.importorskip("scipy.spatial.transform").Rotation
    poses = read_poses(real_log / POSES)
    assert len(poses) in (2706, 2637)
    for row in (0, 1000, len(poses) - 1):
        pose = poses[row]
        expected = rotation.from_quat([pose.qx, pose.qy, pose.qz, pose.qw]).as_matrix()
        assert pose.rotation == pytest.approx(expected, abs=1e-12)


def test_real_calibration(real_log: Path) -> None:
    folder = real_log / "calibration"
    if not folder.is_dir():
        pytest.skip("this log has no calibration")
    extrinsics = read_extrinsics(folder / "egovehicle_SE3_sensor.feather")
    intrinsics = read_intrinsics(folder / "intrinsics.feather")
    assert len(extrinsics) == 11
    assert intrinsics["ring_front_center"].height_px == 2048
    assert extrinsics.keys() - intrinsics.keys() == {"up_lidar", "down_lidar"}


def test_bad_calibration_names_the_camera(tmp_path: Path) -> None:
    columns = {"sensor_name": ["a", "b"]} | {key: [800.0, 800.0] for key in ["fx_px", "fy_px", "cx_px", "cy_px"]}
    columns |= {key: [0.0, 0.0] for key in ["k1", "k2", "k3"]} | {key: [775, 0] for key in ["height_px", "width_px"]}
    path = tmp_path / "intrinsics.feather"
    feather.write_feather(pa.table(columns), path)
    with pytest.raises(InvalidInput, match=r'intrinsics\.feather, b, "height_px": is 0'):
        read_intrinsics(path)
    feather.write_feather(pa.table(columns | {"sensor_name": ["a", "a"]}), path)
    with pytest.raises(InvalidInput, match=r'"sensor_name": names \'a\' twice'):
        read_intrinsics(path)
