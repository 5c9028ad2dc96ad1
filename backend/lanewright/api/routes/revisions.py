"""Checking and saving changesets: one path, with and without writing."""

from __future__ import annotations

from fastapi import APIRouter, Response

from lanewright.api.deps import AnyActor, SessionDep
from lanewright.api.document import document_response, json_response
from lanewright.api.schemas.findings import Findings
from lanewright.api.schemas.path import RowNumber
from lanewright.api.schemas.revisions import CheckIn, SavedRevision, SaveIn
from lanewright.api.strict_json import StrictRoute
from lanewright.services import saving

router = APIRouter(prefix="/api/v1/tasks/{task_id}", tags=["workspace"], route_class=StrictRoute)


@router.post("/check", operation_id="check_draft", response_model=Findings)
def check_draft(task_id: RowNumber, body: CheckIn, actor: AnyActor, session: SessionDep) -> Response:
    """What a save would be told; nothing is written. 409 ``save.stale`` as there."""
    edits = [edit.to_core() for edit in body.edits]
    return document_response(saving.check(session, actor, task_id, base_revision=body.base_revision, edits=edits))


@router.post("/revisions", operation_id="save", status_code=201, response_model=SavedRevision)
def save(task_id: RowNumber, body: SaveIn, actor: AnyActor, session: SessionDep) -> Response:
    """Saves one changeset as the next revision. The same UUID with the same contents is answered byte for byte alike.

    409 ``save.stale``: others changed the same elements (facts.conflicts: base, mine, theirs).
    409 ``save.empty``: nothing differs. 409 ``save.replayed_differently``: the UUID was saved with other contents.
    409 ``task.state``: the task is not open for edits.
    422 ``save.violations``: the rules refuse it (facts.violations, with fixes).
    """
    answer = saving.save(
        session,
        actor,
        task_id,
        base_revision=body.base_revision,
        edits=[edit.to_core() for edit in body.edits],
        changeset_uuid=body.changeset_uuid,
        note=body.note,
    )
    return json_response(answer, 201)
