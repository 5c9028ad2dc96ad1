"""What every answer has in common: errors in words, request ids, security headers, caching; and the pages."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import pytest
import structlog
from fastapi import FastAPI
from sqlalchemy.exc import OperationalError
from sqlalchemy.orm import Session
from starlette.testclient import TestClient
from tests.api.conftest import ADDRESS, ClientFor

from lanewright.api.app import create_app
from lanewright.api.deps import SessionDep
from lanewright.core.workflow import Role
from lanewright.db.engine import transaction
from lanewright.db.models import Account, Line
from lanewright.settings import Settings

PAGES = ["/", "/tasks/7", "/api/v1/session", "/docs", "/openapi.json", "/healthz", "/assets/missing.js"]


def test_a_failing_commit_is_no_success(fresh_database: str, settings: Settings) -> None:
    app = create_app(settings, fresh_database)

    @app.post("/api/v1/broken", status_code=201)
    def broken(session: SessionDep) -> str:
        session.add(Account(name="half", role="admin", password_hash="x"))
        session.add(Line(log_id=10**9, head=0))  # the missing log is noticed when the transaction ends
        return "saved"

    answer = TestClient(app, base_url=ADDRESS, raise_server_exceptions=False).post("/api/v1/broken")
    assert answer.status_code == 500
    with transaction(fresh_database) as session:
        assert session.query(Account).count() == 0


def test_what_nobody_foresaw_is_told_without_a_trace(
    app: FastAPI, anonymous: TestClient, capsys: pytest.CaptureFixture[str]
) -> None:
    @app.get("/api/v1/broken")
    def broken() -> None:
        raise ZeroDivisionError("a secret of the server")

    answer = anonymous.get("/api/v1/broken")
    assert answer.status_code == 500
    body = answer.json()
    assert body["code"] == "server.error"
    assert body["request_id"] == answer.headers["x-request-id"]
    assert body["request_id"] in body["mend"]
    assert "secret" not in answer.text
    logged = capsys.readouterr().out
    assert "ZeroDivisionError" in logged
    assert body["request_id"] in logged


def test_a_lost_database_is_told_as_such(app: FastAPI, anonymous: TestClient) -> None:
    @app.get("/api/v1/broken")
    def broken() -> None:
        raise OperationalError("SELECT secret", {}, Exception("server closed the connection"))

    answer = anonymous.get("/api/v1/broken")
    assert (answer.status_code, answer.json()["code"]) == (503, "server.database")
    assert answer.headers["retry-after"]
    assert "secret" not in answer.text


def test_no_database_at_all(settings: Settings) -> None:
    app = create_app(settings, "postgresql:///lanewright?host=/nowhere")
    client = TestClient(app, base_url=ADDRESS, raise_server_exceptions=False)
    assert client.get("/healthz").status_code == 200
    assert client.get("/readyz").status_code == 503
    assert client.post("/api/v1/session", json={"name": "a", "password": "b"}).status_code == 503


def test_readiness_names_what_is_missing(app: FastAPI, anonymous: TestClient, settings: Settings) -> None:
    assert anonymous.get("/readyz").json()["status"] == "ready"
    (settings.frontend / "index.html").unlink()
    answer = anonymous.get("/readyz")
    assert (answer.status_code, answer.json()["message"]) == (503, "The frontend is not built.")
    page = anonymous.get("/tasks")
    assert page.status_code == 503
    assert "make run" in page.text


def test_a_request_id_of_a_proxy_is_kept_unless_it_is_odd(anonymous: TestClient) -> None:
    assert anonymous.get("/healthz", headers={"X-Request-ID": "proxy-17"}).headers["x-request-id"] == "proxy-17"
    odd = anonymous.get("/healthz", headers={"X-Request-ID": "x" * 65 + "\t"}).headers["x-request-id"]
    assert re.fullmatch("[0-9a-f]{32}", odd)


def test_requests_are_logged_with_their_ids(anonymous: TestClient) -> None:
    with structlog.testing.capture_logs(processors=[structlog.contextvars.merge_contextvars]) as lines:
        answer = anonymous.get("/api/v1/session?password=never-logged")
    (line,) = [line for line in lines if line["event"] == "request"]
    assert line["request_id"] == answer.headers["x-request-id"]
    assert (line["method"], line["path"], line["status"]) == ("GET", "/api/v1/session", 401)


@pytest.mark.parametrize("path", PAGES)
def test_every_answer_has_the_security_headers(anonymous: TestClient, path: str) -> None:
    headers = anonymous.get(path).headers
    policy = dict(part.split(" ", 1) for part in headers["content-security-policy"].split("; "))
    assert policy["default-src"] == policy["script-src"] == "'self'"
    assert policy["frame-ancestors"] == policy["object-src"] == "'none'"
    assert headers["x-content-type-options"] == "nosniff"
    assert headers["referrer-policy"] == "no-referrer"
    assert "strict-transport-security" not in headers


def test_under_tls_browsers_are_told_to_stay_with_it(settings: Settings, database_url: str) -> None:
    public = settings.model_copy(update={"public_url": "https://lanes.example"})
    client = TestClient(create_app(public, database_url), base_url="https://lanes.example")
    assert client.get("/healthz").headers["strict-transport-security"].startswith("max-age=")


@pytest.mark.parametrize(
    ("path", "caching"),
    [
        ("/assets/index-1a2b.js", "public, max-age=31536000, immutable"),
        ("/", "no-cache"),
        ("/tasks/7", "no-cache"),
        ("/api/v1/session", "no-store"),
        ("/api/v1/nothing", "no-store"),
    ],
)
def test_only_hashed_files_are_kept_for_good(anonymous: TestClient, path: str, caching: str) -> None:
    assert anonymous.get(path).headers["cache-control"] == caching


def test_addresses_of_the_page_give_the_page(anonymous: TestClient) -> None:
    for path in ("/", "/tasks/7?element=11", "/review", "/apiary"):
        answer = anonymous.get(path)
        assert (answer.status_code, answer.headers["content-type"]) == (200, "text/html; charset=utf-8")
        assert "<title>Lanewright</title>" in answer.text


@pytest.mark.parametrize(
    ("method", "path", "status"),
    [
        ("GET", "/api/v1/nothing", 404),
        ("GET", "/api", 404),
        ("GET", "/assets/old-build.js", 404),
        ("PUT", "/api/v1/tasks", 405),
        ("GET", "/api/v1/tasks/1/steps", 405),
        ("POST", "/tasks", 405),
        ("GET", "/docs/secret.txt", 422),
    ],
)
def test_addresses_of_nothing_are_problems(anonymous: TestClient, method: str, path: str, status: int) -> None:
    answer = anonymous.request(method, path)
    assert answer.status_code == status
    assert {"code", "message", "mend", "request_id"} <= set(answer.json())
    assert ("allow" in answer.headers) == (status == 405)


@pytest.mark.parametrize(
    "path", ["/..%2f..%2fsecret.txt", "/%2e%2e/secret.txt", "/assets/..%2f..%2f..%2fsecret.txt", "//secret.txt"]
)
def test_no_file_outside_of_the_build_is_served(anonymous: TestClient, settings: Settings, path: str) -> None:
    (settings.frontend.parent / "secret.txt").write_text("secret")
    (settings.frontend.parent.parent / "secret.txt").write_text("secret")
    assert anonymous.get(path).text != "secret"


def test_a_link_out_of_the_build_is_not_followed(anonymous: TestClient, settings: Settings, tmp_path: Path) -> None:
    (tmp_path / "secret.txt").write_text("secret")
    (settings.frontend / "link.txt").symlink_to(tmp_path / "secret.txt")
    assert anonymous.get("/link.txt").text != "secret"


def test_the_documentation_needs_no_other_host_and_no_inline_script(anonymous: TestClient) -> None:
    page = anonymous.get("/docs")
    assert page.status_code == 200
    used = re.findall(r'(?:src|href)="([^"]+)"', page.text)
    assert used
    for address in used:
        assert address.startswith("/docs/")
        assert anonymous.get(address).status_code == 200
    assert not re.search(r"<script(?![^>]*\bsrc=)", page.text)
    assert not re.search(r"\son\w+=", page.text)


def test_the_description_says_how_to_authenticate(anonymous: TestClient) -> None:
    description = anonymous.get("/openapi.json").json()
    assert set(description["components"]["securitySchemes"]) == {"session", "token"}
    export = description["paths"]["/api/v1/export/{split}.tar"]["get"]
    assert "export:read" in export["description"]
    assert "application/x-tar" in export["responses"]["200"]["content"]


def test_only_loopback_names_reach_the_demo(anonymous: TestClient, settings: Settings, database_url: str) -> None:
    refused = anonymous.get("/healthz", headers={"Host": "rebound.example"})
    assert (refused.status_code, refused.json()["code"]) == (400, "request.host")
    for host in ("localhost:8000", "127.0.0.1:8000", "[::1]:8000"):
        assert anonymous.get("/healthz", headers={"Host": host}).status_code == 200
    team = settings.model_copy(update={"database_url": database_url})
    client = TestClient(create_app(team), base_url="http://lanes.internal")
    assert client.get("/healthz").status_code == 200


class TestOversizedBodies:
    """64 KiB are enough for all but drafts and saves; what is larger is refused before it is read to the end."""

    def chunks(self, mebibytes: int) -> Iterator[bytes]:
        for _ in range(mebibytes):
            self.sent += 1
            yield b"[" * 2**20

    @pytest.mark.parametrize("declared", [True, False], ids=["with its length", "chunked"])
    @pytest.mark.parametrize(
        ("path", "mebibytes"), [("/api/v1/session", 1), ("/api/v1/tasks/1/check", 33)], ids=["small", "save"]
    )
    def test_are_refused(
        self, client_for: ClientFor, session: Session, path: str, mebibytes: int, declared: bool
    ) -> None:
        self.sent = 0
        content = b"[" * (mebibytes * 2**20) if declared else self.chunks(mebibytes)
        answer = client_for(Role.ADMIN).post(path, content=content, headers={"Content-Type": "application/json"})
        assert (answer.status_code, answer.json()["code"]) == (413, "request.too_large")
        assert answer.json()["request_id"] == answer.headers["x-request-id"]

    def test_a_large_save_is_read(self, client_for: ClientFor) -> None:
        body = {"base_revision": 0, "edits": [], "note": "x" * 2**20}
        answer = client_for(Role.ADMIN).post("/api/v1/tasks/1/check", json=body)
        assert answer.status_code == 422
        assert "note" in answer.json()["message"]


def test_a_wrong_value_is_named_by_its_place(client_for: ClientFor) -> None:
    point = {"x": 1.0, "y": 2.0, "z": 3.0}
    good = {"operation": "delete", "kind": "lane_segment", "id": 11}
    line = [point, point, point | {"x": True}]
    bad = {"operation": "update", "kind": "lane_segment", "id": 12, "attributes": {"left_lane_boundary": line}}
    body = {"base_revision": 0, "edits": [good, good, good, bad]}
    answer = client_for(Role.ADMIN).post("/api/v1/tasks/1/check", json=body)
    assert answer.status_code == 422
    assert answer.json()["message"].startswith("edits[3].attributes.left_lane_boundary[2].x: ")
    assert answer.json()["mend"]
    assert answer.json()["facts"]["errors"][0]["where"] == "edits[3].attributes.left_lane_boundary[2].x"
