"""Tasks: who edits which log in which direction, their drafts, their steps and the remarks of reviewers."""

from __future__ import annotations

from typing import Any

from sqlalchemy import BigInteger, CheckConstraint, ForeignKey, Index, Integer, Sequence, Text, UniqueConstraint, text
from sqlalchemy.orm import Mapped, mapped_column, relationship

from lanewright.db.models.account import Account
from lanewright.db.models.base import Base, created, identity, moment
from lanewright.db.models.line import Line
from lanewright.db.models.log import Log

DRAFT_VERSIONS = Sequence("draft_version", metadata=Base.metadata)


class Task(Base):
    """Log + direction + assignee + state; owns one line of revisions."""

    __tablename__ = "task"

    id: Mapped[identity]
    log_id: Mapped[int] = mapped_column(ForeignKey("log.id", ondelete="CASCADE"), index=True)
    line_id: Mapped[int] = mapped_column(ForeignKey("line.id"), unique=True)
    direction: Mapped[str] = mapped_column(Text)
    assignee_id: Mapped[int | None] = mapped_column(ForeignKey("account.id"), index=True)
    reviewer_id: Mapped[int | None] = mapped_column(ForeignKey("account.id"))
    """Who reviews it now, or accepted it."""
    state: Mapped[str] = mapped_column(Text)
    state_since: Mapped[created]
    accepted_revision: Mapped[int | None] = mapped_column(Integer)
    """The revision that is exported; set by accept, cleared by reopen."""
    created_at: Mapped[created]

    log: Mapped[Log] = relationship(lazy="joined", innerjoin=True)
    line: Mapped[Line] = relationship(lazy="joined", innerjoin=True)
    assignee: Mapped[Account | None] = relationship(lazy="joined", foreign_keys=[assignee_id])
    reviewer: Mapped[Account | None] = relationship(lazy="joined", foreign_keys=[reviewer_id])

    __table_args__ = (
        Index("ix_task_state_state_since", "state", "state_since"),
        CheckConstraint("state IN ('draft', 'submitted', 'in_review', 'changes_requested', 'accepted')", name="state"),
        CheckConstraint("direction IN ('prior_to_current', 'current_to_prior')", name="direction"),
    )


class IdBlock(Base):
    """A run of new element ids handed to one open workspace of a task; never handed out twice in a log."""

    __tablename__ = "id_block"

    id: Mapped[identity]
    log_id: Mapped[int] = mapped_column(ForeignKey("log.id", ondelete="CASCADE"))
    task_id: Mapped[int] = mapped_column(ForeignKey("task.id", ondelete="CASCADE"), index=True)
    account_id: Mapped[int] = mapped_column(ForeignKey("account.id"))
    first_id: Mapped[int] = mapped_column(BigInteger)
    last_id: Mapped[int] = mapped_column(BigInteger)
    created_at: Mapped[created]

    __table_args__ = (
        CheckConstraint("first_id <= last_id AND last_id <= 2147483647", name="range"),
        UniqueConstraint("log_id", "first_id"),
    )


class Draft(Base):
    """What one person has not saved yet in one task: the net edits since ``base_revision``, and all declarations."""

    __tablename__ = "draft"

    task_id: Mapped[int] = mapped_column(ForeignKey("task.id", ondelete="CASCADE"), primary_key=True)
    account_id: Mapped[int] = mapped_column(ForeignKey("account.id", ondelete="CASCADE"), primary_key=True)
    base_revision: Mapped[int] = mapped_column(Integer)
    edits: Mapped[list[Any]]
    declarations: Mapped[list[Any]] = mapped_column(server_default=text("'[]'"))
    version: Mapped[int] = mapped_column(Integer, DRAFT_VERSIONS)
    """Names this write, never given twice; a writer names the one it has seen, so two devices cannot overwrite each
    other unseen, not even across a draft that was dropped in between."""
    kept_at: Mapped[moment]
    saved_as: Mapped[int | None] = mapped_column(Integer)
    """The revision that the draft became. All else in the row is then void; it stays to turn away writes of the draft
    that arrive after its save."""


class TaskEvent(Base):
    """One step of a task through its states; append-only."""

    __tablename__ = "task_event"

    id: Mapped[identity]
    task_id: Mapped[int] = mapped_column(ForeignKey("task.id", ondelete="CASCADE"), index=True)
    actor_id: Mapped[int] = mapped_column(ForeignKey("account.id"))
    action: Mapped[str] = mapped_column(Text)
    from_state: Mapped[str | None] = mapped_column(Text)
    to_state: Mapped[str] = mapped_column(Text)
    revision: Mapped[int] = mapped_column(Integer)
    reason: Mapped[str] = mapped_column(Text, default="")
    at: Mapped[created]

    actor: Mapped[Account] = relationship(lazy="joined", innerjoin=True)
    remarks: Mapped[list[Remark]] = relationship(lazy="selectin", order_by="Remark.id")


class Remark(Base):
    """A reviewer's reason at one element, given with a step; shown beside the element."""

    __tablename__ = "remark"

    id: Mapped[identity]
    event_id: Mapped[int] = mapped_column(ForeignKey("task_event.id", ondelete="CASCADE"), index=True)
    kind: Mapped[str] = mapped_column(Text)
    element_id: Mapped[int] = mapped_column(BigInteger)
    text: Mapped[str] = mapped_column(Text)
