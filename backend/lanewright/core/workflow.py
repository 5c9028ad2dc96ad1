"""The states of a task and who may move it from one to the next: one table, enforced by the server."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum

from lanewright.core.errors import Conflict, Forbidden, InvalidInput, Place


class Role(StrEnum):
    ANNOTATOR = "annotator"
    REVIEWER = "reviewer"
    ADMIN = "admin"


class TaskState(StrEnum):
    DRAFT = "draft"
    SUBMITTED = "submitted"
    IN_REVIEW = "in_review"
    CHANGES_REQUESTED = "changes_requested"
    ACCEPTED = "accepted"


class Action(StrEnum):
    SUBMIT = "submit"
    START_REVIEW = "start_review"
    ACCEPT = "accept"
    SEND_BACK = "send_back"
    REOPEN = "reopen"


EDITABLE_STATES = frozenset({TaskState.DRAFT, TaskState.CHANGES_REQUESTED})


@dataclass(frozen=True, slots=True)
class Transition:
    """One allowed step.

    ``roles`` may take it whoever they are to the task; ``assignee`` says that the task's assignee may too.
    ``independent``: nobody who saved a changeset in the task, or submitted it, may take it.
    """

    action: Action
    source: TaskState
    target: TaskState
    roles: frozenset[Role]
    assignee: bool = False
    independent: bool = False
    needs_reason: bool = False
    names_revision: bool = False


_REVIEWERS = frozenset({Role.REVIEWER, Role.ADMIN})
_ADMIN = frozenset({Role.ADMIN})

TRANSITIONS: tuple[Transition, ...] = (
    Transition(Action.SUBMIT, TaskState.DRAFT, TaskState.SUBMITTED, _ADMIN, assignee=True, names_revision=True),
    Transition(
        Action.SUBMIT, TaskState.CHANGES_REQUESTED, TaskState.SUBMITTED, _ADMIN, assignee=True, names_revision=True
    ),
    Transition(Action.START_REVIEW, TaskState.SUBMITTED, TaskState.IN_REVIEW, _REVIEWERS, independent=True),
    Transition(
        Action.ACCEPT, TaskState.IN_REVIEW, TaskState.ACCEPTED, _REVIEWERS, independent=True, names_revision=True
    ),
    Transition(
        Action.SEND_BACK,
        TaskState.IN_REVIEW,
        TaskState.CHANGES_REQUESTED,
        _REVIEWERS,
        independent=True,
        needs_reason=True,
        names_revision=True,
    ),
    Transition(Action.REOPEN, TaskState.ACCEPTED, TaskState.CHANGES_REQUESTED, _ADMIN, needs_reason=True),
)


@dataclass(frozen=True, slots=True)
class Standing:
    """Who the actor is to the task: role, whether its assignee, whether they saved or submitted in it."""

    role: Role
    is_assignee: bool
    is_author: bool


def _may(transition: Transition, standing: Standing) -> bool:
    if transition.independent and standing.is_author:
        return False
    return standing.role in transition.roles or (transition.assignee and standing.is_assignee)


def allowed_actions(state: TaskState, standing: Standing) -> tuple[Action, ...]:
    """What the actor may do with the task now; the browser shows just these."""
    return tuple(t.action for t in TRANSITIONS if t.source is state and _may(t, standing))


def transition(
    action: Action, state: TaskState, standing: Standing, *, revision: int | None, head_revision: int, reason: str
) -> TaskState:
    """The state that ``action`` leads to.

    Raises:
        Conflict: the state does not allow the action, or the revision named is not the head any more.
        Forbidden: the actor may not take it (not their task, or they would judge their own work).
        InvalidInput: a reason or the revision is missing.
    """
    step = next((t for t in TRANSITIONS if t.action is action and t.source is state), None)
    if step is None:
        raise Conflict(
            f"A task that is {state.value.replace('_', ' ')} cannot take the step {action.value.replace('_', ' ')}.",
            mend="Reload the task: somebody may have moved it on.",
            code="task.state",
            state=state.value,
            action=action.value,
        )
    if step.independent and standing.is_author:
        raise Forbidden(
            "You saved changes in this task or submitted it, so somebody else must review it.",
            mend="Leave it in the queue for another reviewer.",
            code="task.own_work",
        )
    if not _may(step, standing):
        raise Forbidden("Your role does not allow this step.", mend="Ask an admin.", code="task.role")
    if step.needs_reason and not reason.strip():
        raise InvalidInput("is empty", "Say in a sentence why, so the next person can act on it.", Place(key="reason"))
    if step.names_revision and revision is None:
        raise InvalidInput("is missing", "Name the revision that you looked at.", Place(key="revision"))
    if step.names_revision and revision != head_revision:
        raise Conflict(
            f"You looked at revision {revision}, but the task is at revision {head_revision}.",
            mend="Reload the task and look at the newer revision.",
            code="task.revision_moved",
            provided=revision,
            latest=head_revision,
        )
    return step.target
