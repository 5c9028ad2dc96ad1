"""Everything that is kept of one log, read from its folder and from nothing outside it.

Only map and poses are required; what else a complete log has and this one lacks is named.
"""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

from lanewright.core.elements import Point
from lanewright.formats.av2_log import EXTRINSICS, INTRINSICS, LIDAR, POSES, LogDirectory, SensorFile, open_log
from lanewright.formats.av2_map import LIMITS as MAP_LIMITS
from lanewright.formats.av2_map import MapDocument, parse_map
from lanewright.formats.calibration import Intrinsics, read_extrinsics, read_intrinsics
from lanewright.formats.ground import MOST_BYTES as MOST_GROUND_BYTES
from lanewright.formats.ground import SIM2_LIMITS, GroundHeight, parse_ground
from lanewright.formats.lidar import Sweep, read_sweep
from lanewright.formats.poses import Pose, Poses, read_poses
from lanewright.formats.untrusted_file import read_bytes
from lanewright.sensors.frames import LONGEST_LAG_NS, Frames, frame_index
from lanewright.sensors.lidar_image import LidarImage, lidar_image

TRAJECTORY_STEP = 1.0

Progress = Callable[[str, int, int], None]
"""Called with what is being read, how much of it is done, and how much there is."""


@dataclass(frozen=True, slots=True)
class GroundFiles:
    """The ground raster as it lies on disk, and parsed."""

    raster: bytes
    placement: bytes
    height: GroundHeight


@dataclass(frozen=True, slots=True)
class LogBundle:
    """One log as values.

    Attributes:
        directory: where it was read; gives log id, layout (dataset), city and the name of the map file.
        map_bytes, map_sha256: the map file as it was read, and its hash.
        fingerprint: hash by which the same log is known again (``log_fingerprint``).
        frames: frame index, and the number of files by sensor.
        files: every image and sweep, by sensor and time.
        trajectory: ego positions as in the pose file, thinned to one per more than a metre, first and last kept.
        extrinsics, intrinsics: by sensor; None without calibration.
        absent: parts of a complete log that this one lacks, in words.
    """

    directory: LogDirectory
    map: MapDocument
    map_bytes: bytes
    map_sha256: bytes
    fingerprint: bytes
    frames: Frames
    files: tuple[SensorFile, ...]
    trajectory: tuple[Point, ...]
    ground: GroundFiles | None
    lidar: LidarImage | None
    extrinsics: Mapping[str, Pose] | None
    intrinsics: Mapping[str, Intrinsics] | None
    absent: tuple[str, ...]


def read_log(path: Path, *, progress: Progress = lambda what, done, total: None) -> LogBundle:
    """The log in the folder ``path``.

    Raises:
        InvalidInput: a file is missing or unusable; names file, element, key and the mend.
    """
    log = open_log(path)
    map_bytes = read_bytes(log.path(log.map_file), most_bytes=MAP_LIMITS.size, name=log.map_file)
    document = parse_map(map_bytes, Path(log.map_file).name)
    poses = read_poses(log.path(POSES), POSES)
    files = log.sensor_files()
    ground = _read_ground(log)
    extrinsics = read_extrinsics(log.path(EXTRINSICS), EXTRINSICS) if EXTRINSICS in log else None
    intrinsics = read_intrinsics(log.path(INTRINSICS), INTRINSICS) if INTRINSICS in log else None
    sweeps = _timed_sweeps(files.get(LIDAR, ()), poses)
    without_pose = len(files.get(LIDAR, ())) - len(sweeps)
    lidar = lidar_image(
        _read_sweeps(log, sweeps, poses, progress), poses.values[:, 4:], ground.height.at if ground else None
    )
    absent = {
        "extrinsic calibration": extrinsics is None,
        "intrinsic calibration": intrinsics is None,
        "ground height": ground is None,
        "lidar": LIDAR not in files,
        "cameras": not files.keys() - {LIDAR},
        f"poses of {without_pose} lidar sweeps": without_pose > 0,
    }
    return LogBundle(
        directory=log,
        map=document,
        map_bytes=map_bytes,
        map_sha256=hashlib.sha256(map_bytes).digest(),
        fingerprint=log_fingerprint(log),
        frames=frame_index(poses, files),
        files=tuple(file for own in files.values() for file in own),
        trajectory=_trajectory(poses),
        ground=ground,
        lidar=lidar,
        extrinsics=extrinsics,
        intrinsics=intrinsics,
        absent=tuple(what for what, lacking in absent.items() if lacking),
    )


def log_fingerprint(log: LogDirectory) -> bytes:
    """SHA-256 by which a log is known again without reading its sensors.

    Covers the contents of map, poses, calibration and ground, and names and sizes of images and sweeps.
    """
    whole = hashlib.sha256()
    sensors = {file.path for own in log.sensor_files().values() for file in own}
    parts = {POSES, INTRINSICS, EXTRINSICS, log.map_file, *(file for file in log.ground_files if file)}
    for file in log.files:
        if file in sensors:
            whole.update(f"{file}\0{log.path(file).stat().st_size}\0".encode())
        elif file in parts:
            contents = read_bytes(log.path(file), most_bytes=MOST_GROUND_BYTES, name=file)
            whole.update(f"{file}\0{hashlib.sha256(contents).hexdigest()}\0".encode())
    return whole.digest()


def _read_ground(log: LogDirectory) -> GroundFiles | None:
    raster_file, placement_file = log.ground_files
    if raster_file is None or placement_file is None:
        return None
    raster = read_bytes(log.path(raster_file), most_bytes=MOST_GROUND_BYTES, name=raster_file)
    placement = read_bytes(log.path(placement_file), most_bytes=SIM2_LIMITS.size, name=placement_file)
    return GroundFiles(raster, placement, parse_ground(raster, raster_file, placement, placement_file))


def _timed_sweeps(sweeps: tuple[SensorFile, ...], poses: Poses) -> list[tuple[int, SensorFile]]:
    """Sweeps with the row of their pose; without those that have no pose near their time."""
    rows = [(poses.nearest(sweep.timestamp_ns), sweep) for sweep in sweeps]
    return [
        (row, sweep) for row, sweep in rows if abs(int(poses.timestamps_ns[row]) - sweep.timestamp_ns) <= LONGEST_LAG_NS
    ]


def _read_sweeps(
    log: LogDirectory, sweeps: list[tuple[int, SensorFile]], poses: Poses, progress: Progress
) -> Iterator[tuple[Pose, Sweep]]:
    for done, (row, sweep) in enumerate(sweeps):
        progress("lidar sweeps", done, len(sweeps))
        yield poses[row], read_sweep(log.path(sweep.path), sweep.path)
    progress("lidar sweeps", len(sweeps), len(sweeps))


def _trajectory(poses: Poses) -> tuple[Point, ...]:
    rows = list(poses.rows_every(TRAJECTORY_STEP))
    last = len(poses) - 1
    if rows[-1] != last:
        rows.append(last)
    return tuple((pose.tx_m, pose.ty_m, pose.tz_m) for pose in (poses[row] for row in rows))
