"""What a small log holds: 30 m east along a road with one painted line, seen by ten sweeps a second."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pyarrow as pa
from pyarrow import feather

LOG_ID = "LanewrightTestLog000000000000001__Summer_2020"
ORIGIN = (1000.0, 2000.0, 10.32)  # of the ego vehicle at the start; the ground is flat at z = 10
PAINT_Y = 2003.5
FIRST_NS = 315_966_253_572_412_942


def write_feather(path: Path, columns: dict[str, Any]) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    feather.write_feather(pa.table(columns), path)


def pose_columns(count: int = 301) -> dict[str, Any]:
    """10 m/s east, one row in 10 ms."""
    time = np.arange(count)
    columns: dict[str, Any] = {"timestamp_ns": FIRST_NS + time * 10_000_000, "qw": np.ones(count)}
    columns |= {name: np.zeros(count) for name in ("qx", "qy", "qz")}
    return columns | {
        "tx_m": ORIGIN[0] + time * 0.1,
        "ty_m": np.full(count, ORIGIN[1]),
        "tz_m": np.full(count, ORIGIN[2]),
    }


def sweep_columns(ego_x: float, seed: int) -> dict[str, Any]:
    """Asphalt (about 10), a line of paint (90), and a wall two metres high (200)."""
    random = np.random.default_rng(seed)
    x, y = random.uniform(-20, 20, 20_000), random.uniform(-10, 10, 20_000)
    wall = random.random(20_000) < 0.2
    painted = np.abs(ORIGIN[1] + y - PAINT_Y) < 0.1
    intensity = np.where(wall, 200, np.where(painted, 90, random.integers(5, 15, 20_000)))
    return {
        "x": x.astype(np.float16),
        "y": y.astype(np.float16),
        "z": (np.where(wall, 2.0, 0.0) - 0.32).astype(np.float16),
        "intensity": intensity.astype(np.uint8),
        "laser_number": np.zeros(20_000, np.uint8),
    }
