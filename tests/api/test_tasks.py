"""Lists of tasks, creating and assigning them."""

from __future__ import annotations

import datetime

import pytest
from sqlalchemy import select
from sqlalchemy.orm import Session
from tests.api.conftest import AddAccount, ClientFor
from tests.stored_logs import add_log

from lanewright.core.workflow import Role
from lanewright.db.models import AtomicChangeRow, Revision, Task
from lanewright.services import tasks
from lanewright.services.actor import Actor

TASKS = "/api/v1/tasks"


@pytest.fixture
def admin(session: Session, add_account: AddAccount) -> Actor:
    account = add_account(Role.ADMIN)
    return Actor(account.id, account.name, Role.ADMIN)


def add_task(session: Session, admin: Actor, log_id: str = "log-one", assignee: int | None = None) -> int:
    return tasks.create(session, admin, log_id=log_id, direction=None, assignee_id=assignee).id


def test_an_admin_creates_a_task_on_a_log(client_for: ClientFor, session: Session, add_account: AddAccount) -> None:
    add_log(session, split="test", direction="prior_to_current")
    anna = add_account(Role.ANNOTATOR, "anna")
    client = client_for(Role.ADMIN)
    answer = client.post(TASKS, json={"log_id": "log-one", "assignee_id": anna.id})
    assert answer.status_code == 201
    made = answer.json()
    assert made["assignee"] == {"id": anna.id, "name": "anna"}
    assert (made["direction"], made["release_split"], made["city"]) == ("prior_to_current", "test", "WDC")
    assert (made["state"], made["head"], made["lanes"], made["crossings"]) == ("draft", 0, 2, 1)
    assert (made["changes"], made["changed_elements"], made["authors"]) == ({}, 0, [])
    assert client.get(f"{TASKS}/{made['id']}").json() == made


def test_several_tasks_on_one_log_each_own_a_line(client_for: ClientFor, session: Session) -> None:
    add_log(session)
    client = client_for(Role.ADMIN)
    for direction in ("prior_to_current", "current_to_prior"):
        made = client.post(TASKS, json={"log_id": "log-one", "direction": direction})
        assert made.json()["direction"] == direction
    lines = session.scalars(select(Task.line_id)).all()
    assert len(set(lines)) == 2


@pytest.mark.parametrize(
    ("body", "status", "words"),
    [
        ({"log_id": "no-such-log"}, 404, "no-such-log"),
        ({"log_id": "log-one", "assignee_id": 2**60}, 422, "assignee_id"),
        ({"log_id": "log-one", "direction": "sideways"}, 422, "direction"),
        ({"log_id": "log-one", "state": "accepted"}, 422, "state"),
        ({"log_id": "log-one", "assignee_id": True}, 422, "assignee_id"),
        ({}, 422, "log_id"),
    ],
)
def test_what_cannot_be_a_task_is_named(
    client_for: ClientFor, session: Session, body: dict[str, object], status: int, words: str
) -> None:
    add_log(session)
    answer = client_for(Role.ADMIN).post(TASKS, json=body)
    assert answer.status_code == status
    assert words in answer.json()["message"]
    assert answer.json()["mend"]
    assert session.scalars(select(Task)).all() == []


def test_assigning_and_taking_back(
    client_for: ClientFor, session: Session, admin: Actor, add_account: AddAccount
) -> None:
    add_log(session)
    task_id = add_task(session, admin)
    anna = add_account(Role.ANNOTATOR, "anna")
    client = client_for(add_account(Role.ADMIN, "second admin"))
    assert client.patch(f"{TASKS}/{task_id}", json={"assignee_id": anna.id}).json()["assignee"]["name"] == "anna"
    assert client_for(anna).get(f"{TASKS}/{task_id}").json()["can_edit"] is True
    assert client.patch(f"{TASKS}/{task_id}", json={"assignee_id": None}).json()["assignee"] is None
    assert client_for(anna).get(f"{TASKS}/{task_id}").status_code == 404


def test_nobody_who_is_disabled_gets_a_task(
    client_for: ClientFor, session: Session, admin: Actor, add_account: AddAccount
) -> None:
    add_log(session)
    task_id = add_task(session, admin)
    gone = add_account(Role.ANNOTATOR, "gone")
    gone.disabled_at = datetime.datetime.now(datetime.UTC)
    answer = client_for(add_account(Role.ADMIN, "second")).patch(f"{TASKS}/{task_id}", json={"assignee_id": gone.id})
    assert answer.status_code == 422
    assert "disabled" in answer.json()["message"]


