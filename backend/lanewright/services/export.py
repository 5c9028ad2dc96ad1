"""The dataset as a tar archive: for every released log its prior and its current map, the changes, the sensors.

Layout, in this order: for each log, by log id, ``prior/<log_id>/map/…`` and ``current/<log_id>/map/…`` (each a folder
that ``ArgoverseStaticMap.from_map_dir`` loads), ``changes/<log_id>.json`` (change mapping §8, prior → current) and
``sensors/<log_id>.json``; ``manifest.json`` comes last, because it holds the hash of every file before it.
"""

from __future__ import annotations

import datetime
from collections.abc import Callable, Generator, Iterator
from contextlib import AbstractContextManager
from dataclasses import asdict
from typing import Any

import orjson
from sqlalchemy.orm import Session

from lanewright import __version__
from lanewright.core.changes import Direction
from lanewright.core.comparison import Comparison
from lanewright.core.diff import diff_of, invert
from lanewright.core.errors import NotFound
from lanewright.core.report import diff_document
from lanewright.db.models import Log
from lanewright.db.repositories import elements, logs, releases, revisions
from lanewright.db.repositories.releases import Release
from lanewright.formats.av2_map import parse_map
from lanewright.formats.splits import Split
from lanewright.formats.tar_stream import TarStream
from lanewright.services.drive import SENSORS
from lanewright.services.ground import PLACEMENT, RASTER

SCHEMA_VERSION = 1
"""Of the archive's layout and its manifest."""
MANIFEST = "manifest.json"
OpenSnapshot = Callable[[], AbstractContextManager[Session]]


def split_named(name: str) -> Split:
    """The split of that name.

    Raises:
        NotFound: there is no such split.
    """
    try:
        return Split(name)
    except ValueError:
        raise NotFound(
            f"There is no split {name[:40]!r}.", mend="Choose train, val or test.", code="split.not_found"
        ) from None


def archive(open_snapshot: OpenSnapshot, split: Split) -> Generator[bytes]:
    """The bytes of the archive, piece by piece; one log is in memory at a time.

    All of it shows one state of the database; closing the generator lets go of it. A split without accepted tasks gives
    an archive of the manifest alone.
    """
    stream = TarStream()
    with open_snapshot() as session:
        created_at = revisions.now(session)
        entries: list[dict[str, Any]] = []
        for release in releases.releases_of(session, split.value):
            log = session.get_one(Log, release.log_row_id)
            yield from _log_files(session, stream, log, release)
            entries.append(_entry(log, release, stream))
            session.expunge_all()
        manifest = {
            "schema_version": SCHEMA_VERSION,
            "generator": f"lanewright {__version__}",
            "split": split.value,
            "created_at": created_at.astimezone(datetime.UTC).isoformat(),
            "logs": entries,
        }
        yield stream.add(MANIFEST, _json(manifest), created_at)
    yield stream.close()


def _log_files(session: Session, stream: TarStream, log: Log, release: Release) -> Iterator[bytes]:
    base = parse_map(bytes(log.map_document), log.map_file_name)
    edited = elements.load(session, release.line_id, release.revision).state
    kept = logs.asset_hashes(session, log.id)
    ground = {
        _ground_file_names(log)[name]: logs.asset_body(session, log.id, name)
        for name in (RASTER, PLACEMENT)
        if name in kept
    }
    # The same objects where the revision records no cuts: then the base is the file as imported, to the byte.
    compared = Comparison(base.state, edited)
    made = diff_of(compared)
    forward = release.direction == Direction.PRIOR_TO_CURRENT
    before, after = base.render(compared.base), base.render(compared.edited)
    sides = {"prior": before if forward else after, "current": after if forward else before}
    for side, text in sides.items():
        folder = f"{side}/{log.log_id}/map"
        yield stream.add(f"{folder}/{log.map_file_name}", text, release.accepted_at)
        for name, body in ground.items():
            yield stream.add(f"{folder}/{name}", body, release.accepted_at)
    changes = diff_document(made if forward else invert(made))
    yield stream.add(f"changes/{log.log_id}.json", _json(changes), release.accepted_at)
    if SENSORS in kept:
        sensors = logs.asset_body(session, log.id, SENSORS)
        yield stream.add(f"sensors/{log.log_id}.json", sensors, release.accepted_at)


def _entry(log: Log, release: Release, stream: TarStream) -> dict[str, Any]:
    return {
        "log_id": log.log_id,
        "dataset": log.dataset,
        "city": log.city,
        "source_split": log.source_split,
        "task": release.task_id,
        "revision": release.revision,
        "direction": release.direction,
        "accepted_at": release.accepted_at.astimezone(datetime.UTC).isoformat(),
        "files": [asdict(member) for member in stream.take_members()],
    }


def _ground_file_names(log: Log) -> dict[str, str]:
    """As the logs of the dataset name them: av2 finds them by these names."""
    return {
        RASTER: f"{log.log_id}_ground_height_surface____{log.city}.npy",
        PLACEMENT: f"{log.log_id}___img_Sim2_city.json",
    }


def _json(value: Any) -> bytes:
    return orjson.dumps(value, option=orjson.OPT_INDENT_2)
