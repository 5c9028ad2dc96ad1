"""Review: the steps of a task, who may take them, and what they leave behind."""

from __future__ import annotations

from typing import Any

import pytest
from sqlalchemy import select
from sqlalchemy.orm import Session
from starlette.testclient import TestClient
from tests.api.conftest import AddAccount, ClientFor
from tests.stored_logs import add_log

from lanewright.core.workflow import Role
from lanewright.db.models import Account, Draft, Revision, Task, TaskEvent
from lanewright.services import tasks
from lanewright.services.actor import Actor


@pytest.fixture
def anna(add_account: AddAccount) -> Account:
    return add_account(Role.ANNOTATOR, "anna")


@pytest.fixture
def task(session: Session, add_account: AddAccount, anna: Account) -> Task:
    """A task of anna's with one saved changeset."""
    admin = add_account(Role.ADMIN, "founder")
    add_log(session)
    made = tasks.create(
        session, Actor(admin.id, admin.name, Role.ADMIN), log_id="log-one", direction=None, assignee_id=anna.id
    )
    task = session.get_one(Task, made.id)
    save_as(session, task, anna)
    return task


def save_as(session: Session, task: Task, author: Account) -> None:
    task.line.head += 1
    session.add(
        Revision(line_id=task.line_id, number=task.line.head, author_id=author.id, content_sha256=b"x", updates=[])
    )
    session.flush()


def remark(kind: str, element_id: int) -> dict[str, Any]:
    return {"kind": kind, "element_id": element_id, "text": "?"}


def step(client: TestClient, task: Task, action: str, **body: Any) -> Any:
    return client.post(f"/api/v1/tasks/{task.id}/steps", json={"action": action} | body)


def test_a_task_goes_from_draft_to_accepted_and_back(
    client_for: ClientFor, session: Session, task: Task, anna: Account, add_account: AddAccount
) -> None:
    hers, rita, boss = client_for(anna), client_for(Role.REVIEWER), client_for(Role.ADMIN)
    submitted = step(hers, task, "submit", revision=1).json()
    assert (submitted["state"], submitted["actions"], submitted["can_edit"]) == ("submitted", [], False)
    assert rita.get("/api/v1/tasks", params={"reviewable": True}).json()["total"] == 1
    started = step(rita, task, "start_review").json()
    assert (started["state"], started["reviewer"]["name"]) == ("in_review", "reviewer")
    assert started["actions"] == ["accept", "send_back"]
    remarks = [{"kind": "lane_segment", "element_id": 11, "text": "Too narrow."}]
    back = step(rita, task, "send_back", revision=1, reason="One lane is wrong.", remarks=remarks).json()
    assert (back["state"], back["reviewer"]["name"]) == ("changes_requested", "reviewer")
    assert hers.get(f"/api/v1/tasks/{task.id}").json()["can_edit"] is True
    assert step(hers, task, "submit", revision=1).json()["reviewer"] is None
    step(rita, task, "start_review")
    accepted = step(rita, task, "accept", revision=1).json()
    assert (accepted["state"], accepted["accepted_revision"]) == ("accepted", 1)
    reopened = step(boss, task, "reopen", reason="The crosswalk was repainted.").json()
    assert (reopened["state"], reopened["accepted_revision"]) == ("changes_requested", None)
    events = session.scalars(select(TaskEvent).order_by(TaskEvent.id)).all()
    assert [event.action for event in events] == [
        "create", "submit", "start_review", "send_back", "submit", "start_review", "accept", "reopen"
    ]  # fmt: skip
    sent_back = events[3]
    assert (sent_back.from_state, sent_back.to_state) == ("in_review", "changes_requested")
    assert (sent_back.revision, sent_back.reason, sent_back.actor.name) == (1, "One lane is wrong.", "reviewer")
    assert [(r.kind, r.element_id, r.text) for r in sent_back.remarks] == [("lane_segment", 11, "Too narrow.")]


def test_a_task_without_any_change_can_be_submitted_and_accepted(
    client_for: ClientFor, session: Session, anna: Account, add_account: AddAccount
) -> None:
    admin = add_account(Role.ADMIN)
    add_log(session)
    made = tasks.create(
        session, Actor(admin.id, admin.name, Role.ADMIN), log_id="log-one", direction=None, assignee_id=anna.id
    )
    task = session.get_one(Task, made.id)
    rita = client_for(Role.REVIEWER)
    step(client_for(anna), task, "submit", revision=0)
    step(rita, task, "start_review")
    assert step(rita, task, "accept", revision=0).json()["accepted_revision"] == 0


def test_nobody_reviews_their_own_work(
    client_for: ClientFor, session: Session, task: Task, anna: Account, add_account: AddAccount
) -> None:
    helper = add_account(Role.REVIEWER, "helper")
    save_as(session, task, helper)
    step(client_for(anna), task, "submit", revision=2)
    hers = client_for(helper)
    refused = step(hers, task, "start_review")
    assert (refused.status_code, refused.json()["code"]) == (403, "task.own_work")
    assert hers.get("/api/v1/tasks", params={"reviewable": True}).json()["total"] == 0
    assert hers.get(f"/api/v1/tasks/{task.id}").json()["actions"] == []


