"""Lines and their revisions: the writers' lock, the changesets, and the answers that replays get again."""

from __future__ import annotations

import datetime
import uuid
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from sqlalchemy import func, insert, select, union_all, update
from sqlalchemy.orm import Session

from lanewright.core.errors import Conflict
from lanewright.db.models import LIVE, Account, ElementVersion, Line, Revision


@dataclass(frozen=True, slots=True)
class StoredAnswer:
    """What a changeset was answered, and the hash of the body that it answers."""

    body_sha256: bytes
    answer: bytes


@dataclass(frozen=True, slots=True)
class HistoryEntry:
    """One revision as the history shows it; ``changed_elements`` counts what this changeset wrote or removed."""

    number: int
    author_id: int | None
    author_name: str | None
    created_at: datetime.datetime
    note: str
    changed_elements: int


def new_line(session: Session, log_id: int) -> Line:
    """A line without any revision yet."""
    line = Line(log_id=log_id, head=0)
    session.add(line)
    session.flush()
    return line


def advance_head(session: Session, line_id: int, head: int) -> int:
    """Moves the head of a line from ``head`` to the next number. Whoever does it holds the writers' lock.

    Raises:
        Conflict: the head is not ``head`` any more.
    """
    advanced = session.execute(
        update(Line).where(Line.id == line_id, Line.head == head).values(head=Line.head + 1).returning(Line.head)
    ).scalar_one_or_none()
    if advanced is None:
        raise Conflict("The task changed while it was being saved.", mend="Save again.", code="save.collision")
    return advanced


def now(session: Session) -> datetime.datetime:
    """The database's time of this transaction: what all its rows are stamped with."""
    return session.execute(select(func.now())).scalar_one()


def insert_revision(
    session: Session,
    *,
    line_id: int,
    number: int,
    content_sha256: bytes,
    updates: list[Any],
    author_id: int | None = None,
    note: str = "",
    changeset_uuid: uuid.UUID | None = None,
    body_sha256: bytes | None = None,
    answer: bytes | None = None,
    declarations: Sequence[Any] = (),
) -> None:
    """Writes one revision; its element versions and atomic changes follow."""
    session.execute(
        insert(Revision).values(
            line_id=line_id,
            number=number,
            author_id=author_id,
            note=note,
            changeset_uuid=changeset_uuid,
            body_sha256=body_sha256,
            answer=answer,
            content_sha256=content_sha256,
            updates=updates,
            declarations=list(declarations),
        )
    )


def find_answer(session: Session, line_id: int, author_id: int, changeset_uuid: uuid.UUID) -> StoredAnswer | None:
    """The answer that this author's changeset got, if it was saved before."""
    row = session.execute(
        select(Revision.body_sha256, Revision.answer).where(
            Revision.line_id == line_id,
            Revision.author_id == author_id,
            Revision.changeset_uuid == changeset_uuid,
        )
    ).one_or_none()
    if row is None or row.body_sha256 is None or row.answer is None:
        return None
    return StoredAnswer(bytes(row.body_sha256), bytes(row.answer))


def content_sha256(session: Session, line_id: int, number: int) -> bytes | None:
    """The content hash of a revision; None: there is no such revision."""
    found = session.execute(
        select(Revision.content_sha256).where(Revision.line_id == line_id, Revision.number == number)
    ).scalar_one_or_none()
    return None if found is None else bytes(found)


def declarations(session: Session, line_id: int, number: int) -> list[Any]:
    """The macros declared at a revision, as JSON; none where there is no such revision."""
    found: list[Any] | None = session.execute(
        select(Revision.declarations).where(Revision.line_id == line_id, Revision.number == number)
    ).scalar_one_or_none()
    return found or []


@dataclass(frozen=True, slots=True)
class StoredRevision:
    """What is derived of a revision and stored with it."""

    number: int
    content_sha256: bytes
    updates: list[Any]


def load_derived(session: Session, line_id: int) -> list[StoredRevision]:
    """The derived values of all revisions of a line, oldest first."""
    rows = session.execute(
        select(Revision.number, Revision.content_sha256, Revision.updates)
        .where(Revision.line_id == line_id)
        .order_by(Revision.number)
    )
    return [StoredRevision(number, bytes(sha256), updates) for number, sha256, updates in rows]


def history(session: Session, line_id: int) -> list[HistoryEntry]:
    """All revisions of a line, oldest first."""
    version = ElementVersion
    own = version.line_id == line_id
    touched = union_all(
        select(version.rev_from.label("number"), version.kind, version.element_id).where(own, version.rev_from > 0),
        select(version.rev_to, version.kind, version.element_id).where(own, version.rev_to < LIVE),
    ).subquery()
    distinct = select(touched.c.number, touched.c.kind, touched.c.element_id).distinct().subquery()
    counts = select(distinct.c.number, func.count().label("elements")).group_by(distinct.c.number).subquery()
    rows = session.execute(
        select(
            Revision.number,
            Revision.author_id,
            Account.name,
            Revision.created_at,
            Revision.note,
            func.coalesce(counts.c.elements, 0),
        )
        .outerjoin(Account, Account.id == Revision.author_id)
        .outerjoin(counts, counts.c.number == Revision.number)
        .where(Revision.line_id == line_id)
        .order_by(Revision.number)
    )
    return [HistoryEntry(*row) for row in rows]
