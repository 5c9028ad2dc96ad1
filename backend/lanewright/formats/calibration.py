"""Calibration of a log's sensors: where each sits on the vehicle, and the pinhole of each camera.

Images are undistorted already, so k1, k2, k3 are kept but not to be applied. Source: av2-api, shared facts §1.3.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from lanewright.core.errors import InvalidInput, Place
from lanewright.formats.feather import read_columns
from lanewright.formats.poses import Pose, check_rigid
from lanewright.formats.untrusted_file import MEBIBYTE

_MOST_BYTES = MEBIBYTE
_MOST_ROWS = 1_000


@dataclass(frozen=True, slots=True)
class Intrinsics:
    """Pinhole of one camera, in pixels."""

    fx_px: float
    fy_px: float
    cx_px: float
    cy_px: float
    k1: float
    k2: float
    k3: float
    height_px: int
    width_px: int


def read_extrinsics(path: Path, name: str | None = None) -> Mapping[str, Pose]:
    """ego_SE3_sensor by sensor. Raises InvalidInput naming file, row and column."""
    file = name or path.name
    kinds = {"sensor_name": "str"} | dict.fromkeys(Pose._fields, "float64")
    columns = read_columns(path, kinds, most_bytes=_MOST_BYTES, most_rows=_MOST_ROWS, name=file)
    names = columns.pop("sensor_name").tolist()
    values = np.stack(list(columns.values()), axis=1)
    try:
        _check_names(names)
        check_rigid(values)
    except InvalidInput as error:
        raise error.within(file=file) from None
    return {sensor: Pose(*row) for sensor, row in zip(names, values.tolist(), strict=True)}


def read_intrinsics(path: Path, name: str | None = None) -> Mapping[str, Intrinsics]:
    """Pinhole by camera. Raises InvalidInput naming file, camera and column."""
    file = name or path.name
    sizes = ("height_px", "width_px")
    kinds = {"sensor_name": "str"} | {
        field: "int64" if field in sizes else "float64" for field in Intrinsics.__dataclass_fields__
    }
    columns = read_columns(path, kinds, most_bytes=_MOST_BYTES, most_rows=_MOST_ROWS, name=file)
    names = columns.pop("sensor_name").tolist()
    try:
        _check_names(names)
        for field, values in columns.items():
            usable = np.isfinite(values) & ((values > 0) | (field not in (*sizes, "fx_px", "fy_px")))
            for row in np.flatnonzero(~usable):
                raise InvalidInput(
                    f"is {values[row]}", "Write pixels; lengths and sizes above 0.", Place(None, names[row], field)
                )
    except InvalidInput as error:
        raise error.within(file=file) from None
    rows = zip(*(values.tolist() for values in columns.values()), strict=True)
    return {sensor: Intrinsics(*row) for sensor, row in zip(names, rows, strict=True)}


def _check_names(names: list[str]) -> None:
    for row, sensor in enumerate(names):
        if names.index(sensor) != row:
            raise InvalidInput(f"names {sensor!r:.60} twice", "Keep one row a sensor.", Place(key="sensor_name"))
