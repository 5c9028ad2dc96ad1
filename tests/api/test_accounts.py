"""People and their tokens."""

from __future__ import annotations

import datetime
from typing import Any

import pytest
from sqlalchemy import select, update
from sqlalchemy.orm import Session
from starlette.testclient import TestClient
from tests.api.conftest import PASSWORD, AddAccount, ClientFor

from lanewright.core.workflow import Role
from lanewright.db.models import Account, ApiToken

ACCOUNTS = "/api/v1/accounts"
TOKENS = "/api/v1/tokens"
CHANGES = "/api/v1/changes"


def test_an_admin_adds_a_person_who_can_then_sign_in(client_for: ClientFor, anonymous: TestClient) -> None:
    admin = client_for(Role.ADMIN)
    body = {"name": "Änne.B", "role": "annotator", "password": "ten letters"}
    answer = admin.post(ACCOUNTS, json=body)
    assert answer.status_code == 201
    assert "password" not in answer.text
    assert [a["name"] for a in admin.get(ACCOUNTS).json()] == ["admin", "Änne.B"]
    assert anonymous.post("/api/v1/session", json={"name": "änne.b", "password": "ten letters"}).status_code == 200


@pytest.mark.parametrize(
    ("changed", "status", "words"),
    [
        ({"name": "ADMIN"}, 409, "exists"),
        ({"name": "with space"}, 422, "name"),
        ({"name": ""}, 422, "name"),
        ({"name": "x" * 65}, 422, "name"),
        ({"role": "owner"}, 422, "role"),
        ({"password": "short"}, 422, "password"),
        ({"password": "x" * 257}, 422, "password"),
        ({"disabled": False}, 422, "disabled"),
    ],
)
def test_what_cannot_be_a_person_is_named(
    client_for: ClientFor, session: Session, changed: dict[str, Any], status: int, words: str
) -> None:
    body = {"name": "new", "role": "annotator", "password": "a long password"} | changed
    answer = client_for(Role.ADMIN).post(ACCOUNTS, json=body)
    assert answer.status_code == status
    assert words in answer.json()["message"]
    assert len(session.scalars(select(Account)).all()) == 1


def test_a_disabled_account_loses_sessions_and_tokens_at_once(client_for: ClientFor, anonymous: TestClient) -> None:
    rita, admin = client_for(Role.REVIEWER), client_for(Role.ADMIN)
    token = rita.post(TOKENS, json={"name": "ci", "scopes": ["changes:read"]}).json()["token"]
    bearer = {"Authorization": f"Bearer {token}"}
    assert anonymous.get(CHANGES, headers=bearer).status_code == 200
    account = f"{ACCOUNTS}/{rita.account.id}"  # type: ignore[attr-defined]
    assert admin.patch(account, json={"disabled": True}).json()["disabled_at"]
    assert rita.get("/api/v1/session").status_code == 401
    assert anonymous.get(CHANGES, headers=bearer).status_code == 401
    sign_in = {"name": "reviewer", "password": PASSWORD}
    assert anonymous.post("/api/v1/session", json=sign_in).status_code == 401
    assert admin.patch(account, json={"disabled": False}).json()["disabled_at"] is None
    assert anonymous.post("/api/v1/session", json=sign_in).status_code == 200
    assert anonymous.get(CHANGES, headers=bearer).status_code == 401, "a revoked token stays revoked"
    assert "reviewer" in [person["name"] for person in admin.get("/api/v1/people").json()]


def test_a_new_role_or_password_signs_the_person_out(client_for: ClientFor, add_account: AddAccount) -> None:
    admin = client_for(Role.ADMIN)
    anna = add_account(Role.ANNOTATOR, "anna")
    for change in ({"role": "reviewer"}, {"password": "set by the admin"}):
        hers = client_for(anna)
        assert admin.patch(f"{ACCOUNTS}/{anna.id}", json=change).status_code == 200
        assert hers.get("/api/v1/session").status_code == 401
    assert anna.role == "reviewer"


@pytest.mark.parametrize("change", [{"disabled": True}, {"role": "annotator"}])
def test_an_admin_cannot_lock_themself_out(client_for: ClientFor, change: dict[str, Any]) -> None:
    admin = client_for(Role.ADMIN)
    refused = admin.patch(f"{ACCOUNTS}/{admin.account.id}", json=change)  # type: ignore[attr-defined]
    assert (refused.status_code, refused.json()["code"]) == (409, "account.own")
    assert admin.get(ACCOUNTS).status_code == 200


def test_an_unknown_account_is_not_found(client_for: ClientFor) -> None:
    assert client_for(Role.ADMIN).patch(f"{ACCOUNTS}/{2**62}", json={"disabled": True}).status_code == 404


def test_people_are_listed_without_the_disabled(client_for: ClientFor, add_account: AddAccount) -> None:
    add_account(Role.ANNOTATOR, "gone").disabled_at = datetime.datetime.now(datetime.UTC)
    anna = add_account(Role.ANNOTATOR, "anna")
    people = client_for(Role.REVIEWER).get("/api/v1/people").json()
    assert people[0] == {"id": anna.id, "name": "anna"}
    assert [person["name"] for person in people] == ["anna", "reviewer"]


