"""Demo logs: from a seed to maps in memory, and to log folders on disk."""

from __future__ import annotations

import json
import string
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from lanewright.core.changes import Direction
from lanewright.core.elements import Line, MapState
from lanewright.demo.assembly import Names, assemble
from lanewright.demo.crop import crop
from lanewright.demo.drive import Poses, drive, route
from lanewright.demo.ground import Ground
from lanewright.demo.lidar import sweeps
from lanewright.demo.network import draft
from lanewright.demo.plan import Plan
from lanewright.demo.scenarios import SCENARIOS, Scenario
from lanewright.demo.surface import drivable_areas, ground_raster, pavement, tiles_near
from lanewright.demo.writer import (
    write_calibration,
    write_map,
    write_poses,
    write_raster,
    write_sweep,
)

LOG_ID_LENGTH = 32


@dataclass(frozen=True)
class DemoLog:
    """A log and what it knows beyond its folder.

    Attributes:
        base: the map on disk: stale if the direction is ``prior_to_current``, else the current world.
        changed: the other map, written beside the folder.
        source_split: where it would stand in TbV (its train maps are up to date, its val maps stale).
        split: release split, ``train``, ``val`` or ``test``.
    """

    log_id: str
    city: str
    source_split: str
    split: str
    direction: Direction
    base: MapState
    changed: MapState
    folder: Path
    changed_path: Path


@dataclass(frozen=True)
class _World:
    """Everything about a log before it is written."""

    scenario: Scenario
    log_id: str
    city_number: int
    ground: Ground
    poses: Poses
    base: MapState
    changed: MapState
    generator: np.random.Generator

    @property
    def current(self) -> MapState:
        return self.base if self.scenario.direction is Direction.CURRENT_TO_PRIOR else self.changed


def demo_maps(seed: int, logs: int = len(SCENARIOS)) -> list[tuple[MapState, MapState]]:
    """Base and changed map of each demo log, in memory."""
    return [(world.base, world.changed) for world in _worlds(seed, logs)]


def generate(seed: int, out_dir: Path, logs: int = len(SCENARIOS)) -> list[DemoLog]:
    """Write demo logs below ``out_dir``, ``demo.json`` and ``splits.json``; the same seed gives the same bytes.

    Raises:
        OSError: the folder cannot be written.
    """
    out_dir.mkdir(parents=True, exist_ok=True)
    written = [_write(world, out_dir) for world in _worlds(seed, logs)]
    _write_lists(seed, written, out_dir)
    return written


def _write_lists(seed: int, logs: list[DemoLog], out_dir: Path) -> None:
    """``demo.json`` says all about each log; ``splits.json`` has the shape of TbV's list of source splits."""
    contents = [
        {
            "log_id": log.log_id,
            "city": log.city,
            "source_split": log.source_split,
            "split": log.split,
            "direction": log.direction.value,
            "changed": log.changed_path.name,
        }
        for log in logs
    ]
    splits = {name: [log.log_id for log in logs if log.source_split == name] for name in ("train", "val", "test")}
    for name, value in (("splits.json", splits), ("demo.json", {"seed": seed, "logs": contents})):
        (out_dir / name).write_text(json.dumps(value, indent=1) + "\n", encoding="utf-8")


def _worlds(seed: int, logs: int) -> Iterator[_World]:
    for index in range(logs):
        generator = np.random.default_rng([seed, index])
        yield _world(SCENARIOS[index % len(SCENARIOS)](generator), generator)


def _world(scenario: Scenario, generator: np.random.Generator) -> _World:
    first = next(iter(scenario.current.roads.values())).path
    ground = Ground.random(generator, first.x, first.y)
    names = Names(generator)
    plans: tuple[Plan, Plan] = (scenario.stale, scenario.current)
    if scenario.direction is Direction.CURRENT_TO_PRIOR:
        plans = (scenario.current, scenario.stale)
    base, changed = (assemble(draft(plan, ground), names, one_sided=scenario.one_sided) for plan in plans)
    current = base if scenario.direction is Direction.CURRENT_TO_PRIOR else changed
    start, goal = (names.ids[name] for name in scenario.route)
    poses = drive(route(current, start, goal), *scenario.drive, ground, generator)
    base, changed = crop(base, changed, poses.trajectory)
    letters = list(string.ascii_letters + string.digits)
    label = f"LanewrightDemo{scenario.name.capitalize()}"
    tail = "".join(generator.choice(letters, LOG_ID_LENGTH - len(label)))
    city_number = int(generator.integers(10_000, 99_999))
    return _World(scenario, f"{label}{tail}__{scenario.season}", city_number, ground, poses, base, changed, generator)


def _write(world: _World, out_dir: Path) -> DemoLog:
    scenario, log_id, city = world.scenario, world.log_id, world.scenario.city
    folder, changed_path = out_dir / log_id, out_dir / f"{log_id}.changed.json"
    surface = pavement(scenario.current)
    cropped = surface.intersection(tiles_near(world.poses.trajectory))
    first_area = int(world.generator.integers(1_000_000, 1_900_000))
    areas: list[tuple[int, Line]] = [
        (first_area + 31 * index, ring) for index, ring in enumerate(drivable_areas(cropped, world.ground))
    ]
    name = f"log_map_archive_{log_id}____{city}_city_{world.city_number}.json"
    write_map(folder / "map" / name, world.base, areas)
    write_map(changed_path, world.changed, areas)
    write_raster(folder / "map", log_id, city, *ground_raster(cropped, world.ground))
    write_poses(folder, world.poses)
    write_calibration(folder / "calibration")
    for sweep in sweeps(world.current, surface, world.ground, world.poses, world.generator):
        write_sweep(folder / "sensors" / "lidar", sweep.timestamp, sweep.points, sweep.marks)
    return DemoLog(
        log_id,
        city,
        scenario.source_split,
        scenario.split,
        scenario.direction,
        world.base,
        world.changed,
        folder,
        changed_path,
    )
