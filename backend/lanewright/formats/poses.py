"""Ego poses of a log (``city_SE3_egovehicle.feather``): where the vehicle was at every sensor event.

Columns timestamp_ns, qw, qx, qy, qz, tx_m, ty_m, tz_m; p_city = R · p_ego + t, ego x forward, y left, z up. Rows are
not uniform in time (1 ns to 10 ms apart in real logs). Source: av2-api, shared facts §1.3.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from lanewright.core.attributes import LARGEST_COORDINATE_M
from lanewright.core.errors import InvalidInput, Place
from lanewright.formats.feather import read_columns
from lanewright.formats.untrusted_file import MEBIBYTE

FloatArray = np.ndarray[Any, np.dtype[np.float64]]

MOST_BYTES = 64 * MEBIBYTE
MOST_ROWS = 1_000_000
"""The longest log of the dataset has some 20,000."""
_QUATERNION = ("qw", "qx", "qy", "qz")
_TRANSLATION = ("tx_m", "ty_m", "tz_m")
_UNIT_TOLERANCE = 1e-3


class Pose(NamedTuple):
    """One pose as it stands in the file: unit quaternion and translation in city metres."""

    qw: float
    qx: float
    qy: float
    qz: float
    tx_m: float
    ty_m: float
    tz_m: float

    @property
    def rotation(self) -> FloatArray:
        """R of p_city = R · p_ego + t, shape (3, 3)."""
        w, x, y, z = np.array(self[:4]) / np.linalg.norm(self[:4])
        return np.array(
            [
                [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
            ]
        )

    @property
    def translation(self) -> FloatArray:
        """t of p_city = R · p_ego + t, shape (3,)."""
        return np.array(self[4:])


@dataclass(frozen=True, slots=True)
class Poses:
    """All poses of a log, in order of time.

    Attributes:
        timestamps_ns: shape (N,), int64, strictly increasing, N ≥ 1.
        values: shape (N, 7): qw, qx, qy, qz, tx_m, ty_m, tz_m.
    """

    timestamps_ns: np.ndarray[Any, np.dtype[np.int64]]
    values: FloatArray

    def __len__(self) -> int:
        return len(self.timestamps_ns)

    def __getitem__(self, row: int) -> Pose:
        return Pose(*self.values[row].tolist())

    def nearest(self, timestamp_ns: int) -> int:
        """The row nearest in time (of two equally near ones the earlier)."""
        after = int(np.searchsorted(self.timestamps_ns, timestamp_ns))
        if after == 0 or (after < len(self) and int(self.timestamps_ns[after]) == timestamp_ns):
            return after
        if after == len(self):
            return after - 1
        before_ns = timestamp_ns - int(self.timestamps_ns[after - 1])
        return after - 1 if before_ns <= int(self.timestamps_ns[after]) - timestamp_ns else after

    def rows_every(self, metres: float, rows: Iterator[int] | None = None) -> Iterator[int]:
        """The first of ``rows`` (all, if not given), then each further than ``metres`` from the one before it."""
        last: tuple[float, ...] | None = None
        for row in range(len(self)) if rows is None else rows:
            here = self[row][4:]
            if last is None or sum((a - b) ** 2 for a, b in zip(here, last, strict=True)) > metres**2:
                yield row
                last = here


def read_poses(path: Path, name: str | None = None) -> Poses:
    """The pose file at ``path``.

    Raises:
        InvalidInput: broken, empty, not in order of time, not finite, no unit quaternion; names file, row and column.
    """
    file = name or path.name
    kinds = {"timestamp_ns": "int64"} | dict.fromkeys((*_QUATERNION, *_TRANSLATION), "float64")
    columns = read_columns(path, kinds, most_bytes=MOST_BYTES, most_rows=MOST_ROWS, name=file)
    try:
        times = columns.pop("timestamp_ns")
        values = np.stack(list(columns.values()), axis=1)
        _check_times(times)
        check_rigid(values)
    except InvalidInput as error:
        raise error.within(file=file) from None
    return Poses(times, values)


def check_rigid(values: FloatArray) -> None:
    """Refuse rows of qw, qx, qy, qz, tx_m, ty_m, tz_m that are no rigid motion. Raises InvalidInput."""
    for i, name in enumerate((*_QUATERNION, *_TRANSLATION)):
        bad = np.flatnonzero(~(np.abs(values[:, i]) <= LARGEST_COORDINATE_M))
        if len(bad):
            raise InvalidInput(
                f"is {values[bad[0], i]}", "Write finite numbers, metres in the city frame.", _row(bad[0], name)
            )
    bad = np.flatnonzero(np.abs(np.linalg.norm(values[:, :4], axis=1) - 1) > _UNIT_TOLERANCE)
    if len(bad):
        raise InvalidInput(
            f"is part of a quaternion of length {np.linalg.norm(values[bad[0], :4]):.4g}",
            "Write unit quaternions.",
            _row(bad[0], "qw"),
        )


def _check_times(times: np.ndarray[Any, Any]) -> None:
    if len(times) == 0:
        raise InvalidInput("has no row", "A log needs at least one pose.", Place(key="timestamp_ns"))
    bad = np.flatnonzero(np.diff(times) <= 0)
    if len(bad):
        raise InvalidInput("is not after the row before it", "Sort the rows by time.", _row(bad[0] + 1, "timestamp_ns"))


def _row(row: int, column: str) -> Place:
    return Place(element=f"row {row}", key=column)