def test_a_token_is_shown_once_and_stored_as_a_hash(client_for: ClientFor, session: Session) -> None:
    rita = client_for(Role.REVIEWER)
    made = rita.post(TOKENS, json={"name": "ci", "scopes": ["export:read", "changes:read"], "days": 7})
    assert made.status_code == 201
    secret = made.json()["token"]
    assert secret.startswith("lanewright_")
    listed = rita.get(TOKENS)
    assert secret not in listed.text
    assert listed.json()[0]["scopes"] == ["changes:read", "export:read"]
    stored = session.scalars(select(ApiToken)).one()
    assert len(stored.token_sha256) == 32
    left = stored.expires_at - datetime.datetime.now(datetime.UTC)
    assert datetime.timedelta(days=6.9) < left < datetime.timedelta(days=7.1)


def test_a_token_is_good_only_for_its_scope_and_time_and_until_revoked(
    client_for: ClientFor, anonymous: TestClient, session: Session
) -> None:
    rita = client_for(Role.REVIEWER)
    made = rita.post(TOKENS, json={"name": "ci", "scopes": ["changes:read"]}).json()
    bearer = {"Authorization": f"Bearer {made['token']}"}
    assert anonymous.get(CHANGES, headers=bearer).status_code == 200
    for path in ("/api/v1/export/train.tar", "/api/v1/tasks", "/api/v1/tokens"):
        refused = anonymous.get(path, headers=bearer)
        assert (refused.status_code, refused.json()["code"]) == (403, "token.scope")
    assert rita.get(TOKENS).json()[0]["last_used_at"]
    session.execute(update(ApiToken).values(expires_at=datetime.datetime.now(datetime.UTC)))
    session.expire_all()
    assert anonymous.get(CHANGES, headers=bearer).json()["code"] == "token.refused"
    session.execute(update(ApiToken).values(expires_at=datetime.datetime.max.replace(tzinfo=datetime.UTC)))
    session.expire_all()
    assert anonymous.get(CHANGES, headers=bearer).status_code == 200
    assert rita.delete(f"{TOKENS}/{made['id']}").status_code == 204
    assert rita.delete(f"{TOKENS}/{made['id']}").status_code == 204, "again is no error"
    assert anonymous.get(CHANGES, headers=bearer).status_code == 401


def test_a_token_beside_a_cookie_is_judged_as_a_token(client_for: ClientFor) -> None:
    admin = client_for(Role.ADMIN)
    made = admin.post(TOKENS, json={"name": "ci", "scopes": ["changes:read"]}).json()
    refused = admin.get("/api/v1/accounts", headers={"Authorization": f"Bearer {made['token']}"})
    assert refused.status_code == 403


def test_a_demoted_owner_takes_the_tokens_along(
    client_for: ClientFor, anonymous: TestClient, add_account: AddAccount
) -> None:
    rita = add_account(Role.REVIEWER, "rita")
    token = client_for(rita).post(TOKENS, json={"name": "ci", "scopes": ["changes:read"]}).json()["token"]
    client_for(Role.ADMIN).patch(f"{ACCOUNTS}/{rita.id}", json={"role": "annotator"})
    refused = anonymous.get(CHANGES, headers={"Authorization": f"Bearer {token}"})
    assert (refused.status_code, refused.json()["code"]) == (403, "account.role")


def test_one_s_tokens_are_one_s_own(client_for: ClientFor, add_account: AddAccount) -> None:
    made = client_for(Role.REVIEWER).post(TOKENS, json={"name": "ci", "scopes": ["changes:read"]}).json()
    admin = client_for(Role.ADMIN)
    assert admin.get(TOKENS).json() == []
    assert admin.delete(f"{TOKENS}/{made['id']}").status_code == 404


@pytest.mark.parametrize(
    "changed",
    [{"scopes": ["everything"]}, {"scopes": []}, {"days": 0}, {"days": 367}, {"days": True}, {"name": " "}],
)
def test_what_cannot_be_a_token_is_named(client_for: ClientFor, changed: dict[str, Any]) -> None:
    body = {"name": "ci", "scopes": ["changes:read"], "days": 30} | changed
    answer = client_for(Role.ADMIN).post(TOKENS, json=body)
    assert answer.status_code == 422
    assert next(iter(changed)) in answer.json()["message"]


@pytest.mark.parametrize("header", ["Bearer", "Bearer  ", "Bearer nonsense", "Bearer \xe4", "Basic YTpi"])
def test_a_broken_authorization_opens_nothing(anonymous: TestClient, header: str) -> None:
    answer = anonymous.get(CHANGES, headers={"Authorization": header.encode("latin-1")})
    assert answer.status_code == 401
    assert answer.headers["www-authenticate"] == "Bearer"
