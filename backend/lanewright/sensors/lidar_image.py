"""The intensity image under the map: what the lidar saw of the road surface, seen from above, exact in metres.

Lane paint reflects more than asphalt, so its mean intensity shows the marks as they are painted today. Returns are
summed sweep by sweep into one grid, so memory depends on the place, not on how long the log is.
"""

from __future__ import annotations

import io
import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Any

import numpy as np
from PIL import Image

from lanewright.formats.lidar import Sweep
from lanewright.formats.poses import FloatArray, Pose

RESOLUTION = 0.10
"""Metres a pixel; lane paint is 0.10 to 0.15 m wide."""
REACH = 60.0
"""Returns from further away are few, slanting, and inexact in float16."""
GROUND_TOLERANCE = 0.3
MOST_PIXELS_A_SIDE = 8192
"""What browsers take as one texture."""
MOST_PIXELS = 24_000_000

_EGO_HEIGHT = 0.32  # of the ego origin above the ground (measured on real logs)
_SLOPE = 0.03  # that a road may have where no raster tells its height
# Asphalt differs from street to street and from laser to laser, so paint is told by how much brighter it is than what
# lies around it: against one range for the whole image, measured on real logs, it stood out less by a sixth to a third.
_AROUND_PIXELS = 20  # to each side; far wider than paint, far narrower than a street
_WHITE = 4.0  # times as bright as its surroundings
_LEAST_SURROUNDINGS = 3.0  # of 255: on the blackest asphalt noise must not be stretched to paint
_GAMMA = 0.8
_FILLED_ALPHA = (190, 110)  # of pixels one and two steps from a return: a few sweeps leave rings with gaps
_FILLED_PIXELS = len(_FILLED_ALPHA)
_STRIP_ROWS = 512

Bounds = tuple[float, float, float, float]
"""Min x, min y, max x, max y in city metres."""
Array = np.ndarray[Any, np.dtype[Any]]
HeightAt = Callable[[FloatArray], FloatArray]


@dataclass(frozen=True, slots=True)
class LidarImage:
    """North-up picture with transparency where nothing was seen.

    Attributes:
        png: gray and alpha; the top left corner is (min x, max y).
        bounds: outer edges of the outer pixels.
        resolution: metres a pixel.
        sweeps: how many went in.
    """

    png: bytes
    bounds: Bounds
    resolution: float
    sweeps: int


def lidar_image(
    sweeps: Iterable[tuple[Pose, Sweep]],
    trajectory: FloatArray,
    height_at: HeightAt | None,
    resolution: float = RESOLUTION,
) -> LidarImage | None:
    """Mean intensity of the ground returns of all sweeps.

    Args:
        sweeps: each with the pose at its own time; taken one by one.
        trajectory: ego positions, shape (N, ≥ 2): the image reaches 60 m around them at most.
        height_at: ground height by place (NaN: unknown). Where it is known, returns within 0.3 m of it are ground;
            where it is not, or without it, those at the height of the wheels, give or take a slope of 3 %.
        resolution: metres a pixel; coarser by steps of 0.05 m if the image would get too large.

    Returns:
        None when not one return was ground.
    """
    grid = _Grid(trajectory, resolution)
    count = 0
    for pose, sweep in sweeps:
        points = sweep.points.astype(np.float64)
        near = np.hypot(points[:, 0], points[:, 1]) <= REACH
        points, intensity = points[near], sweep.intensity[near]
        city = points @ pose.rotation.T + pose.translation
        ground = _is_ground(points, city, height_at)
        grid.add(city[ground], intensity[ground])
        count += 1
    return grid.image(count)


def _is_ground(points: FloatArray, city: FloatArray, height_at: HeightAt | None) -> np.ndarray[Any, np.dtype[np.bool_]]:
    reach = np.hypot(points[:, 0], points[:, 1])
    by_slope = np.abs(points[:, 2] + _EGO_HEIGHT) <= GROUND_TOLERANCE + _SLOPE * reach
    if height_at is None:
        return by_slope
    off = np.abs(city[:, 2] - height_at(city))
    return np.where(np.isnan(off), by_slope, off <= GROUND_TOLERANCE)


