"""A task as it stands now, alone or locked against every other save and step."""

from __future__ import annotations

from sqlalchemy import select
from sqlalchemy.orm import Session

from lanewright.db.models import Task


def find_task(session: Session, task_id: int, *, lock: bool = False) -> Task | None:
    """The task with its log, line and people; ``lock``: nobody else saves or moves it until the transaction ends."""
    if lock:
        # On its own: after waiting, a join would still show the line's head from before the wait.
        # Not against new rows that only name the task: a draft that is being kept would wait, and the save for it.
        lockable = select(Task.id).where(Task.id == task_id).with_for_update(key_share=True)
        locked = session.execute(lockable).scalar_one_or_none()
        if locked is None:
            return None
    query = select(Task).where(Task.id == task_id).execution_options(populate_existing=True)
    return session.execute(query).scalar_one_or_none()
