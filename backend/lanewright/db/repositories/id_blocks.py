"""Blocks of new element ids: taken from a log's free range, never given back."""

from __future__ import annotations

from collections.abc import Iterable

from sqlalchemy import select, update
from sqlalchemy.orm import Session

from lanewright.db.models import IdBlock, Log


def advance(session: Session, log_id: int, count: int) -> int | None:
    """Takes ``count`` ids from the log's free range and returns the first; None when fewer are left.

    Locks the log's row until the transaction ends, so no two callers get the same.
    """
    after = session.execute(
        update(Log)
        .where(Log.id == log_id, Log.next_new_id + count - 1 <= Log.last_new_id)
        .values(next_new_id=Log.next_new_id + count)
        .returning(Log.next_new_id)
    ).scalar_one_or_none()
    return None if after is None else after - count


def insert_block(session: Session, *, log_id: int, task_id: int, account_id: int, first_id: int, last_id: int) -> None:
    """Notes whose block it is."""
    session.add(IdBlock(log_id=log_id, task_id=task_id, account_id=account_id, first_id=first_id, last_id=last_id))
    session.flush()


def outside_blocks(session: Session, task_id: int, account_id: int, ids: Iterable[int]) -> list[int]:
    """Those of ``ids`` that no block of this task and account holds."""
    blocks = session.execute(
        select(IdBlock.first_id, IdBlock.last_id).where(IdBlock.task_id == task_id, IdBlock.account_id == account_id)
    ).all()
    return [i for i in ids if not any(first <= i <= last for first, last in blocks)]
