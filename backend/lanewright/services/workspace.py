"""What the editor opens: base map, what a revision changed, and the pictures and frame to draw them in."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import orjson
from sqlalchemy.orm import Session

from lanewright.core.claims import Claims
from lanewright.db.models import Draft, Task
from lanewright.db.repositories import drafts, logs, revisions
from lanewright.db.repositories.elements import StoredMap
from lanewright.sensors.city import city_frame
from lanewright.services import line_maps
from lanewright.services.access import readable_task
from lanewright.services.actor import Actor
from lanewright.services.declarations import declared_at
from lanewright.services.element_documents import key_documents, map_document
from lanewright.services.findings import Findings
from lanewright.services.importing import DRIVABLE_AREAS, LIDAR_IMAGE
from lanewright.services.recently_used import RecentlyUsed

BASE_DOCUMENTS: RecentlyUsed[bytes] = RecentlyUsed(most=64)
"""JSON of whole base maps by their content hash: it never changes, and is most of what opening a task sends."""


@dataclass(frozen=True, slots=True)
class OpenedTask:
    """A task at one revision. ``parts``: the JSON of the members of ``Workspace`` that come from the store."""

    task: Task
    revision: int
    parts: dict[str, Any]
    draft: Draft | None


def open_task(session: Session, actor: Actor, task_id: int, revision: int | None = None) -> OpenedTask:
    """A task for the editor, at its head unless a revision is named.

    Raises:
        NotFound: no such task for this actor, or no such revision.
    """
    task = readable_task(session, actor, task_id)
    head = task.line.head
    shown = head if revision is None else revision
    sha256, base = line_maps.base_map_with_hash(session, task.line_id)
    departure = line_maps.departure(session, task.line_id, shown, head)
    frame = city_frame(task.log.city)
    parts = {
        "revision": shown,
        "frame": {
            "city": frame.city,
            "epsg": frame.epsg,
            "origin_east": frame.origin_east,
            "origin_north": frame.origin_north,
        },
        "bounds": task.log.summary["bounds"],
        "base": orjson.Fragment(_base_document(sha256, base)),
        "changed": map_document(departure.written.state, departure.written.versions),
        "removed": key_documents(departure.removed),
        "declarations": revisions.declarations(session, task.line_id, shown),
        "drivable_areas": orjson.Fragment(logs.asset_body(session, task.log_id, DRIVABLE_AREAS)),
        "lidar": _lidar(session, task),
        "revisions": [_history_document(entry) for entry in revisions.history(session, task.line_id)],
    }
    return OpenedTask(task, shown, parts, drafts.find(session, task.id, actor.id))


def findings_at(session: Session, actor: Actor, task_id: int, revision: int) -> dict[str, Any]:
    """Changes and violations base -> revision, as the JSON of ``Findings``.

    Raises:
        NotFound: no such task for this actor, or no such revision.
    """
    task = readable_task(session, actor, task_id)
    base = line_maps.base_map(session, task.line_id)
    edited = line_maps.departure(session, task.line_id, revision, task.line.head).applied_to(base)
    claims = Claims(declared=declared_at(session, task.line_id, revision))
    return Findings(base.state, edited.state, task.direction, claims).document()


def _base_document(sha256: bytes, base: StoredMap) -> bytes:
    known = BASE_DOCUMENTS.get(sha256)
    if known is None:
        known = orjson.dumps(map_document(base.state, base.versions))
        BASE_DOCUMENTS.put(sha256, known)
    return known


def _lidar(session: Session, task: Task) -> dict[str, Any] | None:
    details = logs.asset_details(session, task.log_id, LIDAR_IMAGE)
    if details is None:
        return None
    return {
        "url": f"/api/v1/logs/{task.log.log_id}/{LIDAR_IMAGE}",
        "bounds": details["bounds"],
        "metres_per_pixel": details["metres_per_pixel"],
    }


def _history_document(entry: revisions.HistoryEntry) -> dict[str, Any]:
    author = None if entry.author_id is None else {"id": entry.author_id, "name": entry.author_name}
    return {
        "number": entry.number,
        "author": author,
        "created_at": entry.created_at,
        "note": entry.note,
        "changed_elements": entry.changed_elements,
    }
