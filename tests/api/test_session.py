"""Signing in and out."""

from __future__ import annotations

import datetime

import pytest
from fastapi import FastAPI
from sqlalchemy import select, update
from sqlalchemy.orm import Session
from starlette.testclient import TestClient
from tests.api.conftest import ADDRESS, PASSWORD, AddAccount, ClientFor

from lanewright.api.cross_site import CSRF_HEADER
from lanewright.api.deps import COOKIE
from lanewright.core.workflow import Role
from lanewright.db.models import AccountSession, LoginFailure
from lanewright.services.demo_accounts import DEMO_PASSWORD, ensure_demo_accounts
from lanewright.settings import Settings

SESSION = "/api/v1/session"


def sign_in(client: TestClient, name: str, password: str = PASSWORD, **headers: str) -> object:
    return client.post(SESSION, json={"name": name, "password": password}, headers=headers)


def fail(session: Session, name: str, *, times: int) -> None:
    now = datetime.datetime.now(datetime.UTC)
    session.add_all(LoginFailure(name=name, address="elsewhere", at=now) for _ in range(times))
    session.flush()


def test_signing_in_gives_a_cookie_that_scripts_cannot_read_and_a_csrf_token(
    anonymous: TestClient, add_account: AddAccount
) -> None:
    add_account(Role.ANNOTATOR, "Anna")
    answer = anonymous.post(SESSION, json={"name": " anna", "password": PASSWORD})
    assert answer.status_code == 200
    cookie = answer.headers["set-cookie"]
    assert cookie.startswith(f"{COOKIE}=")
    assert "HttpOnly" in cookie
    assert "SameSite=strict" in cookie
    assert "Secure" not in cookie
    assert answer.json()["account"]["name"] == "Anna"
    assert anonymous.get(SESSION).json() == answer.json()


def test_every_failure_reads_the_same(anonymous: TestClient, session: Session, add_account: AddAccount) -> None:
    add_account(Role.ANNOTATOR, "anna")
    gone = add_account(Role.ANNOTATOR, "gone")
    gone.disabled_at = datetime.datetime.now(datetime.UTC)
    answers = [
        sign_in(anonymous, "anna", "wrong password"),
        sign_in(anonymous, "nobody"),
        sign_in(anonymous, "gone"),
        sign_in(anonymous, "x\u200b' OR 1=1 --"),
    ]
    assert {a.status_code for a in answers} == {401}
    assert len({(a.json()["code"], a.json()["message"], a.json()["mend"]) for a in answers}) == 1
    assert "set-cookie" not in answers[0].headers


def test_failed_sign_ins_are_counted_and_soon_have_to_wait(
    anonymous: TestClient, session: Session, add_account: AddAccount
) -> None:
    add_account(Role.ANNOTATOR, "anna")
    codes = [sign_in(anonymous, "anna", f"guess {n}").status_code for n in range(5)]
    assert codes == [401] * 5
    assert len(session.scalars(select(LoginFailure)).all()) == 5
    fail(session, "anna", times=10)  # a quarter of an hour to wait, however slow this machine is
    refused = sign_in(anonymous, "Anna")
    assert refused.status_code == 429, "even the right password waits"
    assert refused.json()["code"] == "session.throttled"
    assert 800 < int(refused.headers["retry-after"]) <= 900
    assert len(session.scalars(select(LoginFailure)).all()) == 15, "attempts that wait prove nothing and count nothing"
    over = datetime.datetime.now(datetime.UTC) - datetime.timedelta(seconds=901)
    session.execute(update(LoginFailure).values(at=over))
    assert sign_in(anonymous, "anna").status_code == 200
    assert session.scalars(select(LoginFailure)).all() == []


def test_guessing_many_names_from_one_address_has_to_wait(anonymous: TestClient, session: Session) -> None:
    now = datetime.datetime.now(datetime.UTC)
    session.add_all(LoginFailure(name=f"name{n}", address="testclient", at=now) for n in range(30))
    assert sign_in(anonymous, "somebody else").status_code == 429


def test_a_new_sign_in_gets_a_new_token_and_ends_the_old_one(
    anonymous: TestClient, app: FastAPI, add_account: AddAccount
) -> None:
    add_account(Role.ANNOTATOR, "anna")
    sign_in(anonymous, "anna")
    old = anonymous.cookies[COOKIE]
    sign_in(anonymous, "anna")
    assert anonymous.cookies[COOKIE] != old
    stolen = TestClient(app, base_url=ADDRESS, cookies={COOKIE: old})
    assert stolen.get(SESSION).status_code == 401


def test_the_token_is_not_stored(anonymous: TestClient, session: Session, add_account: AddAccount) -> None:
    add_account(Role.ANNOTATOR, "anna")
    sign_in(anonymous, "anna")
    stored = session.scalars(select(AccountSession)).one()
    assert stored.token_sha256 != anonymous.cookies[COOKIE].encode()
    assert len(stored.token_sha256) == 32


