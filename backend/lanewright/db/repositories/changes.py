"""The derived atomic changes: written beside their revision, read by the change query and by ``verify``."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from sqlalchemy import ColumnElement, func, insert, join, select
from sqlalchemy.orm import Session

from lanewright.core.changes import AtomicChange
from lanewright.db.models import AtomicChangeRow, Line, Log, Task


@dataclass(frozen=True, slots=True)
class FoundChange:
    """One category on one element at a task's revision."""

    log_id: str
    city: str
    release_split: str
    task_id: int
    revision: int
    kind: str
    element_id: int
    category: str
    leaves: list[str]


@dataclass(frozen=True, slots=True, order=True)
class StoredChange:
    """A row without its revision, comparable."""

    kind: str
    element_id: int
    category: str
    leaves: tuple[str, ...]


def rows_of(changes: Iterable[AtomicChange]) -> list[StoredChange]:
    """A row per category, with the leaves that refine it, in the order of the primary key."""
    return sorted(
        StoredChange(
            change.kind.value,
            change.id,
            category.value,
            tuple(leaf for leaf in change.leaves if leaf.split(".", 1)[0] == category.value),
        )
        for change in changes
        for category in change.categories
    )


def insert_changes(session: Session, line_id: int, revision: int, changes: Sequence[AtomicChange]) -> None:
    """Writes the changes base -> revision."""
    rows = [
        {
            "line_id": line_id,
            "revision": revision,
            "kind": row.kind,
            "element_id": row.element_id,
            "category": row.category,
            "leaves": list(row.leaves),
        }
        for row in rows_of(changes)
    ]
    if rows:
        session.execute(insert(AtomicChangeRow), rows)


def load_changes(session: Session, line_id: int, revision: int) -> list[StoredChange]:
    """The stored changes of a revision, in the order of ``rows_of``."""
    row = AtomicChangeRow
    found = session.execute(
        select(row.kind, row.element_id, row.category, row.leaves).where(
            row.line_id == line_id, row.revision == revision
        )
    )
    return sorted(StoredChange(kind, i, category, tuple(leaves)) for kind, i, category, leaves in found)


def find_changes(
    session: Session,
    *,
    category: str | None,
    city: str | None,
    split: str | None,
    accepted: bool,
    offset: int,
    limit: int,
) -> tuple[list[FoundChange], int]:
    """A page of the changes of all tasks, and how many there are in all.

    ``accepted``: at the accepted revision of accepted tasks; otherwise at every task's head.
    """
    row = AtomicChangeRow
    revision = Task.accepted_revision if accepted else Line.head
    conditions: list[ColumnElement[bool]] = [row.revision == revision]
    conditions += [Task.state == "accepted"] if accepted else []
    conditions += [row.category == category] if category else []
    conditions += [Log.city == city] if city else []
    conditions += [Log.release_split == split] if split else []
    tables = (
        join(Task, Line, Line.id == Task.line_id)
        .join(Log, Log.id == Task.log_id)
        .join(AtomicChangeRow, row.line_id == Line.id)
    )
    found = session.execute(
        select(
            Log.log_id,
            Log.city,
            Log.release_split,
            Task.id,
            row.revision,
            row.kind,
            row.element_id,
            row.category,
            row.leaves,
        )
        .select_from(tables)
        .where(*conditions)
        .order_by(Log.log_id, Task.id, row.kind, row.element_id, row.category)
        .offset(offset)
        .limit(limit)
    )
    total = session.execute(select(func.count()).select_from(tables).where(*conditions)).scalar_one()
    return [FoundChange(*each) for each in found], total
