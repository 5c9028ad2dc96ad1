"""Lidar sweeps (``sensors/lidar/<timestamp_ns>.feather``): returns in the ego frame at the time of the sweep.

Columns x, y, z float16, intensity, laser_number uint8 (Sensor logs also offset_ns, not needed: sweeps are motion
compensated). float16 is exact to 3 cm at 60 m. Source: av2-api, shared facts §1.3.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from lanewright.core.errors import InvalidInput, Place
from lanewright.formats.feather import read_columns
from lanewright.formats.untrusted_file import MEBIBYTE

MOST_BYTES = 64 * MEBIBYTE
MOST_RETURNS = 2_000_000
"""Real sweeps have some 100,000."""


@dataclass(frozen=True, slots=True)
class Sweep:
    """Returns of one turn of the lidars.

    Attributes:
        points: shape (N, 3), float32, metres in the ego frame.
        intensity: shape (N,), uint8.
    """

    points: np.ndarray[Any, np.dtype[np.float32]]
    intensity: np.ndarray[Any, np.dtype[np.uint8]]


def read_sweep(path: Path, name: str | None = None) -> Sweep:
    """The sweep at ``path``. Raises InvalidInput naming file, row and column."""
    file = name or path.name
    kinds = {"x": "float32", "y": "float32", "z": "float32", "intensity": "uint8"}
    columns = read_columns(path, kinds, most_bytes=MOST_BYTES, most_rows=MOST_RETURNS, name=file)
    for axis in "xyz":
        bad = np.flatnonzero(~np.isfinite(columns[axis]))
        if len(bad):
            raise InvalidInput(
                f"is {columns[axis][bad[0]]}", "Write finite metres.", Place(file, f"row {bad[0]}", axis)
            )
    return Sweep(np.stack([columns[axis] for axis in "xyz"], axis=1), columns["intensity"])
