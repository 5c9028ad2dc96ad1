"""Who may do what: every route × role × ownership, from one table. A route that the table lacks fails."""

from __future__ import annotations

import contextlib
import uuid
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from functools import partial
from typing import Any

import pytest
from fastapi import FastAPI
from fastapi.routing import iter_route_contexts
from sqlalchemy.orm import Session
from starlette.testclient import TestClient
from tests.api.conftest import PASSWORD, AddAccount, ClientFor
from tests.stored_logs import add_log

from lanewright.api.app import create_app
from lanewright.api.routes.export import get_snapshots
from lanewright.core.workflow import Role
from lanewright.db.models import Account
from lanewright.db.repositories.logs import insert_asset
from lanewright.services import tasks, tokens
from lanewright.services.actor import Actor
from lanewright.settings import Settings

WHO = ("anonymous", "owner", "stranger", "reviewer", "admin", "export token", "changes token")
"""owner: the annotator whom the task is assigned to; stranger: another one; the tokens are an admin's."""
DELETE_CROSSING = {"operation": "delete", "kind": "pedestrian_crossing", "id": 21}
LIDAR_DETAILS = {"bounds": [0.0, 0.0, 20.0, 8.0], "metres_per_pixel": 0.1, "sweeps": 1}
CHANGESET = {"base_revision": 0, "edits": [DELETE_CROSSING]}


@dataclass(frozen=True)
class Route:
    """A request that would succeed for whoever may make it, and the status that each of ``WHO`` gets."""

    method: str
    path: str
    answers: tuple[int, ...]
    body: dict[str, Any] | None = field(default=None)


def signed_in(status: int) -> tuple[int, ...]:
    return (401, status, status, status, status, 403, 403)


def reviewing(status: int) -> tuple[int, ...]:
    return (401, 403, 403, status, status, 403, 403)


def admin_only(status: int) -> tuple[int, ...]:
    return (401, 403, 403, 403, status, 403, 403)


def readers_of_the_task(status: int) -> tuple[int, ...]:
    return (401, status, 404, status, status, 403, 403)


def editors_of_the_task(status: int) -> tuple[int, ...]:
    return (401, status, 404, 403, status, 403, 403)


def everybody(status: int) -> tuple[int, ...]:
    return (status,) * len(WHO)


TASK = "/api/v1/tasks/{task}"
ROUTES: dict[str, Route] = {
    "sign_in": Route("POST", "/api/v1/session", everybody(200), {"name": "owner", "password": PASSWORD}),
    "get_session": Route("GET", "/api/v1/session", (401, 200, 200, 200, 200, 401, 401)),
    "sign_out": Route("DELETE", "/api/v1/session", (401, 204, 204, 204, 204, 401, 401)),
    "change_password": Route(
        "PUT", "/api/v1/session/password", signed_in(204), {"current": PASSWORD, "new": "another long one"}
    ),
    "list_accounts": Route("GET", "/api/v1/accounts", admin_only(200)),
    "create_account": Route(
        "POST", "/api/v1/accounts", admin_only(201), {"name": "new", "role": "admin", "password": "a long password"}
    ),
    "change_account": Route("PATCH", "/api/v1/accounts/{owner}", admin_only(200), {"role": "admin"}),
    "list_people": Route("GET", "/api/v1/people", reviewing(200)),
    "list_tokens": Route("GET", "/api/v1/tokens", signed_in(200)),
    "create_token": Route("POST", "/api/v1/tokens", reviewing(201), {"name": "n", "scopes": ["export:read"]}),
    "revoke_token": Route("DELETE", "/api/v1/tokens/{token}", (401, 404, 404, 404, 204, 403, 403)),
    "list_logs": Route("GET", "/api/v1/logs", reviewing(200)),
    "lidar_image": Route("GET", "/api/v1/logs/log-one/lidar.png", readers_of_the_task(200)),
    "list_tasks": Route("GET", "/api/v1/tasks", signed_in(200)),
    "create_task": Route("POST", "/api/v1/tasks", admin_only(201), {"log_id": "log-one"}),
    "assign_task": Route("PATCH", TASK, admin_only(200), {"assignee_id": None}),
    "get_task": Route("GET", TASK, readers_of_the_task(200)),
    "open_workspace": Route("GET", f"{TASK}/workspace", readers_of_the_task(200)),
    "get_drive": Route("GET", f"{TASK}/drive", readers_of_the_task(200)),
    "get_findings": Route("GET", f"{TASK}/revisions/0/findings", readers_of_the_task(200)),
    "take_id_block": Route("POST", f"{TASK}/id-blocks", editors_of_the_task(201)),
    "keep_draft": Route("PUT", f"{TASK}/draft", editors_of_the_task(200), CHANGESET | {"version": 0}),
    "drop_draft": Route("DELETE", f"{TASK}/draft", readers_of_the_task(204)),
    "check_draft": Route("POST", f"{TASK}/check", readers_of_the_task(200), CHANGESET),
    "make_canonical": Route("POST", f"{TASK}/canonical", readers_of_the_task(200), CHANGESET),
    "save": Route(
        "POST",
        f"{TASK}/revisions",
        editors_of_the_task(201),
        CHANGESET | {"changeset_uuid": str(uuid.UUID(int=7)), "note": ""},
    ),
    "take_step": Route("POST", f"{TASK}/steps", editors_of_the_task(200), {"action": "submit", "revision": 0}),
    "query_changes": Route("GET", "/api/v1/changes", (401, 403, 403, 200, 200, 403, 200)),
    "export_split": Route("GET", "/api/v1/export/train.tar", (401, 403, 403, 200, 200, 200, 403)),
    "healthz": Route("GET", "/healthz", everybody(200)),
    "readyz": Route("GET", "/readyz", everybody(200)),
}


