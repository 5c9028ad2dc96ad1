"""Clients of the real application on the rolled-back session of each test."""

from __future__ import annotations

import datetime
from collections.abc import Callable, Iterator
from functools import lru_cache
from pathlib import Path

import pytest
import structlog
from fastapi import FastAPI
from sqlalchemy.orm import Session
from starlette.testclient import TestClient
from tests.api.desk import Desk
from tests.api.drawings import add_map_log
from tests.stored_logs import add_log

from lanewright.api.app import create_app
from lanewright.api.cross_site import CSRF_HEADER
from lanewright.api.deps import COOKIE, get_session
from lanewright.core.changes import Direction
from lanewright.core.elements import MapState
from lanewright.core.workflow import Role
from lanewright.db.models import Account
from lanewright.services import sessions, tasks
from lanewright.services.actor import Actor
from lanewright.services.passwords import hash_password
from lanewright.services.sessions import SessionRules
from lanewright.settings import Settings

ADDRESS = "http://127.0.0.1"
PASSWORD = "correct horse battery"
RULES = SessionRules(idle=datetime.timedelta(hours=12), absolute=datetime.timedelta(days=7), demo_allowed=True)

# Traces without local variables: Rich's, the default, take half a minute for a request's.
structlog.configure(
    processors=[
        *structlog.get_config()["processors"][:-1],
        structlog.dev.ConsoleRenderer(exception_formatter=structlog.dev.plain_traceback),
    ]
)

ClientFor = Callable[..., TestClient]
AddAccount = Callable[..., Account]
DeskOf = Callable[[Account], Desk]
DeskOn = Callable[[MapState], Desk]


@lru_cache(maxsize=1)
def password_hash() -> str:
    """One hash for all test people: hashing is slow on purpose."""
    return hash_password(PASSWORD)


@pytest.fixture
def settings(tmp_path: Path) -> Settings:
    frontend = tmp_path / "dist"
    (frontend / "assets").mkdir(parents=True)
    (frontend / "index.html").write_text("<!doctype html><title>Lanewright</title>")
    (frontend / "assets" / "index-1a2b.js").write_text("export {}")
    return Settings(home=tmp_path / "home", frontend=frontend, database_url=None)


@pytest.fixture
def app(session: Session, database_url: str, settings: Settings) -> FastAPI:
    """The application; a request that fails leaves no trace in the test's transaction, as in life."""
    application = create_app(settings, database_url)

    def in_a_savepoint() -> Iterator[Session]:
        with session.begin_nested():
            yield session
        session.expire_all()

    application.dependency_overrides[get_session] = in_a_savepoint
    return application


@pytest.fixture
def anonymous(app: FastAPI) -> Iterator[TestClient]:
    """A client that nobody has signed in with."""
    with TestClient(app, base_url=ADDRESS, raise_server_exceptions=False) as client:
        yield client


@pytest.fixture
def add_account(session: Session) -> AddAccount:
    """Adds a person: ``add_account(Role.REVIEWER, "rita")``; the name defaults to the role's."""

    def add(role: Role, name: str | None = None) -> Account:
        account = Account(name=name or role.value, role=role.value, password_hash=password_hash())
        session.add(account)
        session.flush()
        return account

    return add


@pytest.fixture
def client_for(app: FastAPI, session: Session, add_account: AddAccount) -> ClientFor:
    """A signed-in client: ``client_for(Role.ADMIN)``, or of somebody who exists: ``client_for(account)``.

    ``client.account`` is whose it is. The same person gets a new session at every call.
    """

    def client(who: Role | Account) -> TestClient:
        account = add_account(who) if isinstance(who, Role) else who
        begun = sessions.begin(session, account, RULES)
        made = TestClient(app, base_url=ADDRESS, raise_server_exceptions=False)
        made.cookies.set(COOKIE, begun.token)
        made.headers[CSRF_HEADER] = begun.session.csrf_token
        made.account = account  # type: ignore[attr-defined]
        return made

    return client


@pytest.fixture
def anna(add_account: AddAccount) -> Account:
    return add_account(Role.ANNOTATOR, "anna")


@pytest.fixture
def task_id(session: Session, add_account: AddAccount, anna: Account) -> int:
    """A task of anna's on the small log, edited from current to prior; the admin who made it is called boss."""
    add_log(session)
    boss = add_account(Role.ADMIN, "boss")
    actor = Actor(boss.id, boss.name, Role.ADMIN)
    return tasks.create(session, actor, log_id="log-one", direction=None, assignee_id=anna.id).id


@pytest.fixture
def desk_of(client_for: ClientFor, task_id: int) -> DeskOf:
    """Somebody at work on that task."""
    return lambda account: Desk(client_for(account), task_id)


@pytest.fixture
def desk(desk_of: DeskOf, anna: Account) -> Desk:
    """anna at work on her task."""
    return desk_of(anna)


@pytest.fixture
def desk_on(session: Session, add_account: AddAccount, client_for: ClientFor, anna: Account) -> DeskOn:
    """anna at work on a task whose base is that map, edited from prior to current."""

    def made(base: MapState) -> Desk:
        log = add_map_log(session, "log-of-its-own", base)
        boss = add_account(Role.ADMIN, "boss")
        actor = Actor(boss.id, boss.name, Role.ADMIN)
        direction = Direction.PRIOR_TO_CURRENT
        made = tasks.create(session, actor, log_id=log.log_id, direction=direction, assignee_id=anna.id)
        return Desk(client_for(anna), made.id)

    return made
