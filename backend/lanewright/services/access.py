"""Who may read and who may edit a task: asked by everything that touches one."""

from __future__ import annotations

from sqlalchemy.orm import Session

from lanewright.core.errors import Conflict, Forbidden, NotFound
from lanewright.core.workflow import EDITABLE_STATES, Role, TaskState
from lanewright.db.models import Task
from lanewright.db.repositories.task_lock import find_task
from lanewright.services.actor import Actor


def readable_task(session: Session, actor: Actor, task_id: int, *, lock: bool = False) -> Task:
    """The task, if the actor may know of it: annotators know only of tasks assigned to them.

    Raises:
        NotFound: there is no such task, or it is none of theirs.
    """
    task = find_task(session, task_id, lock=lock)
    if task is None or not (actor.reviews or task.assignee_id == actor.id):
        raise NotFound(
            f"There is no task {task_id}.",
            mend="Look for it in the list of tasks: it may have been given to somebody else.",
            code="task.not_found",
            task_id=task_id,
        )
    return task


def own_task(session: Session, actor: Actor, task_id: int, *, lock: bool = False) -> Task:
    """The task, if the actor may edit it when its state allows: its assignee and admins.

    Raises:
        NotFound: as ``readable_task``.
        Forbidden: it is assigned to somebody else.
    """
    task = readable_task(session, actor, task_id, lock=lock)
    require_own(actor, task)
    return task


def require_own(actor: Actor, task: Task) -> None:
    """Raises Forbidden unless the actor is the task's assignee or an admin."""
    if task.assignee_id != actor.id and actor.role is not Role.ADMIN:
        raise Forbidden(
            f"Task {task.id} is not assigned to you.",
            mend="Ask an admin to assign it to you.",
            code="task.not_assigned",
        )


def require_editable(task: Task) -> None:
    """Raises Conflict unless the task's state allows edits."""
    state = TaskState(task.state)
    if state not in EDITABLE_STATES:
        raise Conflict(
            f"Task {task.id} is {state.value.replace('_', ' ')} and cannot be edited.",
            mend="Your draft stays as it is; the task can be edited again when a reviewer sends it back.",
            code="task.state",
            state=state.value,
        )
