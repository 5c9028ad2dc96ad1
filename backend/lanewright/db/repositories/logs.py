"""Imported logs and the files kept for them."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass
from typing import Any

from sqlalchemy import ColumnElement, exists, func, insert, select
from sqlalchemy.orm import Session

from lanewright.db.models import Line, Log, LogAsset, Task


@dataclass(frozen=True, slots=True)
class ListedLog:
    """A log, and how many tasks work on it."""

    log: Log
    tasks: int


def find_log(session: Session, log_id: str) -> Log | None:
    """The log by its id in the dataset."""
    return session.execute(select(Log).where(Log.log_id == log_id)).scalar_one_or_none()


def find_log_of_assignee(session: Session, log_id: str, account_id: int) -> Log | None:
    """The log by its id, if a task on it is assigned to this account."""
    assigned = exists().where(Task.log_id == Log.id, Task.assignee_id == account_id)
    return session.execute(select(Log).where(Log.log_id == log_id, assigned)).scalar_one_or_none()


def find_logs(
    session: Session, *, text: str, city: str | None, split: str | None, offset: int, limit: int
) -> tuple[list[ListedLog], int]:
    """A page of logs by id, and how many there are in all; ``text`` is a part of the id, whatever its case."""
    conditions: list[ColumnElement[bool]] = []
    conditions += [Log.log_id.icontains(text, autoescape=True)] if text else []
    conditions += [Log.city == city] if city else []
    conditions += [Log.release_split == split] if split else []
    tasks = select(func.count(Task.id)).where(Task.log_id == Log.id).scalar_subquery()
    rows = session.execute(select(Log, tasks).where(*conditions).order_by(Log.log_id).offset(offset).limit(limit))
    total = session.execute(select(func.count(Log.id)).where(*conditions)).scalar_one()
    return [ListedLog(log, count) for log, count in rows], total


def insert_log(session: Session, values: dict[str, Any]) -> tuple[Log, Line]:
    """A log and its base line, which name each other."""
    # The reference line -> log is checked only when the transaction ends, so the line can go first.
    line = Line(log_id=0, head=0)
    session.add(line)
    session.flush()
    log = Log(line_id=line.id, **values)
    session.add(log)
    session.flush()
    line.log_id = log.id
    session.flush()
    return log, line


def insert_asset(
    session: Session, log_row_id: int, name: str, media_type: str, body: bytes, details: dict[str, Any]
) -> None:
    """Keeps a file for a log."""
    sha256 = hashlib.sha256(body).digest()
    session.execute(
        insert(LogAsset).values(
            log_id=log_row_id, name=name, media_type=media_type, body=body, sha256=sha256, details=details
        )
    )


def asset_hashes(session: Session, log_row_id: int) -> dict[str, bytes]:
    """SHA-256 of every file kept for a log, by name."""
    rows = session.execute(select(LogAsset.name, LogAsset.sha256).where(LogAsset.log_id == log_row_id))
    return {name: bytes(sha256) for name, sha256 in rows}


def asset_details(session: Session, log_row_id: int, name: str) -> dict[str, Any] | None:
    """What is known of a kept file besides its contents; None when there is none of that name."""
    return session.execute(
        select(LogAsset.details).where(LogAsset.log_id == log_row_id, LogAsset.name == name)
    ).scalar_one_or_none()


def asset_body(session: Session, log_row_id: int, name: str) -> bytes:
    """The contents of a kept file, which must be there."""
    body = session.execute(
        select(LogAsset.body).where(LogAsset.log_id == log_row_id, LogAsset.name == name)
    ).scalar_one()
    return bytes(body)
