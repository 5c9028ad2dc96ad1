"""Bringing a log in: its map as a base line of exact elements, its drive and pictures as files kept beside it."""

from __future__ import annotations

import hashlib
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from enum import StrEnum
from pathlib import Path
from types import MappingProxyType
from typing import Any

import orjson
from sqlalchemy import func, select
from sqlalchemy.orm import Session

from lanewright.core.changes import Direction
from lanewright.core.errors import Conflict, InvalidInput, Place
from lanewright.db.models import Log
from lanewright.db.repositories import logs
from lanewright.formats.av2_log import open_log
from lanewright.formats.splits import Assignment, SourceSplits, Split
from lanewright.formats.untrusted_file import read_bytes
from lanewright.sensors.log_bundle import LogBundle, Progress, log_fingerprint, read_log
from lanewright.services.drive import SENSORS, sensors_document
from lanewright.services.forking import write_base
from lanewright.services.ground import PLACEMENT, RASTER
from lanewright.services.id_blocks import free_range, named_ids

LIDAR_IMAGE = "lidar.png"
DRIVABLE_AREAS = "drivable_areas.json"
_MOST_MAP_BYTES = 64 * 1024 * 1024


class Outcome(StrEnum):
    IMPORTED = "imported"
    UNCHANGED = "unchanged"


@dataclass(frozen=True, slots=True)
class Placing:
    """What the caller says of where logs come from and go to; None: as the lists and the rules have it."""

    splits: SourceSplits
    source: Split | None = None
    release: Split | None = None
    direction: Direction | None = None

    def of(self, log_id: str) -> Assignment:
        """The place of one log. Raises InvalidInput when too little is said, or something contradictory."""
        listed = self.splits.by_log.get(log_id)
        if self.source is not None and listed not in (None, self.source):
            raise InvalidInput(
                f"is in the source split {listed} of the splits file, not in {self.source.value}",
                "Leave --source-split out, or correct the file.",
                Place(element=f"log {log_id}"),
            )
        splits = self.splits if self.source is None else SourceSplits(MappingProxyType({log_id: self.source}))
        return splits.assign(log_id, split=self.release, direction=self.direction)


@dataclass(frozen=True, slots=True)
class Imported:
    """What became of one log."""

    log_id: str
    outcome: Outcome
    lanes: int
    crossings: int


def find_logs(path: Path) -> Iterator[Path]:
    """The folders of logs that ``path`` names: itself, or, where it holds no map, every folder in it.

    Raises:
        InvalidInput: it is no folder, or holds no log.
    """
    place = Place(file=str(path))
    if not path.is_dir():
        raise InvalidInput("is not a folder", "Give the folder of a log, or a folder of logs.", place)
    if (path / "map").is_dir():
        yield path
        return
    found = sorted(folder for folder in path.iterdir() if folder.is_dir() and not folder.name.startswith("."))
    if not found:
        raise InvalidInput("holds no log", "Give the folder of a log, or a folder of logs.", place)
    yield from found


def import_log(
    session: Session, path: Path, placing: Placing, *, progress: Progress = lambda what, done, total: None
) -> Imported:
    """Imports one log; the same log again changes nothing.

    Raises:
        InvalidInput: something in the log, or its place, cannot be used; names file, element, key and the mend.
        Conflict: a log of that id is there with other contents or in another place.
    """
    directory = open_log(path)
    # Two imports of one log at once: the second waits, and then finds it unchanged.
    session.execute(select(func.pg_advisory_xact_lock(func.hashtextextended(directory.log_id, 0))))
    known = logs.find_log(session, directory.log_id)
    if known is not None:
        if log_fingerprint(directory) != known.content_sha256:
            map_bytes = read_bytes(directory.path(directory.map_file), most_bytes=_MOST_MAP_BYTES)
            raise _differs(known, "map" if _sha256(map_bytes) != known.map_sha256 else "sensors or calibration")
        _require_same_place(known, placing)
        return _imported(known, Outcome.UNCHANGED)
    assignment = placing.of(directory.log_id)
    return _imported(_store(session, read_log(path, progress=progress), assignment), Outcome.IMPORTED)