def test_who_submitted_a_task_does_not_accept_it(client_for: ClientFor, task: Task) -> None:
    boss = client_for(Role.ADMIN)
    assert step(boss, task, "submit", revision=1).status_code == 200
    assert step(boss, task, "start_review").json()["code"] == "task.own_work"


def test_a_second_reviewer_takes_a_review_over_by_finishing_it(
    client_for: ClientFor, task: Task, anna: Account, add_account: AddAccount
) -> None:
    step(client_for(anna), task, "submit", revision=1)
    first, second = (client_for(add_account(Role.REVIEWER, name)) for name in ("first", "second"))
    step(first, task, "start_review")
    assert second.get("/api/v1/tasks", params={"reviewable": True}).json()["total"] == 0, "one is at it already"
    assert step(second, task, "accept", revision=1).json()["reviewer"]["name"] == "second"
    late = step(first, task, "send_back", revision=1, reason="No.")
    assert (late.status_code, late.json()["code"]) == (409, "task.state")


@pytest.mark.parametrize(
    ("action", "body", "status", "code"),
    [
        ("submit", {}, 422, "invalid_input"),
        ("submit", {"revision": 0}, 409, "task.revision_moved"),
        ("submit", {"revision": 7}, 409, "task.revision_moved"),
        ("accept", {"revision": 1}, 409, "task.state"),
        ("reopen", {"reason": "x"}, 409, "task.state"),
        ("erase", {}, 422, "request.invalid"),
        ("submit", {"revision": 1.0}, 422, "request.invalid"),
        ("submit", {"revision": 1, "author": "rita"}, 422, "request.invalid"),
        ("submit", {"revision": 1, "remarks": [remark("lane_segment", 77)]}, 422, "invalid_input"),
        ("submit", {"revision": 1, "remarks": [remark("pedestrian_crossing", 11)]}, 422, "invalid_input"),
    ],
)  # fmt: skip
def test_a_step_that_cannot_be_taken_changes_nothing(
    client_for: ClientFor, session: Session, task: Task, anna: Account,
    action: str, body: dict[str, Any], status: int, code: str,
) -> None:  # fmt: skip
    answer = step(client_for(anna), task, action, **body)
    assert (answer.status_code, answer.json()["code"]) == (status, code)
    assert answer.json()["mend"]
    session.refresh(task)
    assert task.state == "draft"
    assert len(session.scalars(select(TaskEvent)).all()) == 1


def test_sending_back_needs_a_reason(client_for: ClientFor, task: Task, anna: Account) -> None:
    step(client_for(anna), task, "submit", revision=1)
    rita = client_for(Role.REVIEWER)
    step(rita, task, "start_review")
    refused = step(rita, task, "send_back", revision=1, reason="  ")
    assert refused.status_code == 422
    assert "reason" in refused.json()["message"]


def test_submitting_needs_everything_saved(client_for: ClientFor, session: Session, task: Task, anna: Account) -> None:
    draft = Draft(
        task_id=task.id,
        account_id=anna.id,
        base_revision=1,
        edits=[{"operation": "delete", "kind": "lane_segment", "id": 11, "attributes": {}}],
        kept_at=task.created_at,
    )
    session.add(draft)
    session.flush()
    hers = client_for(anna)
    for client in (hers, client_for(Role.ADMIN)):
        refused = step(client, task, "submit", revision=1)
        assert (refused.status_code, refused.json()["code"]) == (409, "task.unsaved_draft")
    draft.edits = []
    session.flush()
    assert step(hers, task, "submit", revision=1).status_code == 200


def test_an_annotator_cannot_step_in_for_another(client_for: ClientFor, task: Task, add_account: AddAccount) -> None:
    ben = client_for(add_account(Role.ANNOTATOR, "ben"))
    assert step(ben, task, "submit", revision=1).status_code == 404


def test_a_reviewer_who_is_not_assigned_cannot_submit(client_for: ClientFor, task: Task) -> None:
    refused = step(client_for(Role.REVIEWER), task, "submit", revision=1)
    assert (refused.status_code, refused.json()["code"]) == (403, "task.role")


def test_an_accepted_task_stays_with_its_assignee(client_for: ClientFor, task: Task, anna: Account) -> None:
    step(client_for(anna), task, "submit", revision=1)
    rita = client_for(Role.REVIEWER)
    step(rita, task, "start_review")
    step(rita, task, "accept", revision=1)
    boss = client_for(Role.ADMIN)
    refused = boss.patch(f"/api/v1/tasks/{task.id}", json={"assignee_id": None})
    assert (refused.status_code, refused.json()["code"]) == (409, "task.state")
