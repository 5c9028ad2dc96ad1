"""The vehicle's way through a log: kept as one JSON file at import, told to the editor and to exports from there."""

from __future__ import annotations

import math
from typing import Any

import orjson
from sqlalchemy.orm import Session

from lanewright.db.repositories import logs
from lanewright.formats.poses import Pose
from lanewright.sensors.frames import Frame
from lanewright.sensors.log_bundle import LogBundle
from lanewright.services.access import readable_task
from lanewright.services.actor import Actor

SENSORS = "sensors.json"


def sensors_document(bundle: LogBundle) -> dict[str, Any]:
    """What is kept of a log's sensors.

    ``trajectory``: x, y, z in city metres, about one per metre. ``frames``: one per more than 5 m of motion, with
    drive, timestamp (text: it exceeds 2^53), pose (city_SE3_egovehicle) and the file of each sensor nearest in time,
    relative to the log folder. ``sensors``: number of files by sensor. ``extrinsics``, ``intrinsics``: by sensor, null
    without calibration.
    """
    return {
        "trajectory": bundle.trajectory,
        "frames": [_frame(index, frame) for index, frame in enumerate(bundle.frames.frames)],
        "sensors": dict(bundle.frames.sensors),
        "extrinsics": None
        if bundle.extrinsics is None
        else {name: pose._asdict() for name, pose in bundle.extrinsics.items()},
        "intrinsics": None if bundle.intrinsics is None else dict(bundle.intrinsics),
    }


def _frame(index: int, frame: Frame) -> dict[str, Any]:
    return {
        "index": index,
        "drive": frame.drive,
        "timestamp_ns": str(frame.timestamp_ns),
        "pose": frame.pose._asdict(),
        "files": dict(frame.files),
    }


def drive(session: Session, actor: Actor, task_id: int) -> dict[str, Any]:
    """The drive of a task's log, as the JSON of ``Drive``. Raises NotFound."""
    task = readable_task(session, actor, task_id)
    kept = orjson.loads(logs.asset_body(session, task.log_id, SENSORS))
    return {
        "trajectory": [point[:2] for point in kept["trajectory"]],
        "frames": [_place(frame) for frame in kept["frames"]],
        "sensors": kept["sensors"],
    }


def _place(frame: dict[str, Any]) -> dict[str, Any]:
    pose = Pose(**frame["pose"])
    rotation = pose.rotation
    return {
        "index": frame["index"],
        "drive": frame["drive"],
        "timestamp_ns": frame["timestamp_ns"],
        "x": pose.tx_m,
        "y": pose.ty_m,
        "z": pose.tz_m,
        "heading_rad": math.atan2(rotation[1, 0], rotation[0, 0]),
    }