def _store(session: Session, bundle: LogBundle, assignment: Assignment) -> Log:
    state = bundle.map.state
    first, last = free_range({*named_ids(state), *bundle.map.drivable_areas})
    log, line = logs.insert_log(
        session,
        {
            "log_id": bundle.directory.log_id,
            "dataset": bundle.directory.layout.value,
            "city": bundle.directory.city,
            "source_split": assignment.source,
            "release_split": assignment.release.value,
            "direction": assignment.direction.value,
            "map_file_name": Path(bundle.directory.map_file).name,
            "map_document": bundle.map_bytes,
            "map_sha256": bundle.map_sha256,
            "content_sha256": bundle.fingerprint,
            "next_new_id": first,
            "last_new_id": last,
            "summary": {
                "bounds": _bounds(bundle),
                "lanes": len(state.lanes),
                "crossings": len(state.crossings),
                "sensors": dict(bundle.frames.sensors),
                "absent": list(bundle.absent),
            },
        },
    )
    write_base(session, line, log.city, state)
    for name, media_type, body, details in _assets(bundle):
        logs.insert_asset(session, log.id, name, media_type, body, details)
    return log


def _assets(bundle: LogBundle) -> Iterable[tuple[str, str, bytes, dict[str, Any]]]:
    areas = [[point[:2] for point in ring] for ring in bundle.map.drivable_areas.values()]
    yield DRIVABLE_AREAS, "application/json", orjson.dumps(areas), {}
    yield SENSORS, "application/json", orjson.dumps(sensors_document(bundle)), {}
    if bundle.lidar is not None:
        details = {
            "bounds": list(bundle.lidar.bounds),
            "metres_per_pixel": bundle.lidar.resolution,
            "sweeps": bundle.lidar.sweeps,
        }
        yield LIDAR_IMAGE, "image/png", bundle.lidar.png, details
    if bundle.ground is not None:
        yield RASTER, "application/octet-stream", bundle.ground.raster, {}
        yield PLACEMENT, "application/json", bundle.ground.placement, {}


def _bounds(bundle: LogBundle) -> list[float]:
    """Min x, min y, max x, max y of map and drive, city metres."""
    places = [point[:2] for point in bundle.trajectory]
    for lane in bundle.map.state.lanes.values():
        places += [point[:2] for line in (lane.left_boundary, lane.right_boundary) for point in line]
    for crossing in bundle.map.state.crossings.values():
        places += [point[:2] for line in (crossing.edge1, crossing.edge2) for point in line]
    xs, ys = [x for x, _ in places], [y for _, y in places]
    return [min(xs), min(ys), max(xs), max(ys)]


def _imported(log: Log, outcome: Outcome) -> Imported:
    return Imported(log.log_id, outcome, log.summary["lanes"], log.summary["crossings"])


def _require_same_place(known: Log, placing: Placing) -> None:
    """What the caller says, if anything, must be where the log is already."""
    asked = (
        ("source split", known.source_split, placing.source or placing.splits.by_log.get(known.log_id)),
        ("release split", known.release_split, placing.release),
        ("direction", known.direction, placing.direction),
    )
    for what, before, now in asked:
        if now is not None and before != now.value:
            raise Conflict(
                f"Log {known.log_id} is imported already; its {what} is {before or 'none'}, not {now.value}.",
                mend="Import it as it was before; a log keeps its place because tasks and exports rest on it.",
                code="log.placed_differently",
                log_id=known.log_id,
            )


def _differs(known: Log, part: str) -> Conflict:
    return Conflict(
        f"Log {known.log_id} is already imported, and its {part} differ{'s' if part == 'map' else ''}.",
        mend="Imported logs never change under their tasks: give the changed log a log id of its own.",
        code="log.changed",
        log_id=known.log_id,
        part=part,
    )


def _sha256(data: bytes) -> bytes:
    return hashlib.sha256(data).digest()
