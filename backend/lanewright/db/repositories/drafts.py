"""Drafts: what one person has not saved yet in one task."""

from __future__ import annotations

from typing import Any

from sqlalchemy import and_, delete, func, or_, select
from sqlalchemy.dialects.postgresql import insert
from sqlalchemy.orm import Session

from lanewright.db.models import Draft
from lanewright.db.models.task import DRAFT_VERSIONS


def find(session: Session, task_id: int, account_id: int) -> Draft | None:
    """The draft, as it stands in the database now."""
    return _find(session, task_id, account_id, saved=False)


def find_settled(session: Session, task_id: int, account_id: int) -> Draft | None:
    """What the last save left of the draft, if there is no new one."""
    return _find(session, task_id, account_id, saved=True)


def _find(session: Session, task_id: int, account_id: int, *, saved: bool) -> Draft | None:
    return session.execute(
        select(Draft)
        .where(
            Draft.task_id == task_id,
            Draft.account_id == account_id,
            Draft.saved_as.is_not(None) if saved else Draft.saved_as.is_(None),
        )
        .execution_options(populate_existing=True)
    ).scalar_one_or_none()


def keep(
    session: Session,
    *,
    task_id: int,
    account_id: int,
    base_revision: int,
    edits: list[Any],
    declarations: list[Any],
    seen_version: int,
) -> Draft | None:
    """Writes a draft over the version that its writer has seen (0: none) and returns it.

    None: there is a newer one, or a save since the base revision. To a draft begun after that save its mark is nothing.
    """
    written = insert(Draft).values(
        task_id=task_id,
        account_id=account_id,
        base_revision=base_revision,
        edits=edits,
        declarations=declarations,
        version=DRAFT_VERSIONS.next_value(),
        kept_at=func.clock_timestamp(),
        saved_as=None,
    )
    columns = ("base_revision", "edits", "declarations", "version", "kept_at", "saved_as")
    upsert = written.on_conflict_do_update(
        index_elements=[Draft.task_id, Draft.account_id],
        set_={name: written.excluded[name] for name in columns},
        where=or_(
            Draft.version == seen_version,
            and_(Draft.saved_as.is_not(None), Draft.saved_as <= base_revision),
        ),
    ).returning(Draft)
    return session.execute(upsert, execution_options={"populate_existing": True}).scalar_one_or_none()


def settle(session: Session, task_id: int, account_id: int, revision: int) -> None:
    """The draft became a revision: all that stays is a mark that turns away writes of it which arrive later."""
    mark = insert(Draft).values(
        task_id=task_id,
        account_id=account_id,
        base_revision=revision,
        edits=[],
        declarations=[],
        version=DRAFT_VERSIONS.next_value(),
        kept_at=func.clock_timestamp(),
        saved_as=revision,
    )
    columns = ("base_revision", "edits", "declarations", "version", "kept_at", "saved_as")
    session.execute(
        mark.on_conflict_do_update(
            index_elements=[Draft.task_id, Draft.account_id], set_={name: mark.excluded[name] for name in columns}
        )
    )


def drop(session: Session, task_id: int, account_id: int) -> None:
    """Removes the draft, if there is one."""
    session.execute(
        delete(Draft).where(Draft.task_id == task_id, Draft.account_id == account_id, Draft.saved_as.is_(None))
    )
