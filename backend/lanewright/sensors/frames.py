"""The frame index of a log: the moments at which its map is looked at, one per more than 5 m of motion.

As in TbV's evaluation timestamps, the first moment of a drive is always a frame. Where lidar sweeps cover the drive,
frames are moments of sweeps; where they do not (the samples hold one or two), they are moments of poses.
"""

from __future__ import annotations

import itertools
from bisect import bisect_left
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from lanewright.formats.av2_log import LIDAR, SensorFile
from lanewright.formats.poses import Pose, Poses

MOTION_PER_FRAME = 5.0
LONGEST_GAP_NS = 1_000_000_000
"""Poses further apart begin a new drive; sweeps further apart do not cover it."""
LONGEST_LAG_NS = 60_000_000
"""A sensor file belongs to a frame within 60 ms: sweeps come at 10 Hz, images at 20 Hz."""


@dataclass(frozen=True, slots=True)
class Frame:
    """One moment of a drive.

    Attributes:
        drive: index of the run of poses without a gap that it belongs to.
        files: sensor -> relative path of its file nearest in time, where one is near enough.
    """

    drive: int
    timestamp_ns: int
    pose: Pose
    files: Mapping[str, str]


@dataclass(frozen=True, slots=True)
class Frames:
    """All frames of a log in order of time, and how many files each of its sensors left."""

    frames: tuple[Frame, ...]
    sensors: Mapping[str, int]


def frame_index(poses: Poses, files: Mapping[str, Sequence[SensorFile]]) -> Frames:
    """Frames from the poses and the sensor files, each sensor's in order of time."""
    sweeps = [file.timestamp_ns for file in files.get(LIDAR, ())]
    times = {sensor: [file.timestamp_ns for file in own] for sensor, own in files.items()}
    frames = []
    for drive, rows in enumerate(_drives(poses)):
        for row in poses.rows_every(MOTION_PER_FRAME, _moments(poses, rows, sweeps)):
            timestamp_ns = int(poses.timestamps_ns[row])
            near = {sensor: _nearest(own, times[sensor], timestamp_ns) for sensor, own in files.items()}
            found = {sensor: file.path for sensor, file in near.items() if file is not None}
            frames.append(Frame(drive, timestamp_ns, poses[row], found))
    return Frames(tuple(frames), {sensor: len(own) for sensor, own in files.items()})


def _drives(poses: Poses) -> Iterator[range]:
    """Rows of each run of poses in which none is more than a second after the one before."""
    times = poses.timestamps_ns.tolist()
    breaks = [row for row in range(1, len(times)) if times[row] - times[row - 1] > LONGEST_GAP_NS]
    for first, end in itertools.pairwise([0, *breaks, len(times)]):
        yield range(first, end)


def _moments(poses: Poses, rows: range, sweeps: list[int]) -> Iterator[int]:
    """The rows of the sweeps if these leave no gap in the drive, else all its rows."""
    first_ns, last_ns = int(poses.timestamps_ns[rows[0]]), int(poses.timestamps_ns[rows[-1]])
    own = [time for time in sweeps if first_ns <= time <= last_ns]
    if all(later - earlier <= LONGEST_GAP_NS for earlier, later in itertools.pairwise([first_ns, *own, last_ns])):
        return iter(dict.fromkeys(poses.nearest(time) for time in own) or rows)
    return iter(rows)


def _nearest(files: Sequence[SensorFile], times: list[int], timestamp_ns: int) -> SensorFile | None:
    after = bisect_left(times, timestamp_ns)
    near = range(max(0, after - 1), min(len(files), after + 1))
    best = min(near, key=lambda i: abs(times[i] - timestamp_ns), default=None)
    return files[best] if best is not None and abs(times[best] - timestamp_ns) <= LONGEST_LAG_NS else None
