"""Drafts: what one person has not saved yet in one task."""

from __future__ import annotations

from typing import Any

from sqlalchemy import delete, func, select
from sqlalchemy.dialects.postgresql import insert
from sqlalchemy.orm import Session

from lanewright.db.models import Draft
from lanewright.db.models.task import DRAFT_VERSIONS


def find(session: Session, task_id: int, account_id: int) -> Draft | None:
    """The draft, as it stands in the database now."""
    return session.execute(
        select(Draft)
        .where(Draft.task_id == task_id, Draft.account_id == account_id)
        .execution_options(populate_existing=True)
    ).scalar_one_or_none()


def keep(
    session: Session, *, task_id: int, account_id: int, base_revision: int, edits: list[Any], seen_version: int
) -> Draft | None:
    """Writes a draft over the version that its writer has seen (0: none) and returns it; None: there is a newer one."""
    written = insert(Draft).values(
        task_id=task_id,
        account_id=account_id,
        base_revision=base_revision,
        edits=edits,
        version=DRAFT_VERSIONS.next_value(),
        kept_at=func.clock_timestamp(),
    )
    upsert = written.on_conflict_do_update(
        index_elements=[Draft.task_id, Draft.account_id],
        set_={name: written.excluded[name] for name in ("base_revision", "edits", "version", "kept_at")},
        where=Draft.version == seen_version,
    ).returning(Draft)
    return session.execute(upsert, execution_options={"populate_existing": True}).scalar_one_or_none()


def drop(session: Session, task_id: int, account_id: int) -> None:
    """Removes the draft, if there is one."""
    session.execute(delete(Draft).where(Draft.task_id == task_id, Draft.account_id == account_id))
