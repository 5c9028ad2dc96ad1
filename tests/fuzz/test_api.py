"""schemathesis over the API's own description: whatever is sent, no server error, and nothing that is not documented.

``LANEWRIGHT_FUZZ_EXAMPLES=300 pytest tests/fuzz/test_api.py`` looks longer.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from typing import Any
from zlib import crc32

import pytest
import schemathesis
from hypothesis import HealthCheck, settings
from schemathesis.checks import not_a_server_error
from schemathesis.config import SchemathesisConfig
from schemathesis.specs.openapi.checks import (
    content_type_conformance,
    negative_data_rejection,
    response_headers_conformance,
    response_schema_conformance,
    status_code_conformance,
    unsupported_method,
)
from tests.api.conftest import ADDRESS, RULES, password_hash
from tests.stored_logs import add_log, change_task

from lanewright.api.app import create_app
from lanewright.api.cross_site import CSRF_HEADER
from lanewright.api.deps import COOKIE
from lanewright.core.elements import MapState
from lanewright.core.workflow import Role
from lanewright.db.engine import transaction
from lanewright.db.models import Account
from lanewright.db.repositories.logs import insert_asset
from lanewright.services import sessions, tasks
from lanewright.settings import Settings

LARGEST_NUMBER = 2**63 - 1
EXAMPLES = int(os.environ.get("LANEWRIGHT_FUZZ_EXAMPLES", "12"))
CHECKS = [
    not_a_server_error,
    status_code_conformance,
    content_type_conformance,
    response_headers_conformance,
    response_schema_conformance,
    negative_data_rejection,
    unsupported_method,
]
app = create_app(Settings(), database_url="postgresql:///none")  # each test puts its own database in place
schema = schemathesis.openapi.from_asgi(
    "/openapi.json",
    app,
    config=SchemathesisConfig.from_dict(
        {"generation": {"with-security-parameters": False}, "request-timeout": 600}  # the test signs in itself
    ),
    headers={"Host": "127.0.0.1"},
)


@schema.hook
def map_path_parameters(context: Any, path_parameters: dict[str, Any] | None) -> dict[str, Any] | None:
    """Every other path leads to something that exists: guessed numbers never would. What is bad on purpose stays."""
    known = {"task_id": 1, "account_id": 2, "token_id": 1, "revision": 1, "log_id": "log-one", "split": "train"}
    for name, value in known.items():
        guessed = (path_parameters or {}).get(name)
        good = type(guessed) is type(value) and (not isinstance(guessed, int) or 1 <= guessed <= LARGEST_NUMBER)
        if path_parameters and good and crc32(str(guessed).encode("utf-8", "replace")) % 2:
            path_parameters[name] = value
    return path_parameters


@pytest.fixture
def world(fresh_database: str) -> Iterator[str]:
    """A database with an admin, an annotator and a task with a changeset, behind the application."""
    with transaction(fresh_database) as session:
        admin = Account(name="admin", role=Role.ADMIN.value, password_hash=password_hash())
        session.add_all([admin, Account(name="anna", role=Role.ANNOTATOR.value, password_hash=password_hash())])
        session.flush()
        log = add_log(session)
        details = {"bounds": [0.0, 0.0, 20.0, 8.0], "metres_per_pixel": 0.1, "sweeps": 1}
        insert_asset(session, log.id, "lidar.png", "image/png", b"image", details)
        task = tasks.create(session, sessions.actor_of(admin), log_id="log-one", direction=None, assignee_id=None)
        change_task(session, task.id, lambda state: MapState.of(state.lanes.values()))
    app.state.database_url = fresh_database
    yield fresh_database
    app.state.database_url = "postgresql:///none"


@schema.parametrize()
@settings(max_examples=EXAMPLES, deadline=None, suppress_health_check=list(HealthCheck))
def test_whatever_is_sent(case: schemathesis.Case, world: str) -> None:
    with transaction(world) as session:
        admin = session.query(Account).filter_by(name="admin").one()
        begun = sessions.begin(session, admin, RULES)  # anew each time: some requests sign the admin out
        csrf_token = begun.session.csrf_token
    case.call_and_validate(
        base_url=ADDRESS,
        headers={CSRF_HEADER: csrf_token},
        cookies={COOKIE: begun.token},
        checks=CHECKS,
    )
