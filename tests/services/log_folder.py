"""Folders of small logs, as AV2 lays them out."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow as pa
import pyarrow.feather
from tests.stored_logs import small_map

LOG_ID = "abcdefghijklmnopqrstuvwxyz012345__Spring_2020"
OTHER_LOG_ID = "bbcdefghijklmnopqrstuvwxyz012345__Autumn_2021"
FIRST_NS = 315_966_265_259_836_000


def write_log(parent: Path, log_id: str = LOG_ID, *, map_text: str | None = None) -> Path:
    """Map, poses along lane 11 and a level ground raster; no calibration, no sensors."""
    root = parent / log_id
    (root / "map").mkdir(parents=True)
    write_map(root, map_text or json.dumps(small_map()))
    count = 40
    poses: dict[str, Any] = {"timestamp_ns": FIRST_NS + np.arange(count, dtype=np.int64) * 50_000_000}
    poses |= {name: np.full(count, value) for name, value in (("qw", 1.0), ("qx", 0.0), ("qy", 0.0), ("qz", 0.0))}
    poses |= {"tx_m": np.linspace(0.0, 20.0, count), "ty_m": np.full(count, 2.0), "tz_m": np.full(count, 1.5)}
    pyarrow.feather.write_feather(pa.table(poses), root / "city_SE3_egovehicle.feather")
    np.save(root / "map" / f"{log_id}_ground_height_surface____WDC.npy", np.full((200, 200), 3.25, np.float16))
    placement = {"R": [1.0, 0.0, 0.0, 1.0], "t": [20.0, 20.0], "s": 10 / 3}
    (root / "map" / f"{log_id}___img_Sim2_city.json").write_text(json.dumps(placement))
    return root


def map_path(root: Path) -> Path:
    return root / "map" / f"log_map_archive_{root.name}____WDC_city_1.json"


def write_map(root: Path, text: str) -> None:
    map_path(root).write_text(text)