def operations() -> list[str]:
    """The operation ids of the application itself."""
    description = create_app(Settings(), database_url="postgresql:///none").openapi()
    return sorted(operation["operationId"] for path in description["paths"].values() for operation in path.values())


@pytest.fixture
def names(session: Session, add_account: AddAccount) -> dict[str, int]:
    """Ids that the paths of the table name; puts a task of the owner's and a token of the admin's in place."""
    people = {
        name: add_account(role, name)
        for name, role in (
            ("owner", Role.ANNOTATOR),
            ("stranger", Role.ANNOTATOR),
            ("reviewer", Role.REVIEWER),
            ("admin", Role.ADMIN),
        )
    }
    log = add_log(session)
    insert_asset(session, log.id, "lidar.png", "image/png", b"image", LIDAR_DETAILS)
    admin = Actor(people["admin"].id, "admin", Role.ADMIN)
    task = tasks.create(session, admin, log_id="log-one", direction=None, assignee_id=people["owner"].id)
    token, _ = tokens.create(session, admin, name="a", scopes=["changes:read"], days=1)
    return {"task": task.id, "token": token.id} | {name: account.id for name, account in people.items()}


@pytest.fixture
def requester(
    app: FastAPI, session: Session, names: dict[str, int], anonymous: TestClient, client_for: ClientFor
) -> Callable[[str], TestClient]:
    """The client of one of ``WHO``."""
    app.dependency_overrides[get_snapshots] = lambda: partial(_the_tests_own, session)

    def client(who: str) -> TestClient:
        if who == "anonymous":
            return TestClient(app, base_url=str(anonymous.base_url), raise_server_exceptions=False)
        if who.endswith("token"):
            admin = Actor(names["admin"], "admin", Role.ADMIN)
            scope = {"export token": "export:read", "changes token": "changes:read"}[who]
            _, secret = tokens.create(session, admin, name=who, scopes=[scope], days=1)
            bearer = {"Authorization": f"Bearer {secret}"}
            return TestClient(app, base_url=str(anonymous.base_url), raise_server_exceptions=False, headers=bearer)
        return client_for(session.get_one(Account, names[who]))

    return client


@pytest.mark.parametrize("operation", operations())
def test_every_route_answers_each_person_as_the_table_says(
    operation: str, session: Session, names: dict[str, int], requester: Callable[[str], TestClient]
) -> None:
    route = ROUTES[operation]
    answers: dict[str, int] = {}
    for who in WHO:
        attempt = session.begin_nested()
        answer = requester(who).request(route.method, route.path.format(**names), json=route.body)
        answers[who] = answer.status_code
        if answer.is_error:
            assert answer.json()["message"]
            assert answer.json()["mend"]
        attempt.rollback()
        session.expire_all()
    assert answers == dict(zip(WHO, route.answers, strict=True))


def test_the_table_names_no_route_that_is_gone() -> None:
    assert set(ROUTES) == set(operations())


def test_nothing_else_is_served_without_the_api(app: FastAPI) -> None:
    """Addresses outside of the description are public: only the pages and the documentation may be there."""
    described = set(app.openapi()["paths"])
    hidden = {context.path for context in iter_route_contexts(app.routes)} - described
    assert hidden == {"/openapi.json", "/{path:page}", "/docs", "/docs/start.js", "/docs/{name}"}


@contextlib.contextmanager
def _the_tests_own(session: Session) -> Iterator[Session]:
    yield session
