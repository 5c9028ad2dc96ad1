"""Steps through the states of a task."""

from __future__ import annotations

from fastapi import APIRouter

from lanewright.api.deps import AnyActor, SessionDep
from lanewright.api.schemas.path import RowNumber
from lanewright.api.schemas.tasks import Step, TaskOut
from lanewright.api.strict_json import StrictRoute
from lanewright.services import steps
from lanewright.services.steps import NewRemark

router = APIRouter(prefix="/api/v1/tasks", tags=["review"], route_class=StrictRoute)


@router.post("/{task_id}/steps", operation_id="take_step")
def take_step(task_id: RowNumber, body: Step, actor: AnyActor, session: SessionDep) -> TaskOut:
    """Submit, start the review, accept, send back or reopen; ``actions`` of the task says what is allowed now."""
    moved = steps.take(
        session,
        actor,
        task_id,
        body.action,
        revision=body.revision,
        reason=body.reason,
        remarks=[NewRemark(r.kind, r.element_id, r.text) for r in body.remarks],
    )
    return TaskOut.model_validate(moved)