def test_an_annotator_sees_only_tasks_assigned_to_them(
    client_for: ClientFor, session: Session, admin: Actor, add_account: AddAccount
) -> None:
    add_log(session)
    anna, ben = add_account(Role.ANNOTATOR, "anna"), add_account(Role.ANNOTATOR, "ben")
    hers, his = add_task(session, admin, assignee=anna.id), add_task(session, admin, assignee=ben.id)
    add_task(session, admin)
    client = client_for(anna)
    listed = client.get(TASKS, params={"assignee": str(ben.id)}).json()
    assert (listed["items"], listed["total"]) == ([], 0)
    listed = client.get(TASKS).json()
    assert [item["id"] for item in listed["items"]] == [hers]
    assert sum(listed["state_counts"].values()) == 1
    foreign = client.get(f"{TASKS}/{his}")
    missing = client.get(f"{TASKS}/{2**62}")
    assert foreign.status_code == missing.status_code == 404
    assert foreign.json()["message"].replace(str(his), "N") == missing.json()["message"].replace(str(2**62), "N")


def test_search_filters_and_paging(
    client_for: ClientFor, session: Session, admin: Actor, add_account: AddAccount
) -> None:
    add_log(session, "autumn_2020", city="WDC", split="train")
    add_log(session, "spring%2021", city="MIA", split="test")
    anna = add_account(Role.ANNOTATOR, "anna")
    autumn = [add_task(session, admin, "autumn_2020", anna.id) for _ in range(3)]
    spring = add_task(session, admin, "spring%2021")
    client = client_for(Role.REVIEWER)

    def ids(**params: object) -> list[int]:
        answer = client.get(TASKS, params=params)
        assert answer.status_code == 200, answer.text
        return [item["id"] for item in answer.json()["items"]]

    assert ids() == [spring, *reversed(autumn)]
    assert ids(sort="log") == [*autumn, spring]
    assert ids(q="SPRING") == ids(city="MIA") == ids(split="test") == ids(assignee="nobody") == [spring]
    assert ids(q="%2021") == [spring], "a percent sign is a letter, not a wildcard"
    assert ids(q="anna") == ids(assignee=str(anna.id)) == list(reversed(autumn))
    assert ids(q=str(spring)) == [spring]
    assert ids(state=["submitted", "accepted"]) == []
    assert ids(page=2, page_size=3) == [autumn[0]]
    body = client.get(TASKS, params={"state": "accepted", "city": "WDC"}).json()
    assert body["total"] == 0
    assert body["state_counts"] == {
        "draft": 3, "submitted": 0, "in_review": 0, "changes_requested": 0, "accepted": 0
    }  # fmt: skip


def test_mine_are_those_assigned_to_me(
    client_for: ClientFor, session: Session, admin: Actor, add_account: AddAccount
) -> None:
    add_log(session)
    rita = add_account(Role.REVIEWER, "rita")
    hers = add_task(session, admin, assignee=rita.id)
    add_task(session, admin)
    listed = client_for(rita).get(TASKS, params={"assignee": "me"}).json()["items"]
    assert [item["id"] for item in listed] == [hers]


@pytest.mark.parametrize("query", ["assignee=somebody", "sort=random", "page=0", "page_size=1000", "state=done"])
def test_a_filter_that_means_nothing_is_refused(client_for: ClientFor, query: str) -> None:
    answer = client_for(Role.REVIEWER).get(f"{TASKS}?{query}")
    assert answer.status_code == 422
    assert query.split("=")[0] in answer.json()["message"]


def test_a_row_counts_what_changed_at_the_head(
    client_for: ClientFor, session: Session, admin: Actor, add_account: AddAccount
) -> None:
    add_log(session)
    anna = add_account(Role.ANNOTATOR, "anna")
    task = session.get_one(Task, add_task(session, admin, assignee=anna.id))
    for number in (1, 2):
        session.add(Revision(line_id=task.line_id, number=number, author_id=anna.id, content_sha256=b"x", updates=[]))
    session.flush()
    rows = [(1, 11, "geometry"), (2, 11, "geometry"), (2, 11, "marking"), (2, 12, "connectivity")]
    session.add_all(
        AtomicChangeRow(line_id=task.line_id, revision=r, kind="lane_segment", element_id=i, category=c, leaves=[])
        for r, i, c in rows
    )
    task.line.head = 2
    session.flush()
    row = client_for(Role.REVIEWER).get(TASKS).json()["items"][0]
    assert row["changes"] == {"geometry": 1, "marking": 1, "connectivity": 1}
    assert row["changed_elements"] == 1, "connectivity alone is no change in statistics"
    assert row["authors"] == [{"id": anna.id, "name": "anna"}]
