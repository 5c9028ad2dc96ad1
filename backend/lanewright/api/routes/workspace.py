"""A task opened in the editor: its maps, drive, findings, draft and new ids."""

from __future__ import annotations

from typing import Annotated

from fastapi import APIRouter, Query, Response

from lanewright.api.deps import AnyActor, SessionDep
from lanewright.api.document import document_response
from lanewright.api.schemas.declarations import to_core
from lanewright.api.schemas.findings import Findings
from lanewright.api.schemas.path import RowNumber
from lanewright.api.schemas.tasks import DraftIn, DraftKept, Drive, IdBlockOut, TaskEventOut, TaskOut, Workspace
from lanewright.api.strict_json import StrictRoute
from lanewright.core.report import edit_document
from lanewright.services import drafts, drive, id_blocks, tasks, workspace

router = APIRouter(prefix="/api/v1/tasks/{task_id}", tags=["workspace"], route_class=StrictRoute)


@router.get("/workspace", operation_id="open_workspace", response_model=Workspace)
def open_workspace(
    task_id: RowNumber,
    actor: AnyActor,
    session: SessionDep,
    revision: Annotated[int | None, Query(ge=0, description="default: the head")] = None,
) -> Response:
    """All that the editor needs to open a task at one revision."""
    opened = workspace.open_task(session, actor, task_id, revision)
    shown = TaskOut.model_validate(tasks.view(session, actor, opened.task))
    events = [TaskEventOut.model_validate(event) for event in tasks.history(session, opened.task)]
    return document_response(
        {
            "task": shown.model_dump(mode="json"),
            **opened.parts,
            "draft": None if opened.draft is None else drafts.draft_document(opened.draft),
            "events": [event.model_dump(mode="json") for event in events],
        }
    )


@router.get("/drive", operation_id="get_drive", response_model=Drive)
def get_drive(task_id: RowNumber, actor: AnyActor, session: SessionDep) -> Response:
    """The vehicle's way through the log, and its frames."""
    return document_response(drive.drive(session, actor, task_id))


@router.get("/revisions/{revision}/findings", operation_id="get_findings", response_model=Findings)
def get_findings(task_id: RowNumber, revision: int, actor: AnyActor, session: SessionDep) -> Response:
    """Changes and violations from the base to one revision, for review and history."""
    return document_response(workspace.findings_at(session, actor, task_id, revision))


@router.post("/id-blocks", operation_id="take_id_block", status_code=201)
def take_id_block(task_id: RowNumber, actor: AnyActor, session: SessionDep) -> IdBlockOut:
    """A block of fresh element ids for one open workspace; no id is ever handed out twice."""
    first, last = id_blocks.take_block(session, actor, task_id)
    return IdBlockOut(first_id=first, last_id=last)


@router.put("/draft", operation_id="keep_draft")
def keep_draft(task_id: RowNumber, body: DraftIn, actor: AnyActor, session: SessionDep) -> DraftKept:
    """Keeps what is not saved yet.

    409 ``draft.newer``: another device kept one that this one has not seen.
    409 ``draft.superseded``: the asker has saved since the base revision, so this may be a late copy of what was saved;
    facts.version is the version to name to keep it all the same.
    """
    version, kept_at = drafts.keep_draft(
        session,
        actor,
        task_id,
        base_revision=body.base_revision,
        edits=[edit_document(edit.to_core()) for edit in body.edits],
        declared=to_core(body.declarations),
        seen_version=body.version,
    )
    return DraftKept(version=version, kept_at=kept_at)


@router.delete("/draft", operation_id="drop_draft", status_code=204)
def drop_draft(task_id: RowNumber, actor: AnyActor, session: SessionDep) -> None:
    """Drops the asker's own draft in this task."""
    drafts.drop_draft(session, actor, task_id)
