"""Imported logs as people see them: the list for reviewers, the lidar image for whoever works on one."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from sqlalchemy.orm import Session

from lanewright.core.errors import NotFound
from lanewright.db.repositories import logs
from lanewright.services.actor import Actor
from lanewright.services.importing import LIDAR_IMAGE


@dataclass(frozen=True, slots=True)
class KeptImage:
    """An image that is in the store, not loaded yet; its hash names its contents for good."""

    log_row_id: int
    sha256: bytes

    def load(self, session: Session) -> bytes:
        """The PNG."""
        return logs.asset_body(session, self.log_row_id, LIDAR_IMAGE)


def listing(
    session: Session, *, text: str, city: str | None, split: str | None, page: int, page_size: int
) -> tuple[list[dict[str, Any]], int]:
    """A page of logs by id as the JSON of ``LogOut``, and how many there are in all."""
    found, total = logs.find_logs(
        session, text=text, city=city, split=split, offset=(page - 1) * page_size, limit=page_size
    )
    return [_document(listed) for listed in found], total


def lidar_image(session: Session, actor: Actor, log_id: str) -> KeptImage:
    """The lidar image of a log.

    Raises:
        NotFound: no such log, it has none, or the actor has no task on it and does not review.
    """
    log = logs.find_log(session, log_id) if actor.reviews else logs.find_log_of_assignee(session, log_id, actor.id)
    sha256 = None if log is None else logs.asset_hashes(session, log.id).get(LIDAR_IMAGE)
    if log is None or sha256 is None:
        raise NotFound(
            "There is no lidar image of this log.",
            mend="The map can be edited without it; see absent in the list of logs.",
            code="lidar.not_found",
        )
    return KeptImage(log.id, sha256)


def _document(listed: logs.ListedLog) -> dict[str, Any]:
    log, summary = listed.log, listed.log.summary
    return {
        "log_id": log.log_id,
        "dataset": log.dataset,
        "city": log.city,
        "source_split": log.source_split,
        "release_split": log.release_split,
        "direction": log.direction,
        "imported_at": log.imported_at,
        "tasks": listed.tasks,
        **{name: summary[name] for name in ("lanes", "crossings", "sensors", "absent")},
    }
