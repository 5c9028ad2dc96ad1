"""What of a split is released: the task that speaks for each log."""

from __future__ import annotations

import datetime
from collections.abc import Sequence
from dataclasses import dataclass

from sqlalchemy import select
from sqlalchemy.dialects.postgresql import distinct_on
from sqlalchemy.orm import Session

from lanewright.db.models import Log, Task


@dataclass(frozen=True, slots=True)
class Release:
    """An accepted task whose revision stands for its log."""

    log_row_id: int
    task_id: int
    line_id: int
    revision: int
    direction: str
    accepted_at: datetime.datetime


def releases_of(session: Session, split: str) -> Sequence[Release]:
    """One per log of the split that has accepted tasks, by log id; of several accepted tasks the one accepted last."""
    rows = session.execute(
        select(Log.id, Task.id, Task.line_id, Task.accepted_revision, Task.direction, Task.state_since)
        .join(Task, Task.log_id == Log.id)
        .where(Log.release_split == split, Task.accepted_revision.is_not(None))
        .ext(distinct_on(Log.log_id))
        .order_by(Log.log_id, Task.state_since.desc(), Task.id.desc())
    )
    return [
        Release(log_row_id, task_id, line_id, revision, direction, accepted_at)
        for log_row_id, task_id, line_id, revision, direction, accepted_at in rows
        if revision is not None
    ]
