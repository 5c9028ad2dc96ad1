"""A small log on disk."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.sensors.small_drive import LOG_ID, pose_columns, sweep_columns, write_feather


@pytest.fixture
def small_log(tmp_path: Path) -> Path:
    """The folder of a TbV log with map, poses, ground, lidar and one camera, without calibration."""
    root = tmp_path / LOG_ID
    poses = pose_columns()
    write_feather(root / "city_SE3_egovehicle.feather", poses)
    for row in range(0, 301, 10):
        sweep = sweep_columns(poses["tx_m"][row], seed=row)
        write_feather(root / "sensors" / "lidar" / f"{poses['timestamp_ns'][row]}.feather", sweep)
    camera = root / "sensors" / "cameras" / "ring_front_center"
    camera.mkdir(parents=True)
    for row in range(0, 301, 5):
        (camera / f"{poses['timestamp_ns'][row] + 1}.jpg").write_bytes(b"")
    folder = root / "map"
    folder.mkdir()
    empty_map = {"pedestrian_crossings": {}, "lane_segments": {}, "drivable_areas": {}}
    (folder / f"log_map_archive_{LOG_ID}____WDC_city_1.json").write_text(json.dumps(empty_map))
    np.save(folder / f"{LOG_ID}_ground_height_surface____WDC.npy", np.full((400, 500), 10.0, np.float16))
    placement = {"R": [1.0, 0.0, 0.0, 1.0], "t": [-950.0, -1950.0], "s": 10 / 3}
    (folder / f"{LOG_ID}___img_Sim2_city.json").write_text(json.dumps(placement))
    return root


@pytest.fixture
def poses_file(small_log: Path) -> Callable[[dict[str, Any]], None]:
    """Replaces the log's poses."""
    return lambda columns: write_feather(small_log / "city_SE3_egovehicle.feather", columns)
