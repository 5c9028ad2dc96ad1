"""The drive through a log: a route along lanes, a speed that suits the bends, and poses at every sensor's moment."""

from __future__ import annotations

import heapq
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
import shapely

from lanewright.core.elements import Line, MapState
from lanewright.demo.ground import Ground
from lanewright.demo.path import Array

POSE_HEIGHT_M = 0.32
"""The ego frame sits this far above the ground (AV2: 0.30 to 0.32 m)."""
LARGEST_SPEED = 10.5
SIDE_ACCELERATION = 1.8
ACCELERATION = 1.2
LIDAR_PERIOD_NS = 100_000_000
CAMERA_PERIOD_NS = 50_000_000
CAMERA_PHASES_NS = (4_112_000, 12_020_000, 20_290_000, 28_230_000, 28_230_001, 36_410_000, 44_650_000)
"""Two cameras fire 1 ns apart: real logs hold such pairs."""
EARLIEST_NS = 315_966_000_000_000_000


@dataclass(frozen=True)
class Poses:
    """Ego poses in the city frame: timestamps (n,) in ns, quaternions (n, 4) wxyz, positions (n, 3)."""

    timestamps: npt.NDArray[np.int64]
    quaternions: Array
    positions: Array
    sweeps: tuple[int, ...]
    """Rows at which the lidar completes a sweep, at 10 Hz."""

    @property
    def trajectory(self) -> shapely.LineString:
        return shapely.LineString(self.positions[:, :2])

    def rotation(self, row: int) -> Array:
        """Rotation matrix (3, 3) of city from ego."""
        w, x, y, z = self.quaternions[row]
        return np.array(
            [
                [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
            ]
        )


def route(state: MapState, start: int, goal: int) -> Array:
    """Points (n, 2) every half metre along the shortest way over links from lane to lane, corners smoothed."""
    before: dict[int, int] = {}
    queue, settled = [(0.0, start, start)], set()
    while queue:
        length, lane, previous = heapq.heappop(queue)
        if lane in settled:
            continue
        settled.add(lane)
        before[lane] = previous
        if lane == goal:
            break
        for follower in state.lanes[lane].successors:
            heapq.heappush(queue, (length + _length(state.lanes[follower].left_boundary), follower, lane))
    if goal not in before:
        raise ValueError(f"no way leads from lane {start} to lane {goal}")
    lanes = [goal]
    while lanes[-1] != start:
        lanes.append(before[lanes[-1]])
    centre = np.concatenate([_centreline(state, lane) for lane in reversed(lanes)])
    return _smooth(_resample(centre, 0.5), 9)


def _length(line: Line) -> float:
    return float(shapely.LineString(line).length)


def _centreline(state: MapState, lane: int) -> Array:
    shares = np.linspace(0, 1, 60)
    sides = [
        shapely.line_interpolate_point(shapely.LineString(line), shares, normalized=True)
        for line in (state.lanes[lane].left_boundary, state.lanes[lane].right_boundary)
    ]
    middle = (shapely.get_coordinates(sides[0]) + shapely.get_coordinates(sides[1])) / 2
    return np.asarray(middle[:-1])


def _resample(points: Array, step: float) -> Array:
    at = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))])
    wanted = np.arange(0.0, at[-1], step)
    return np.column_stack([np.interp(wanted, at, points[:, 0]), np.interp(wanted, at, points[:, 1])])


def _smooth(points: Array, window: int) -> Array:
    padded = np.pad(points, ((window // 2, window // 2), (0, 0)), mode="edge")
    kernel = np.ones(window) / window
    smooth = np.column_stack([np.convolve(padded[:, axis], kernel, mode="valid") for axis in (0, 1)])
    return smooth[window // 2 : -(window // 2)]


def drive(points: Array, start: float, length: float, ground: Ground, generator: np.random.Generator) -> Poses:
    """Poses while driving ``length`` metres of a route (points every half metre), from ``start`` metres on."""
    stations = np.arange(len(points)) * 0.5
    direction = np.unwrap(np.arctan2(np.gradient(points[:, 1]), np.gradient(points[:, 0])))
    speed = _speed(np.abs(np.gradient(direction, 0.5)))
    moments = np.concatenate([[0.0], np.cumsum(0.5 / ((speed[1:] + speed[:-1]) / 2))])
    begin, end = np.interp([start, min(start + length, stations[-1])], stations, moments)
    timestamps, sweeps = _timestamps(float(end - begin), generator)
    at = np.interp(begin + (timestamps - timestamps[0]) / 1e9, moments, stations)
    xy = np.column_stack([np.interp(at, stations, points[:, axis]) for axis in (0, 1)])
    heading = np.interp(at, stations, direction)
    step = 1.0
    ahead = np.column_stack([np.cos(heading), np.sin(heading)]) * step
    aside = np.column_stack([-ahead[:, 1], ahead[:, 0]])
    rise = np.arctan((ground.heights(xy + ahead) - ground.heights(xy - ahead)) / (2 * step))
    bank = np.arctan((ground.heights(xy + aside) - ground.heights(xy - aside)) / (2 * step))
    positions = np.column_stack([xy, ground.heights(xy) + POSE_HEIGHT_M])
    return Poses(timestamps, _quaternions(heading, -rise, bank), positions, sweeps)


def _speed(curvature: Array) -> Array:
    """The largest speed that keeps sideways and lengthwise acceleration comfortable."""
    speed = np.minimum(LARGEST_SPEED, np.sqrt(SIDE_ACCELERATION / np.maximum(curvature, 1e-4)))
    for order in (range(1, len(speed)), range(len(speed) - 2, -1, -1)):
        for i in order:
            neighbour = i - order.step
            speed[i] = min(speed[i], float(np.sqrt(speed[neighbour] ** 2 + ACCELERATION)))
    return np.asarray(speed)


def _timestamps(seconds: float, generator: np.random.Generator) -> tuple[npt.NDArray[np.int64], tuple[int, ...]]:
    """One row per sensor event (150 a second), ascending and unique; and the rows of the lidar's sweeps."""
    first = EARLIEST_NS + int(generator.integers(0, 10**13))
    duration = int(seconds * 1e9)
    lidar = np.arange(0, duration, LIDAR_PERIOD_NS, dtype=np.int64)
    cameras = [np.arange(phase, duration, CAMERA_PERIOD_NS, dtype=np.int64) for phase in CAMERA_PHASES_NS]
    events = np.unique(np.concatenate([lidar, *cameras]))
    return first + events, tuple(int(row) for row in np.searchsorted(events, lidar))


def _quaternions(yaw: Array, pitch: Array, roll: Array) -> Array:
    """Quaternions (n, 4) wxyz of yaw, then pitch, then roll (radians)."""
    cy, sy = np.cos(yaw / 2), np.sin(yaw / 2)
    cp, sp = np.cos(pitch / 2), np.sin(pitch / 2)
    cr, sr = np.cos(roll / 2), np.sin(roll / 2)
    return np.column_stack(
        [
            cr * cp * cy + sr * sp * sy,
            sr * cp * cy - cr * sp * sy,
            cr * sp * cy + sr * cp * sy,
            cr * cp * sy - sr * sp * cy,
        ]
    )
