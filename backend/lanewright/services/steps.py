"""Steps of a task through its states: the workflow's table applied under a lock, with the history it leaves."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from sqlalchemy.orm import Session

from lanewright.core.elements import ElementKind
from lanewright.core.errors import Conflict, InvalidInput, Place
from lanewright.core.workflow import Action, TaskState, transition
from lanewright.db.models import Remark, Task, TaskEvent
from lanewright.db.repositories import accounts, drafts, revisions, tasks
from lanewright.services.access import readable_task
from lanewright.services.actor import Actor
from lanewright.services.drafts import is_unsaved
from lanewright.services.tasks import TaskView, standing, view


@dataclass(frozen=True, slots=True)
class NewRemark:
    """What a reviewer says of one element."""

    kind: ElementKind
    element_id: int
    text: str


def take(
    session: Session,
    actor: Actor,
    task_id: int,
    action: Action,
    *,
    revision: int | None,
    reason: str,
    remarks: Sequence[NewRemark] = (),
) -> TaskView:
    """Moves the task on, and writes down who did it, why, and what was said of which element.

    Raises:
        NotFound: no such task, or the actor may not know of it.
        Conflict, Forbidden, InvalidInput: as ``core.workflow.transition`` says; also Conflict while the person who
            edits the task has a draft that is not saved (``task.unsaved_draft``), and InvalidInput for a remark on an
            element that never was in the task.
    """
    task = readable_task(session, actor, task_id, lock=True)
    figures = tasks.figures(session, [task])[task.id]
    source, head = TaskState(task.state), task.line.head
    target = transition(
        action, source, standing(actor, task, figures), revision=revision, head_revision=head, reason=reason
    )
    if action is Action.SUBMIT:
        _require_all_saved(session, actor, task)
    _require_known_elements(session, task, remarks)
    task.state = target.value
    task.state_since = revisions.now(session)
    reviews = action in (Action.START_REVIEW, Action.ACCEPT, Action.SEND_BACK)
    # A second reviewer takes a review over by finishing it: the task then names them.
    task.reviewer = accounts.by_id(session, actor.id) if reviews else None
    task.accepted_revision = head if action is Action.ACCEPT else None
    session.add(
        TaskEvent(
            task_id=task.id,
            actor_id=actor.id,
            action=action.value,
            from_state=source.value,
            to_state=target.value,
            revision=head,
            reason=reason,
            remarks=[Remark(kind=r.kind.value, element_id=r.element_id, text=r.text) for r in remarks],
        )
    )
    session.flush()
    return view(session, actor, task)


def _require_all_saved(session: Session, actor: Actor, task: Task) -> None:
    for account_id in sorted({actor.id, task.assignee_id or actor.id}):
        draft = drafts.find(session, task.id, account_id)
        if draft is not None and is_unsaved(session, task, draft):
            whose = "Your" if account_id == actor.id else "The assignee's"
            raise Conflict(
                f"{whose} draft holds changes that are not saved.",
                mend="Save them or drop the draft, then submit.",
                code="task.unsaved_draft",
                account_id=account_id,
            )


def _require_known_elements(session: Session, task: Task, remarks: Sequence[NewRemark]) -> None:
    if not remarks:
        return
    known = tasks.known_elements(session, task.line_id, {remark.element_id for remark in remarks})
    for position, remark in enumerate(remarks):
        if (remark.kind.value, remark.element_id) not in known:
            raise InvalidInput(
                f"is {remark.element_id}, but the task has no such {remark.kind.value.replace('_', ' ')}",
                "Remark on an element of the task.",
                Place(key=f"remarks[{position}].element_id"),
            )