@pytest.mark.parametrize(
    "past",
    [
        {"last_seen_at": datetime.datetime.now(datetime.UTC) - datetime.timedelta(hours=13)},
        {"expires_at": datetime.datetime.now(datetime.UTC) - datetime.timedelta(seconds=1)},
    ],
    ids=["idle", "absolute"],
)
def test_a_session_expires(client_for: ClientFor, session: Session, past: dict[str, datetime.datetime]) -> None:
    client = client_for(Role.ANNOTATOR)
    assert client.get(SESSION).status_code == 200
    session.execute(update(AccountSession).values(**past))
    session.expire_all()
    answer = client.get(SESSION)
    assert answer.status_code == 401
    assert "expired" in answer.json()["message"]


def test_signing_out_ends_the_session(client_for: ClientFor, session: Session) -> None:
    client = client_for(Role.ANNOTATOR)
    assert client.delete(SESSION).status_code == 204
    assert client.get(SESSION).status_code == 401
    assert session.scalars(select(AccountSession)).all() == []


def test_a_changed_password_signs_out_the_other_browsers(client_for: ClientFor, anonymous: TestClient) -> None:
    here = client_for(Role.ANNOTATOR)
    elsewhere = client_for(here.account)  # type: ignore[attr-defined]
    new = "a new long password"
    assert here.put(f"{SESSION}/password", json={"current": PASSWORD, "new": new}).status_code == 204
    assert here.get(SESSION).status_code == 200
    assert elsewhere.get(SESSION).status_code == 401
    assert sign_in(anonymous, "annotator").status_code == 401
    assert sign_in(anonymous, "annotator", new).status_code == 200


def test_a_password_is_changed_only_by_who_knows_it(client_for: ClientFor, session: Session) -> None:
    client = client_for(Role.ANNOTATOR)
    url = f"{SESSION}/password"
    wrong = client.put(url, json={"current": "guess", "new": "a new long password"})
    assert wrong.status_code == 422
    assert "current" in wrong.json()["message"]
    assert [failure.name for failure in session.scalars(select(LoginFailure))] == ["annotator"]
    short = client.put(url, json={"current": PASSWORD, "new": "short"})
    assert short.status_code == 422
    assert short.json()["message"].startswith("new:")
    fail(session, "annotator", times=14)
    assert client.put(url, json={"current": PASSWORD, "new": "a new long password"}).status_code == 429


@pytest.mark.parametrize(
    ("headers", "code"),
    [
        ({CSRF_HEADER: ""}, "session.csrf"),
        ({CSRF_HEADER: "x" * 43}, "session.csrf"),
        ({"Origin": "https://evil.example"}, "session.cross_site"),
        ({"Origin": "null"}, "session.cross_site"),
        ({"Sec-Fetch-Site": "cross-site"}, "session.cross_site"),
        ({"Sec-Fetch-Site": "same-site"}, "session.cross_site"),
    ],
)
def test_other_sites_cannot_act_for_the_person(client_for: ClientFor, headers: dict[str, str], code: str) -> None:
    client = client_for(Role.ANNOTATOR)
    refused = client.delete(SESSION, headers=headers)
    assert (refused.status_code, refused.json()["code"]) == (403, code)
    assert client.get(SESSION).status_code == 200


def test_our_own_pages_may(client_for: ClientFor) -> None:
    client = client_for(Role.ANNOTATOR)
    own = {"Origin": ADDRESS, "Sec-Fetch-Site": "same-origin"}
    assert client.delete(SESSION, headers=own).status_code == 204


def test_another_site_cannot_sign_a_browser_in(anonymous: TestClient, add_account: AddAccount) -> None:
    add_account(Role.ANNOTATOR, "anna")
    assert sign_in(anonymous, "anna", Origin="https://evil.example").status_code == 403


def test_under_tls_the_cookie_is_bound_to_it(app: FastAPI, settings: Settings, add_account: AddAccount) -> None:
    app.state.settings = settings.model_copy(update={"public_url": "https://lanes.example"})
    add_account(Role.ANNOTATOR, "anna")
    client = TestClient(app, base_url="https://127.0.0.1")
    answer = sign_in(client, "anna", Origin="https://lanes.example")
    assert answer.headers["set-cookie"].startswith(f"__Host-{COOKIE}=")
    assert "Secure" in answer.headers["set-cookie"]
    assert client.get(SESSION).status_code == 200


def test_demo_passwords_open_nothing_outside_of_the_demo(
    anonymous: TestClient, app: FastAPI, session: Session, settings: Settings
) -> None:
    ensure_demo_accounts(session)
    assert sign_in(anonymous, "admin", DEMO_PASSWORD).json()["demo"] is True
    app.state.settings = settings.model_copy(update={"database_url": "postgresql://db.example/lanewright"})
    refused = sign_in(anonymous, "Admin", DEMO_PASSWORD)
    assert (refused.status_code, refused.json()["code"]) == (401, "session.refused")
