"""Lidar sweeps: rays cast from the roof onto ground, curbs, facades and poles; paint shines brighter than asphalt."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
import shapely

from lanewright.core.elements import MapState
from lanewright.demo.calibration import LIDARS
from lanewright.demo.drive import Poses
from lanewright.demo.ground import Ground
from lanewright.demo.paint import Cover, Surface, painted
from lanewright.demo.path import Array
from lanewright.demo.scenery import Walls, scenery

SWEEP_EVERY_M = 5.0
SWEEP_EVERY_NS = 800_000_000
"""Of the 10 Hz sweeps one is kept per so many metres, or so much time where the drive is slow: the demo stays small."""
REACH_M = 70.0
AZIMUTHS = 600
LASERS = 64
CURB_HEIGHT_M = 0.13
RANGE_NOISE_M = 0.015
INTENSITY = {
    Cover.GRASS: (24.0, 8.0),
    Cover.SIDEWALK: (15.0, 4.0),
    Cover.CURB: (22.0, 5.0),
    Cover.ASPHALT: (6.0, 2.0),
    Cover.WHITE: (78.0, 16.0),
    Cover.YELLOW: (52.0, 12.0),
    Cover.BLUE: (34.0, 8.0),
}
"""Mean and spread of returns by cover, as read off real sweeps (asphalt 4 to 12, paint 50 and more)."""


@dataclass(frozen=True)
class Sweep:
    """Points (n, 3) in the ego frame, and intensity and laser number (n, 2)."""

    timestamp: int
    points: npt.NDArray[np.float16]
    marks: npt.NDArray[np.uint8]


def sweeps(
    state: MapState, pavement: shapely.Geometry, ground: Ground, poses: Poses, generator: np.random.Generator
) -> Iterator[Sweep]:
    """Sweeps along the drive, each at a moment that has an exact pose."""
    bounds = poses.trajectory.buffer(REACH_M).bounds
    surface = painted(state, pavement, bounds)
    walls = scenery(pavement, generator)
    last: int | None = None
    for row in poses.sweeps:
        here = poses.positions[row, :2]
        if (
            last is None
            or np.linalg.norm(here - poses.positions[last, :2]) >= SWEEP_EVERY_M
            or poses.timestamps[row] - poses.timestamps[last] >= SWEEP_EVERY_NS
        ):
            last = row
            yield _sweep(row, poses, surface, walls.near(float(here[0]), float(here[1]), REACH_M), ground, generator)


def _sweep(
    row: int, poses: Poses, surface: Surface, walls: Walls, ground: Ground, generator: np.random.Generator
) -> Sweep:
    rotation, position = poses.rotation(row), poses.positions[row]
    origin = rotation @ np.array(LIDARS[0][2]) + position
    azimuths = generator.uniform(0, 2 * np.pi / AZIMUTHS) + np.arange(AZIMUTHS) * 2 * np.pi / AZIMUTHS
    elevations = _elevations()
    lasers = np.repeat(np.arange(LASERS), AZIMUTHS)
    elevation, azimuth = elevations[lasers], np.tile(azimuths, LASERS)
    directions = np.column_stack(
        [np.cos(elevation) * np.cos(azimuth), np.cos(elevation) * np.sin(azimuth), np.sin(elevation)]
    )
    directions = directions @ rotation.T
    flat = directions[:, :2] / np.linalg.norm(directions[:, :2], axis=1)[:, None]
    slope = directions[:, 2] / np.linalg.norm(directions[:, :2], axis=1)
    ground_reach = _ground_reach(origin, flat, slope, ground)
    wall_reach, wall_index = _wall_reach(origin, flat[:AZIMUTHS], walls)
    wall_reach, wall_index = np.tile(wall_reach, LASERS), np.tile(wall_index, LASERS)
    with np.errstate(invalid="ignore"):
        foot = ground.heights(origin[:2] + np.where(np.isfinite(wall_reach), wall_reach, 0)[:, None] * flat)
        above = origin[2] + wall_reach * slope - foot
        on_wall = (wall_reach < ground_reach) & (above < walls.heights[wall_index]) & (above > 0)
    on_ground = ~on_wall & (ground_reach < REACH_M)
    reach = np.where(on_wall, wall_reach, ground_reach)
    covers = surface.at(origin[:2] + flat * np.minimum(reach, REACH_M)[:, None])
    lost = np.where(on_ground & (covers == Cover.GRASS), np.clip(reach / 40, 0.1, 0.9), 0.02)
    kept = (on_wall | on_ground) & (generator.random(len(reach)) > lost)
    reach, flat, slope, lasers, on_wall = reach[kept], flat[kept], slope[kept], lasers[kept], on_wall[kept]
    noisy = reach + generator.normal(0, RANGE_NOISE_M, len(reach))
    points = np.column_stack([origin[:2] + flat * noisy[:, None], origin[2] + slope * noisy])
    covers = surface.at(points[:, :2])
    raised = ~on_wall & (covers < Cover.ASPHALT)
    points[raised, 2] += CURB_HEIGHT_M
    intensity = np.where(on_wall, walls.intensities[wall_index[kept]], 0.0) * generator.uniform(0.6, 1.4, len(reach))
    means, spreads = (np.array([INTENSITY[cover][i] for cover in Cover]) for i in (0, 1))
    returned = generator.normal(means[covers], spreads[covers])
    worn = (covers >= Cover.WHITE) & (generator.random(len(covers)) < 0.1)
    returned[worn] *= 0.3
    intensity = np.where(on_wall, intensity, returned)
    ego = (points - position) @ rotation
    marks = np.column_stack([np.clip(intensity, 0, 255), lasers]).astype(np.uint8)
    return Sweep(int(poses.timestamps[row]), ego.astype(np.float16), marks)


def _elevations() -> Array:
    """Angles of the lasers in radians: most look at the ground, evenly in reach; the rest above the horizon."""
    height = LIDARS[0][2][2] + 0.32
    on_ground = -np.arctan2(height, np.geomspace(3.2, 55.0, LASERS * 3 // 4))
    return np.concatenate([on_ground, np.radians(np.linspace(-1.2, 12.0, LASERS - len(on_ground)))])


def _ground_reach(origin: Array, flat: Array, slope: Array, ground: Ground) -> Array:
    """Horizontal distance at which each ray meets the smooth ground; infinite where it does not."""
    with np.errstate(divide="ignore", invalid="ignore"):
        reach = np.where(slope < -0.005, 1.9 / -slope, np.inf)
        for _ in range(4):
            bounded = np.clip(reach, 0, 2 * REACH_M)
            drop = origin[2] - ground.heights(origin[:2] + bounded[:, None] * flat)
            reach = np.where(slope < -0.005, drop / -slope, np.inf)
        bounded = np.clip(reach, 0, 2 * REACH_M)
        miss = origin[2] + slope * bounded - ground.heights(origin[:2] + bounded[:, None] * flat)
    return np.where((np.abs(miss) < 0.05) & (reach > 0), reach, np.inf)


def _wall_reach(origin: Array, flat: Array, walls: Walls) -> tuple[Array, npt.NDArray[np.int64]]:
    """Horizontal distance of the first wall in each azimuth (infinite where none stands), and which it is."""
    start = walls.ends[:, :2] - origin[:2]
    span = walls.ends[:, 2:] - walls.ends[:, :2]
    with np.errstate(divide="ignore", invalid="ignore"):
        cross = flat[:, :1] * span[:, 1] - flat[:, 1:] * span[:, 0]
        reach = (start[:, 0] * span[:, 1] - start[:, 1] * span[:, 0]) / cross
        share = (start[:, 0] * flat[:, 1:] - start[:, 1] * flat[:, :1]) / cross
    hit = (reach > 1.0) & (share >= 0) & (share <= 1)
    reach = np.where(hit, reach, np.inf)
    first = np.argmin(reach, axis=1)
    return reach[np.arange(len(flat)), first], first
