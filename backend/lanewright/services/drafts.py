"""Drafts on the server: a lost computer loses nothing, and two devices cannot overwrite each other unseen."""

from __future__ import annotations

import datetime
from collections.abc import Sequence
from typing import Any

from sqlalchemy.orm import Session

from lanewright.core.claims import DeclaredMacros
from lanewright.core.errors import Conflict, InvalidInput, Place
from lanewright.db.models import Draft, Task
from lanewright.db.repositories import drafts
from lanewright.services.access import own_task, readable_task
from lanewright.services.actor import Actor
from lanewright.services.declarations import declared_at, documents, from_documents, in_order


def keep_draft(
    session: Session,
    actor: Actor,
    task_id: int,
    *,
    base_revision: int,
    edits: list[Any],
    declared: Sequence[DeclaredMacros] | None,
    seen_version: int,
) -> tuple[int, datetime.datetime]:
    """Keeps a draft over the version that its writer has seen (0: none); returns the new version and the time.

    ``declared`` None: the declarations of the base revision.

    Whatever state the task is in: nothing that somebody drew is ever turned away.

    Raises:
        NotFound, Forbidden: the task is not the actor's.
        InvalidInput: it claims a base revision that does not exist yet.
        Conflict: ``draft.newer``, with the draft that another device kept meanwhile; ``draft.superseded`` where the
            actor has saved since the base revision: most likely this is the draft that was saved. The facts name the
            version under which it is kept all the same.
    """
    task = own_task(session, actor, task_id)
    if base_revision > task.line.head:
        raise InvalidInput(
            f"is {base_revision}, but the task's newest revision is {task.line.head}",
            "Reload the task.",
            Place(key="base_revision"),
        )
    stated = declared_at(session, task.line_id, base_revision) if declared is None else in_order(declared)
    kept = drafts.keep(
        session,
        task_id=task_id,
        account_id=actor.id,
        base_revision=base_revision,
        edits=edits,
        declarations=documents(stated),
        seen_version=seen_version,
    )
    if kept is None:
        newer = drafts.find(session, task_id, actor.id)
        if newer is None:
            raise _superseded(session, task_id, actor)
        raise Conflict(
            "Another window or computer of yours kept a newer draft of this task.",
            mend="Take over the newer draft, or keep yours instead.",
            code="draft.newer",
            draft=draft_document(newer),
        )
    return kept.version, kept.kept_at


def _superseded(session: Session, task_id: int, actor: Actor) -> Conflict:
    saved = drafts.find_settled(session, task_id, actor.id)
    return Conflict(
        "You have saved this task since this draft was begun.",
        mend="Go on from the newest revision; if the draft holds more than was saved, keep it under the version named.",
        code="draft.superseded",
        revision=None if saved is None else saved.saved_as,
        version=0 if saved is None else saved.version,
    )


def is_unsaved(session: Session, task: Task, draft: Draft) -> bool:
    """Whether a draft says anything that its base revision does not."""
    stated = from_documents(draft.declarations)
    return bool(draft.edits) or stated != declared_at(session, task.line_id, draft.base_revision)


def drop_draft(session: Session, actor: Actor, task_id: int) -> None:
    """Removes the actor's own draft, if there is one. Raises NotFound when the task is none they may know of."""
    readable_task(session, actor, task_id)
    drafts.drop(session, task_id, actor.id)


def draft_document(draft: Draft) -> dict[str, Any]:
    """A draft as the API's JSON."""
    return {
        "base_revision": draft.base_revision,
        "edits": draft.edits,
        "declarations": draft.declarations,
        "version": draft.version,
        "kept_at": draft.kept_at.isoformat(),
    }
