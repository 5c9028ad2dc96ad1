"""SQL of task lists: filters, pages, counts per state, and the figures that a row shows."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass, field
from typing import Any

from sqlalchemy import ColumnElement, Select, String, and_, cast, exists, func, literal, or_, select
from sqlalchemy.orm import Session, aliased

from lanewright.core.changes import Category
from lanewright.core.elements import ElementKind
from lanewright.core.workflow import Action, TaskState
from lanewright.db.models import LIVE, Account, AtomicChangeRow, ElementVersion, Line, Log, Revision, Task, TaskEvent

NOBODY = 0
"""Stands for "assigned to nobody" where a filter takes an account's id."""
_Assignee = aliased(Account)


@dataclass(frozen=True, slots=True)
class TaskFilter:
    """Which tasks; None and empty mean any.

    Attributes:
        text: part of the log id or of the assignee's name, or the task's number.
        visible_to: only tasks assigned to this account.
        reviewable_by: only tasks that this account may review now: submitted or in its own review, not its own work.
    """

    text: str = ""
    visible_to: int | None = None
    assignee: int | None = None
    city: str | None = None
    split: str | None = None
    reviewable_by: int | None = None


@dataclass(slots=True)
class TaskFigures:
    """What a row of the list shows besides the task itself, at its head."""

    changes: dict[Category, int] = field(default_factory=dict)
    changed_elements: int = 0
    lanes: int = 0
    crossings: int = 0
    authors: list[Account] = field(default_factory=list)
    submitters: set[int] = field(default_factory=set)


def page_of(
    session: Session, wanted: TaskFilter, states: Collection[TaskState], sort: str, *, offset: int, limit: int
) -> tuple[Sequence[Task], int]:
    """A page of tasks and how many there are in all. ``sort``: newest, waiting (longest in its state first) or log."""
    condition = _condition(wanted)
    if states:
        condition &= Task.state.in_([state.value for state in states])
    order = {
        "newest": (Task.created_at.desc(), Task.id.desc()),
        "waiting": (Task.state_since, Task.id),
        "log": (Log.log_id, Task.id),
    }[sort]
    ids = _joined(select(Task.id)).where(condition).order_by(*order).offset(offset).limit(limit)
    found = session.scalars(ids).all()
    tasks = {task.id: task for task in session.scalars(select(Task).where(Task.id.in_(found)))}
    total = session.scalar(_joined(select(func.count())).where(condition)) or 0
    return [tasks[task_id] for task_id in found], total


def state_counts(session: Session, wanted: TaskFilter) -> dict[TaskState, int]:
    """Tasks per state; every state is there."""
    rows = session.execute(_joined(select(Task.state, func.count())).where(_condition(wanted)).group_by(Task.state))
    return dict.fromkeys(TaskState, 0) | {TaskState(state): count for state, count in rows}


def figures(session: Session, tasks: Collection[Task]) -> dict[int, TaskFigures]:
    """The figures of each task, by its id."""
    by_line = {task.line_id: TaskFigures() for task in tasks}
    by_task = {task.id: by_line[task.line_id] for task in tasks}
    _count_changes(session, by_line)
    counted = session.execute(
        select(ElementVersion.line_id, ElementVersion.kind, func.count())
        .where(ElementVersion.line_id.in_(by_line), ElementVersion.rev_to == literal(LIVE, literal_execute=True))
        .group_by(ElementVersion.line_id, ElementVersion.kind)
    )
    for line_id, kind, count in counted:
        if kind == ElementKind.LANE_SEGMENT:
            by_line[line_id].lanes = count
        else:
            by_line[line_id].crossings = count
    authored = select(Revision.line_id, Revision.author_id).where(Revision.line_id.in_(by_line)).distinct().subquery()
    authors = select(authored.c.line_id, Account).join(Account, Account.id == authored.c.author_id)
    for line_id, account in session.execute(authors.order_by(func.lower(Account.name))):
        by_line[line_id].authors.append(account)
    submitted = select(TaskEvent.task_id, TaskEvent.actor_id).where(
        TaskEvent.task_id.in_(by_task), TaskEvent.action == Action.SUBMIT.value
    )
    for task_id, actor_id in session.execute(submitted):
        by_task[task_id].submitters.add(actor_id)
    return by_task


