"""Tasks and lists of them."""

from __future__ import annotations

from typing import Annotated

from fastapi import APIRouter, Query

from lanewright.api.deps import AdminActor, AnyActor, SessionDep
from lanewright.api.schemas.path import Page, PageSize, RowNumber
from lanewright.api.schemas.tasks import TaskCreate, TaskOut, TaskPage, TaskPatch
from lanewright.api.strict_json import StrictRoute
from lanewright.core.errors import InvalidInput, Place
from lanewright.core.workflow import TaskState
from lanewright.db.repositories.tasks import NOBODY, TaskFilter
from lanewright.services import tasks
from lanewright.services.actor import Actor

router = APIRouter(prefix="/api/v1/tasks", tags=["tasks"], route_class=StrictRoute)

Assignee = Annotated[str, Query(description="me, nobody, or an account id; empty: anybody")]
Reviewable = Annotated[
    bool, Query(description="only tasks that the asker may review now: the review queue, oldest first")
]
Sort = Annotated[str, Query(pattern="^(newest|waiting|log)$")]


@router.get("", operation_id="list_tasks")
def list_tasks(
    actor: AnyActor,
    session: SessionDep,
    q: str = "",
    assignee: Assignee = "",
    state: Annotated[list[TaskState] | None, Query()] = None,
    city: str | None = None,
    split: str | None = None,
    reviewable: Reviewable = False,
    sort: Sort = "newest",
    page: Page = 1,
    page_size: PageSize = 50,
) -> TaskPage:
    """Tasks; annotators get only those assigned to them. ``q``: part of the log id, the assignee, or the number."""
    wanted = TaskFilter(text=q.strip(), assignee=_assignee(actor, assignee), city=city, split=split)
    found = tasks.listing(
        session,
        actor,
        wanted,
        states=state or (),
        reviewable=reviewable,
        sort=sort,
        page=page,
        page_size=page_size,
    )
    return TaskPage(
        items=[TaskOut.model_validate(item) for item in found.items],
        total=found.total,
        page=page,
        page_size=page_size,
        state_counts=found.state_counts,
    )


@router.post("", operation_id="create_task", status_code=201)
def create_task(body: TaskCreate, actor: AdminActor, session: SessionDep) -> TaskOut:
    """A new task on a log, beginning with its base map."""
    made = tasks.create(session, actor, log_id=body.log_id, direction=body.direction, assignee_id=body.assignee_id)
    return TaskOut.model_validate(made)


@router.patch("/{task_id}", operation_id="assign_task")
def assign_task(task_id: RowNumber, body: TaskPatch, actor: AdminActor, session: SessionDep) -> TaskOut:
    """Gives the task to somebody, or takes it back."""
    return TaskOut.model_validate(tasks.assign(session, actor, task_id, body.assignee_id))


@router.get("/{task_id}", operation_id="get_task")
def get_task(task_id: RowNumber, actor: AnyActor, session: SessionDep) -> TaskOut:
    """One task, and what the asker may do with it."""
    return TaskOut.model_validate(tasks.find(session, actor, task_id))


def _assignee(actor: Actor, text: str) -> int | None:
    match text.strip():
        case "":
            return None
        case "me":
            return actor.id
        case "nobody":
            return NOBODY
        case number if number.isascii() and number.isdigit() and len(number) <= 18:
            return int(number)
    raise InvalidInput(f"is {text[:40]!r}", "Write me, nobody or an account id.", Place(key="assignee"))
