"""Writes a log in the TbV directory layout (data-and-metrics §1.3)."""

from __future__ import annotations

import json
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import pyarrow as pa
from pyarrow import feather

from lanewright.core.attributes import attribute_value, element_attributes
from lanewright.core.elements import Line, MapState
from lanewright.demo.calibration import CAMERAS, LIDARS
from lanewright.demo.drive import Poses
from lanewright.demo.surface import CELL_M

QUATERNION = ("qw", "qx", "qy", "qz")
TRANSLATION = ("tx_m", "ty_m", "tz_m")


def map_document(state: MapState, areas: Iterable[tuple[int, Line]]) -> dict[str, Any]:
    """The map as its JSON file: crossings, lanes, areas, each keyed by the decimal id."""
    return {
        "pedestrian_crossings": {str(id_): element_attributes(zebra) for id_, zebra in state.crossings.items()},
        "lane_segments": {str(id_): element_attributes(lane) for id_, lane in state.lanes.items()},
        "drivable_areas": {str(id_): {"area_boundary": attribute_value(ring), "id": id_} for id_, ring in areas},
    }


def write_map(path: Path, state: MapState, areas: Sequence[tuple[int, Line]]) -> None:
    """One ``log_map_archive`` file; the name is the caller's."""
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(json.dumps(map_document(state, areas)), encoding="utf-8")


def write_raster(
    folder: Path, log_id: str, city: str, heights: npt.NDArray[np.float16], origin: tuple[float, float]
) -> None:
    """The ground surface and its Sim2: pixel = s * (R p + t)."""
    np.save(folder / f"{log_id}_ground_height_surface____{city}.npy", heights, allow_pickle=False)
    similarity = {"R": [1.0, 0.0, 0.0, 1.0], "t": [-origin[0], -origin[1]], "s": 1.0 / CELL_M}
    (folder / f"{log_id}___img_Sim2_city.json").write_text(json.dumps(similarity), encoding="utf-8")


def write_poses(folder: Path, poses: Poses) -> None:
    """``city_SE3_egovehicle.feather``."""
    columns: dict[str, Any] = {"timestamp_ns": poses.timestamps}
    columns |= dict(zip(QUATERNION, poses.quaternions.T, strict=True))
    columns |= dict(zip(TRANSLATION, poses.positions.T, strict=True))
    _write_table(folder / "city_SE3_egovehicle.feather", columns)


def write_calibration(folder: Path) -> None:
    """Intrinsics of the cameras and poses of all sensors in the ego frame."""
    folder.mkdir(parents=True, exist_ok=True)
    sensors = [(camera.name, camera.quaternion, camera.position) for camera in CAMERAS] + list(LIDARS)
    extrinsics: dict[str, Any] = {"sensor_name": [name for name, _, _ in sensors]}
    extrinsics |= {key: [float(quaternion[i]) for _, quaternion, _ in sensors] for i, key in enumerate(QUATERNION)}
    extrinsics |= {key: [float(position[i]) for _, _, position in sensors] for i, key in enumerate(TRANSLATION)}
    _write_table(folder / "egovehicle_SE3_sensor.feather", extrinsics)
    intrinsics: dict[str, Any] = {
        "sensor_name": [camera.name for camera in CAMERAS],
        "fx_px": [camera.focal_px for camera in CAMERAS],
        "fy_px": [camera.focal_px for camera in CAMERAS],
        "cx_px": [camera.width_px / 2 for camera in CAMERAS],
        "cy_px": [camera.height_px / 2 for camera in CAMERAS],
    }
    intrinsics |= {key: [0.0] * len(CAMERAS) for key in ("k1", "k2", "k3")}
    intrinsics["height_px"] = np.array([camera.height_px for camera in CAMERAS], dtype=np.uint16)
    intrinsics["width_px"] = np.array([camera.width_px for camera in CAMERAS], dtype=np.uint16)
    _write_table(folder / "intrinsics.feather", intrinsics)


def write_sweep(folder: Path, timestamp: int, points: npt.NDArray[np.float16], marks: npt.NDArray[np.uint8]) -> None:
    """One lidar sweep: points (n, 3) in the ego frame; marks (n, 2) are intensity and laser number."""
    folder.mkdir(parents=True, exist_ok=True)
    columns = dict(zip(("x", "y", "z"), np.ascontiguousarray(points.T), strict=True))
    columns |= dict(zip(("intensity", "laser_number"), np.ascontiguousarray(marks.T), strict=True))
    _write_table(folder / f"{timestamp}.feather", columns)


def _write_table(path: Path, columns: dict[str, Any]) -> None:
    feather.write_feather(pa.table(columns), str(path), compression="lz4")