def events(session: Session, task_id: int) -> Sequence[TaskEvent]:
    """The steps of a task with their remarks, oldest first."""
    return session.scalars(select(TaskEvent).where(TaskEvent.task_id == task_id).order_by(TaskEvent.id)).all()


def log_by_name(session: Session, log_id: str) -> Log | None:
    return session.scalar(select(Log).where(Log.log_id == log_id))


def known_elements(session: Session, line_id: int, ids: Collection[int]) -> set[tuple[str, int]]:
    """Which (kind, id) of these ids ever were on the line."""
    rows = session.execute(
        select(ElementVersion.kind, ElementVersion.element_id)
        .where(ElementVersion.line_id == line_id, ElementVersion.element_id.in_(ids))
        .distinct()
    )
    return set(rows)


def _count_changes(session: Session, by_line: dict[int, TaskFigures]) -> None:
    row = AtomicChangeRow
    at_head = and_(row.line_id == Line.id, row.revision == Line.head)
    counted = session.execute(
        select(row.line_id, row.category, func.count())
        .join(Line, at_head)
        .where(Line.id.in_(by_line))
        .group_by(row.line_id, row.category)
        .order_by(row.line_id, row.category)
    )
    for line_id, category, count in counted:
        by_line[line_id].changes[Category(category)] = count
    # An element with connectivity alone does not count as changed (change mapping, §3).
    distinct = (
        select(row.line_id, row.kind, row.element_id)
        .join(Line, at_head)
        .where(Line.id.in_(by_line), row.category != Category.CONNECTIVITY.value)
        .distinct()
        .subquery()
    )
    elements = session.execute(select(distinct.c.line_id, func.count()).group_by(distinct.c.line_id))
    for line_id, count in elements:
        by_line[line_id].changed_elements = count


def _joined(query: Select[*tuple[Any, ...]]) -> Select[*tuple[Any, ...]]:
    return (
        query.select_from(Task).join(Log, Log.id == Task.log_id).outerjoin(_Assignee, _Assignee.id == Task.assignee_id)
    )


def _condition(wanted: TaskFilter) -> ColumnElement[bool]:
    conditions: list[ColumnElement[bool]] = [Task.id > 0]
    if wanted.text:
        conditions.append(
            or_(
                Log.log_id.icontains(wanted.text, autoescape=True),
                _Assignee.name.icontains(wanted.text, autoescape=True),
                cast(Task.id, String) == wanted.text,
            )
        )
    if wanted.visible_to is not None:
        conditions.append(Task.assignee_id == wanted.visible_to)
    if wanted.assignee is not None:
        conditions.append(
            Task.assignee_id.is_(None) if wanted.assignee == NOBODY else Task.assignee_id == wanted.assignee
        )
    if wanted.city:
        conditions.append(Log.city == wanted.city)
    if wanted.split:
        conditions.append(Log.release_split == wanted.split)
    if wanted.reviewable_by is not None:
        conditions.append(_reviewable(wanted.reviewable_by))
    return and_(*conditions)


def _reviewable(account_id: int) -> ColumnElement[bool]:
    saved = exists().where(Revision.line_id == Task.line_id, Revision.author_id == account_id)
    submitted = exists().where(
        TaskEvent.task_id == Task.id, TaskEvent.actor_id == account_id, TaskEvent.action == Action.SUBMIT.value
    )
    waiting = or_(
        Task.state == TaskState.SUBMITTED.value,
        and_(Task.state == TaskState.IN_REVIEW.value, Task.reviewer_id == account_id),
    )
    return and_(waiting, ~saved, ~submitted)
