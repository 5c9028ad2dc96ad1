"""Saving a changeset: idempotent, atomic, checked by the rules, merged with what others saved meanwhile."""

from __future__ import annotations

import hashlib
import uuid
from collections.abc import Sequence
from typing import Any

import orjson
from sqlalchemy.orm import Session

from lanewright.core.claims import DeclaredMacros
from lanewright.core.edits import Edit
from lanewright.core.elements import Element, ElementKey
from lanewright.core.errors import Conflict
from lanewright.core.report import diff_document, edit_document
from lanewright.db.mapping import map_sha256, to_rows
from lanewright.db.models import Task
from lanewright.db.repositories import changes, drafts, elements, revisions
from lanewright.sensors.city import city_frame
from lanewright.services.access import readable_task, require_editable, require_own
from lanewright.services.actor import Actor
from lanewright.services.canonical import Retold, rename_documents, settled
from lanewright.services.declarations import documents
from lanewright.services.element_documents import key_documents, map_document
from lanewright.services.evaluation import Evaluation, evaluate
from lanewright.services.findings import violation_documents


def save(
    session: Session,
    actor: Actor,
    task_id: int,
    *,
    base_revision: int,
    edits: Sequence[Edit],
    declared: Sequence[DeclaredMacros] | None = None,
    changeset_uuid: uuid.UUID,
    note: str,
) -> bytes:
    """Saves one changeset and returns its answer, the JSON of ``SavedRevision``; a replay gets the same bytes again.

    ``declared``: all declarations of the task's line, not only new ones; None: those of the base revision.

    Raises:
        NotFound: no such task for this actor.
        Conflict: the UUID was saved with another body (``save.replayed_differently``); the task's state
            (``task.state``); others changed the same elements (``save.stale``); nothing differs (``save.empty``);
            the rules refuse it (``save.violations``, told as 422).
        Forbidden: the task is somebody else's.
        InvalidInput: an edit cannot be applied.
    """
    task = readable_task(session, actor, task_id, lock=True)
    body_sha256 = _body_sha256(base_revision, edits, declared, note)
    known = revisions.find_answer(session, task.line_id, actor.id, changeset_uuid)
    if known is not None:
        if known.body_sha256 != body_sha256:
            raise Conflict(
                f"Changeset {changeset_uuid} was saved before with other contents.",
                mend="Give every changeset a new UUID; repeat one only unchanged.",
                code="save.replayed_differently",
                changeset_uuid=str(changeset_uuid),
            )
        return known.answer
    require_own(actor, task)
    require_editable(task)
    evaluation = evaluate(session, task, actor.id, base_revision, edits, declared)
    _require_no_violation(evaluation)
    evaluation, retold = settled(session, task, actor.id, evaluation)
    _require_difference(evaluation, task.line.head)
    return _write(session, actor, task, evaluation, retold, changeset_uuid, body_sha256, note)


def check(
    session: Session,
    actor: Actor,
    task_id: int,
    *,
    base_revision: int,
    edits: Sequence[Edit],
    declared: Sequence[DeclaredMacros] | None = None,
) -> dict[str, Any]:
    """What a save of these edits would be told, as the JSON of ``Findings``; nothing is written.

    Raises:
        NotFound, InvalidInput, Conflict: as ``save``, but for state, violations and emptiness.
    """
    task = readable_task(session, actor, task_id)
    return evaluate(session, task, actor.id, base_revision, edits, declared).findings.document()


def _require_no_violation(evaluation: Evaluation) -> None:
    introduced = evaluation.introduced()
    if introduced:
        count = "1 error stops" if len(introduced) == 1 else f"{len(introduced)} errors stop"
        raise Conflict(
            f"{count} the save: {introduced[0].message}",
            mend="Apply a fix, or correct the element; your draft stays as it is.",
            code="save.violations",
            violations=violation_documents(introduced),
        )


def _require_difference(evaluation: Evaluation, head_revision: int) -> None:
    if evaluation.edited == evaluation.head.state and evaluation.declared == evaluation.head_declared:
        raise Conflict(
            f"There is nothing to save: revision {head_revision} already says what you sent."
            if not evaluation.restored
            else "There is nothing to save: no boundary moved by more than 5 cm, so the base's coordinates stay.",
            mend="Discard the draft and go on from the newest revision.",
            code="save.empty",
            head=head_revision,
            restored=key_documents(evaluation.restored),
        )


def _write(
    session: Session,
    actor: Actor,
    task: Task,
    evaluation: Evaluation,
    retold: Retold,
    changeset_uuid: uuid.UUID,
    body_sha256: bytes,
    note: str,
) -> bytes:
    head, edited = evaluation.head, evaluation.edited
    revision = revisions.advance_head(session, task.line_id, task.line.head)
    written = [element for element in edited if head.state.get(element.key) != element]
    gone = [element.key for element in head.state if element.key not in edited]
    rows = to_rows(written, city_frame(task.log.city).to_mercator)
    hashes = {key: sha256 for key, sha256 in head.hashes.items() if key in edited}
    hashes |= {element.key: row.sha256 for element, row in zip(written, rows, strict=True)}
    answer = _answer(session, task, evaluation, retold, revision, written)
    diff = evaluation.findings.diff
    revisions.insert_revision(
        session,
        line_id=task.line_id,
        number=revision,
        author_id=actor.id,
        note=note,
        changeset_uuid=changeset_uuid,
        body_sha256=body_sha256,
        answer=answer,
        content_sha256=map_sha256(hashes.items()),
        updates=diff_document(diff)["updates"],
        declarations=documents(evaluation.declared),
    )
    replaced = [element.key for element in written if element.key in head.state]
    closing = {key: head.versions[key] for key in (*replaced, *gone)}
    elements.close_versions(session, task.line_id, revision, closing)
    elements.insert_versions(session, task.line_id, revision, rows)
    changes.insert_changes(session, task.line_id, revision, diff.changes)
    drafts.settle(session, task.id, actor.id, revision)
    return answer


def _answer(
    session: Session,
    task: Task,
    evaluation: Evaluation,
    retold: Retold,
    revision: int,
    written: Sequence[Element],
) -> bytes:
    """The JSON of ``SavedRevision``: how the map now differs from the one that the editor had before its edits."""
    versions: dict[ElementKey, int] = {**evaluation.head.versions, **{element.key: revision for element in written}}
    seen, edited = evaluation.seen.state, evaluation.edited
    changed = [element for element in edited if seen.get(element.key) != element]
    removed = [element.key for element in seen if element.key not in edited]
    document = {
        "task_id": task.id,
        "revision": revision,
        "created_at": revisions.now(session),
        "changed": map_document(changed, versions),
        "removed": key_documents(removed),
        "restored": key_documents(evaluation.restored),
        "canonical": rename_documents(retold.renamed),
        "joined": list(retold.joined),
        "cut": list(retold.cut),
        "declarations": documents(evaluation.declared),
        "findings": evaluation.findings.document(),
    }
    return orjson.dumps(document, option=orjson.OPT_UTC_Z | orjson.OPT_NAIVE_UTC)


def _body_sha256(
    base_revision: int, edits: Sequence[Edit], declared: Sequence[DeclaredMacros] | None, note: str
) -> bytes:
    """Hash of what a changeset says, whatever the order of keys and the spaces in its JSON."""
    body = {"base_revision": base_revision, "edits": [edit_document(edit) for edit in edits], "note": note}
    if declared is not None:
        body["declarations"] = documents(declared)
    return hashlib.sha256(orjson.dumps(body, option=orjson.OPT_SORT_KEYS)).digest()
