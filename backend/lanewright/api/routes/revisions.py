"""Checking and saving changesets: one path, with and without writing."""

from __future__ import annotations

from fastapi import APIRouter, Response

from lanewright.api.deps import AnyActor, SessionDep
from lanewright.api.document import document_response, json_response
from lanewright.api.schemas.declarations import to_core
from lanewright.api.schemas.findings import Findings
from lanewright.api.schemas.path import RowNumber
from lanewright.api.schemas.revisions import CanonicalOut, CheckIn, SavedRevision, SaveIn
from lanewright.api.strict_json import StrictRoute
from lanewright.services import canonical, saving

router = APIRouter(prefix="/api/v1/tasks/{task_id}", tags=["workspace"], route_class=StrictRoute)


@router.post("/check", operation_id="check_draft", response_model=Findings)
def check_draft(task_id: RowNumber, body: CheckIn, actor: AnyActor, session: SessionDep) -> Response:
    """What a save would be told; nothing is written. 409 ``save.stale`` as there."""
    found = saving.check(
        session,
        actor,
        task_id,
        base_revision=body.base_revision,
        edits=[edit.to_core() for edit in body.edits],
        declared=to_core(body.declarations),
    )
    return document_response(found)


@router.post("/canonical", operation_id="make_canonical", response_model=CanonicalOut)
def make_canonical(task_id: RowNumber, body: CheckIn, actor: AnyActor, session: SessionDep) -> Response:
    """What takes the draft to its canonical form, as edits to apply to it; nothing is written.

    New elements in them have ids made up for the occasion, as in fixes. 409 ``save.stale`` as in a save.
    """
    proposed = canonical.proposal(
        session,
        actor,
        task_id,
        base_revision=body.base_revision,
        edits=[edit.to_core() for edit in body.edits],
        declared=to_core(body.declarations),
    )
    return document_response(proposed)


@router.post("/revisions", operation_id="save", status_code=201, response_model=SavedRevision)
def save(task_id: RowNumber, body: SaveIn, actor: AnyActor, session: SessionDep) -> Response:
    """Saves one changeset as the next revision. The same UUID with the same contents is answered byte for byte alike.

    Where the check notes ``identity.not_canonical``, the canonical form is stored; ``canonical`` says what is called
    otherwise now. ``declarations`` replace all that stood before; left out, those of the base revision stay.

    409 ``save.stale``: others changed the same elements (facts.conflicts: base, mine, theirs, and facts.declarations).
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
        declared=to_core(body.declarations),
        changeset_uuid=body.changeset_uuid,
        note=body.note,
    )
    return json_response(answer, 201)
