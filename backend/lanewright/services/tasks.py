"""Tasks: lists of them, one of them with what the asker may do, creating and assigning."""

from __future__ import annotations

import datetime
from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace

from sqlalchemy.orm import Session

from lanewright.core.changes import Category, Direction
from lanewright.core.errors import Conflict, InvalidInput, NotFound, Place
from lanewright.core.workflow import EDITABLE_STATES, Action, Role, Standing, TaskState, allowed_actions
from lanewright.db.models import Account, Log, Task, TaskEvent
from lanewright.db.repositories import accounts, revisions, tasks
from lanewright.db.repositories.tasks import TaskFigures, TaskFilter
from lanewright.services.access import readable_task
from lanewright.services.actor import Actor
from lanewright.services.forking import fork


@dataclass(frozen=True, slots=True)
class TaskView:
    """A task as one person sees it: its log, its figures at the head, and what they may do now."""

    id: int
    log_id: str
    city: str
    source_split: str | None
    release_split: str
    direction: Direction
    state: TaskState
    state_since: datetime.datetime
    assignee: Account | None
    reviewer: Account | None
    head: int
    accepted_revision: int | None
    changes: dict[Category, int]
    changed_elements: int
    lanes: int
    crossings: int
    authors: list[Account]
    actions: tuple[Action, ...]
    can_edit: bool


@dataclass(frozen=True, slots=True)
class TaskListing:
    """A page of tasks. ``state_counts`` are those under the same filter without its states."""

    items: list[TaskView]
    total: int
    state_counts: dict[TaskState, int]


def listing(
    session: Session,
    actor: Actor,
    wanted: TaskFilter,
    *,
    states: Collection[TaskState] = (),
    reviewable: bool = False,
    sort: str = "newest",
    page: int = 1,
    page_size: int = 50,
) -> TaskListing:
    """The tasks that the actor may see and asks for; the review queue (``reviewable``) comes longest waiting first."""
    if not actor.reviews:
        wanted = replace(wanted, visible_to=actor.id)
    if reviewable:
        if not actor.reviews:
            return TaskListing([], 0, dict.fromkeys(TaskState, 0))
        wanted, sort = replace(wanted, reviewable_by=actor.id), "waiting"
    found, total = tasks.page_of(session, wanted, states, sort, offset=(page - 1) * page_size, limit=page_size)
    figures = tasks.figures(session, found)
    items = [_view(actor, task, figures[task.id]) for task in found]
    return TaskListing(items, total, tasks.state_counts(session, wanted))


def view(session: Session, actor: Actor, task: Task) -> TaskView:
    """One task as the actor sees it (who may see it is decided before, by ``access``)."""
    return _view(actor, task, tasks.figures(session, [task])[task.id])


def find(session: Session, actor: Actor, task_id: int) -> TaskView:
    """Raises NotFound when there is none, or the actor may not know of it."""
    return view(session, actor, readable_task(session, actor, task_id))


def standing(actor: Actor, task: Task, figures: TaskFigures) -> Standing:
    """Who the actor is to the task. Whoever submitted it answers for it, like whoever saved changes in it."""
    return Standing(
        role=actor.role,
        is_assignee=task.assignee_id == actor.id,
        is_author=actor.id in figures.submitters or any(author.id == actor.id for author in figures.authors),
    )


def history(session: Session, task: Task) -> Sequence[TaskEvent]:
    """All steps of the task with their remarks, oldest first."""
    return tasks.events(session, task.id)


def create(
    session: Session, actor: Actor, *, log_id: str, direction: Direction | None, assignee_id: int | None
) -> TaskView:
    """A new task on a log, on a line of its own that begins with the log's base map.

    Raises:
        NotFound: no such log.
        InvalidInput: the assignee is unknown or disabled.
    """
    log = tasks.log_by_name(session, log_id)
    if log is None:
        raise NotFound(f"There is no log {log_id[:80]!r}.", mend="Import it first.", code="log.not_found")
    assignee = _assignee(session, assignee_id)
    task = _new_task(session, log, direction or Direction(log.direction), assignee)
    _note(session, actor, task, "create", None)
    return view(session, actor, task)


def assign(session: Session, actor: Actor, task_id: int, assignee_id: int | None) -> TaskView:
    """Gives the task to somebody, or to nobody. What the one before has not saved stays in their draft.

    Raises:
        NotFound: no such task.
        InvalidInput: the assignee is unknown or disabled.
        Conflict: the task is accepted.
    """
    task = readable_task(session, actor, task_id, lock=True)
    assignee = _assignee(session, assignee_id)
    if task.state == TaskState.ACCEPTED:
        raise Conflict(
            "An accepted task cannot be given to somebody else.",
            mend="Reopen it first.",
            code="task.state",
            state=task.state,
        )
    if task.assignee_id != assignee_id:
        task.assignee = assignee
        _note(session, actor, task, "assign", TaskState(task.state), f"to {assignee.name if assignee else 'nobody'}")
    return view(session, actor, task)


def _new_task(session: Session, log: Log, direction: Direction, assignee: Account | None) -> Task:
    now = revisions.now(session)
    task = Task(
        log=log,
        line=fork(session, log),
        direction=direction.value,
        assignee=assignee,
        state=TaskState.DRAFT.value,
        state_since=now,
        created_at=now,
    )
    session.add(task)
    session.flush()
    return task


def _assignee(session: Session, account_id: int | None) -> Account | None:
    if account_id is None:
        return None
    account = accounts.by_id(session, account_id)
    if account is None or account.disabled_at is not None:
        problem = f"is {account_id}, which is no account" if account is None else f"is {account.name}, who is disabled"
        raise InvalidInput(problem, "Choose somebody from the list of people.", Place(key="assignee_id"))
    return account


def _note(
    session: Session, actor: Actor, task: Task, action: str, from_state: TaskState | None, reason: str = ""
) -> None:
    session.add(
        TaskEvent(
            task_id=task.id,
            actor_id=actor.id,
            action=action,
            from_state=from_state.value if from_state else None,
            to_state=task.state,
            revision=task.line.head,
            reason=reason,
        )
    )
    session.flush()


def _view(actor: Actor, task: Task, figures: TaskFigures) -> TaskView:
    state = TaskState(task.state)
    return TaskView(
        id=task.id,
        log_id=task.log.log_id,
        city=task.log.city,
        source_split=task.log.source_split,
        release_split=task.log.release_split,
        direction=Direction(task.direction),
        state=state,
        state_since=task.state_since,
        assignee=task.assignee,
        reviewer=task.reviewer,
        head=task.line.head,
        accepted_revision=task.accepted_revision,
        changes=figures.changes,
        changed_elements=figures.changed_elements,
        lanes=figures.lanes,
        crossings=figures.crossings,
        authors=figures.authors,
        actions=allowed_actions(state, standing(actor, task, figures)),
        can_edit=state in EDITABLE_STATES and (task.assignee_id == actor.id or actor.role is Role.ADMIN),
    )