class _Grid:
    """Sum and number of intensities by pixel; pixel edges lie at whole multiples of the resolution."""

    def __init__(self, trajectory: FloatArray, resolution: float) -> None:
        low = trajectory[:, :2].min(axis=0) - REACH
        high = trajectory[:, :2].max(axis=0) + REACH
        while _too_large((high - low) / resolution):
            resolution = round(resolution + 0.05, 2)
        self.resolution = resolution
        self.first = np.floor(low / resolution).astype(np.int64)
        self.columns, self.rows = (np.ceil(high / resolution).astype(np.int64) - self.first).tolist()
        self.sums = np.zeros(self.rows * self.columns, dtype=np.float32)
        self.counts = np.zeros(self.rows * self.columns, dtype=np.uint32)

    def add(self, city: FloatArray, intensity: Array) -> None:
        cells = np.floor(city[:, :2] / self.resolution).astype(np.int64) - self.first
        inside = ((cells >= 0) & (cells < (self.columns, self.rows))).all(axis=1)
        index = cells[inside, 1] * self.columns + cells[inside, 0]
        np.add.at(self.sums, index, intensity[inside].astype(np.float32))
        np.add.at(self.counts, index, np.uint32(1))

    def image(self, sweeps: int) -> LidarImage | None:
        counts = self.counts.reshape(self.rows, self.columns)
        seen = counts > 0
        if not seen.any():
            return None
        rows, columns = np.flatnonzero(seen.any(axis=1)), np.flatnonzero(seen.any(axis=0))
        low = np.array([columns[0], rows[0]]) - _FILLED_PIXELS
        high = np.array([columns[-1], rows[-1]]) + _FILLED_PIXELS + 1
        low, high = np.maximum(low, 0), np.minimum(high, (self.columns, self.rows))
        part = np.s_[low[1] : high[1], low[0] : high[0]]
        sums, counts = self.sums.reshape(self.rows, self.columns)[part], counts[part]
        pixels = _pixels(sums, counts)
        file = io.BytesIO()
        Image.fromarray(pixels).save(file, format="PNG", compress_level=6)
        edges = np.concatenate([low + self.first, high + self.first]) * self.resolution
        return LidarImage(file.getvalue(), tuple(edges.round(6).tolist()), self.resolution, sweeps)


def _too_large(size: FloatArray) -> bool:
    columns, rows = (math.ceil(side) + 1 for side in size.tolist())
    return bool(max(columns, rows) > MOST_PIXELS_A_SIDE or columns * rows > MOST_PIXELS)


def _pixels(sums: Array, counts: Array) -> Array:
    """Gray and alpha from the grid, rows turned north up. Worked in strips: it needs little beyond the result."""
    pixels = np.zeros((*sums.shape, 2), dtype=np.uint8)
    for top in range(0, len(sums), _STRIP_ROWS):
        first, end = max(0, top - _AROUND_PIXELS), min(len(sums), top + _STRIP_ROWS + _AROUND_PIXELS)
        means, alpha = _filled(sums[first:end], counts[first:end])
        brightness = means / np.maximum(_surroundings(means, alpha == 255), _LEAST_SURROUNDINGS)
        scaled = np.clip(brightness / _WHITE, 0.0, 1.0) ** _GAMMA
        strip = np.stack([np.where(alpha > 0, np.rint(255 * scaled), 0), alpha], axis=-1)
        pixels[top : top + _STRIP_ROWS] = strip[top - first : top - first + _STRIP_ROWS]
    return np.ascontiguousarray(pixels[::-1])


def _filled(sums: Array, counts: Array) -> tuple[Array, Array]:
    """Mean intensity and alpha; pixels beside seen ones take their mean, fainter with each step away."""
    seen = counts > 0
    means = np.divide(sums, counts, out=np.zeros(sums.shape, dtype=np.float32), where=seen)
    alpha = np.where(seen, 255, 0).astype(np.uint8)
    for fainter in _FILLED_ALPHA:
        total, number = _around(means, 1), _around(seen, 1)
        new = ~seen & (number > 0)
        means[new] = total[new] / number[new]
        alpha[new] = fainter
        seen = seen | new
    return means, alpha


def _surroundings(means: Array, seen: Array) -> Array:
    """Mean intensity of what was seen within 2 m."""
    total, number = _around(np.where(seen, means, 0), _AROUND_PIXELS), _around(seen, _AROUND_PIXELS)
    return np.asarray(total / np.maximum(number, 1))


def _around(values: Array, reach: int) -> Array:
    """Sum over the square of pixels up to ``reach`` away."""
    side = 2 * reach + 1
    sums = np.pad(values, ((reach + 1, reach), (reach + 1, reach))).cumsum(0, dtype=np.float64).cumsum(1)
    return np.asarray(sums[side:, side:] - sums[:-side, side:] - sums[side:, :-side] + sums[:-side, :-side])
