"""The archive of a split: what is in it, and that the official library loads it."""

from __future__ import annotations

import contextlib
import hashlib
import io
import json
import tarfile
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import anyio
import pytest
from fastapi import FastAPI
from sqlalchemy.orm import Session
from starlette.testclient import TestClient
from tests.api.conftest import AddAccount, ClientFor
from tests.stored_logs import add_log, change_task, small_map

from lanewright.api.routes.export import get_snapshots
from lanewright.core.elements import ElementKey, ElementKind, MapState, Mark
from lanewright.core.workflow import Role
from lanewright.db.models import Account, Log, Task
from lanewright.db.repositories import elements, logs
from lanewright.services import tasks
from lanewright.services.actor import Actor

LANE_11 = ElementKey(ElementKind.LANE_SEGMENT, 11)
EXPORT = "/api/v1/export/{}.tar"


@pytest.fixture
def admin(add_account: AddAccount) -> Account:
    return add_account(Role.ADMIN)


@pytest.fixture
def exporter(app: FastAPI, session: Session, client_for: ClientFor, admin: Account) -> TestClient:
    """An admin's client whose exports see the test's transaction."""

    @contextlib.contextmanager
    def inside_the_test() -> Iterator[Session]:
        session.flush()
        yield session

    app.dependency_overrides[get_snapshots] = lambda: inside_the_test
    return client_for(admin)


def accept(session: Session, task_id: int, revision: int) -> None:
    task = session.get_one(Task, task_id)
    task.state, task.accepted_revision = "accepted", revision
    session.flush()


def add_task(session: Session, admin: Account, log: Log, direction: str | None = None) -> int:
    actor = Actor(admin.id, admin.name, Role.ADMIN)
    return tasks.create(session, actor, log_id=log.log_id, direction=direction, assignee_id=None).id  # type: ignore[arg-type]


def repaint(state: MapState) -> MapState:
    """Lane 11's right side painted, the crossing gone."""
    lane = replace(state.lanes[11], right_mark=Mark.SOLID_WHITE)
    return MapState.of([lane, state.lanes[12]])


def unpacked(client: TestClient, split: str = "train", **headers: str) -> dict[str, bytes]:
    answer = client.get(EXPORT.format(split), headers=headers)
    assert answer.status_code == 200, answer.text
    assert answer.headers["content-type"] == "application/x-tar"
    with tarfile.open(fileobj=io.BytesIO(answer.content)) as archive:
        return {m.name: archive.extractfile(m).read() for m in archive.getmembers()}  # type: ignore[union-attr]


@pytest.mark.parametrize(
    ("direction", "edited_side", "categories"),
    [("prior_to_current", "current", "deletion"), ("current_to_prior", "prior", "insertion")],
)
def test_both_sides_and_the_changes_from_prior_to_current(
    exporter: TestClient, session: Session, admin: Account, direction: str, edited_side: str, categories: str
) -> None:
    text = json.dumps(small_map(), indent=3)
    log = add_log(session, "log-one", direction=direction, text=text)
    task_id = add_task(session, admin, log)
    change_task(session, task_id, repaint)
    accept(session, task_id, 1)
    change_task(session, task_id, lambda state: MapState.of([state.lanes[11]]))  # after acceptance: not exported
    files = unpacked(exporter)
    name = log.map_file_name
    base_side = "prior" if edited_side == "current" else "current"
    assert files[f"{base_side}/log-one/map/{name}"] == text.encode(), "the base is the file as imported, to the byte"
    edited = json.loads(files[f"{edited_side}/log-one/map/{name}"])
    expected = small_map()
    expected["lane_segments"]["11"]["right_lane_mark_type"] = "SOLID_WHITE"
    expected["pedestrian_crossings"] = {}
    assert edited == expected
    changes = json.loads(files["changes/log-one.json"])["changes"]
    assert [(c["id"], c["categories"]) for c in changes] == [(11, ["marking"]), (21, [categories])]
    marking = changes[0]
    before, after = ("NONE", "SOLID_WHITE") if edited_side == "current" else ("SOLID_WHITE", "NONE")
    assert marking["old"] == {"right_lane_mark_type": before}
    assert marking["new"] == {"right_lane_mark_type": after}


def test_the_manifest_names_every_file_with_its_hash(exporter: TestClient, session: Session, admin: Account) -> None:
    log = add_log(session)
    task_id = add_task(session, admin, log)
    accept(session, task_id, 0)
    files = unpacked(exporter)
    assert list(files)[-1] == "manifest.json"
    manifest = json.loads(files.pop("manifest.json"))
    assert (manifest["schema_version"], manifest["split"]) == (1, "train")
    (entry,) = manifest["logs"]
    assert (entry["log_id"], entry["task"], entry["revision"]) == ("log-one", task_id, 0)
    assert entry["direction"] == "current_to_prior"
    listed = {file["path"]: (file["bytes"], file["sha256"]) for file in entry["files"]}
    assert listed == {path: (len(body), hashlib.sha256(body).hexdigest()) for path, body in files.items()}
    assert json.loads(files["sensors/log-one.json"])["frames"]


def test_a_task_without_any_change_gives_the_imported_file_twice(
    exporter: TestClient, session: Session, admin: Account
) -> None:
    log = add_log(session)
    accept(session, add_task(session, admin, log), 0)
    files = unpacked(exporter)
    name = f"log-one/map/{log.map_file_name}"
    assert files[f"prior/{name}"] == files[f"current/{name}"] == bytes(log.map_document)
    assert json.loads(files["changes/log-one.json"]) == {"changes": [], "updates": []}


def test_only_accepted_tasks_of_the_split_count_and_the_newest_speaks_for_its_log(
    exporter: TestClient, session: Session, admin: Account
) -> None:
    for log_id, split in (("log-b", "train"), ("log-a", "train"), ("log-c", "val"), ("log-d", "train")):
        add_log(session, log_id, split=split)
    accepted = {}
    for log_id in ("log-b", "log-a", "log-c"):
        accepted[log_id] = add_task(session, admin, logs.find_log(session, log_id))  # type: ignore[arg-type]
        accept(session, accepted[log_id], 0)
    add_task(session, admin, logs.find_log(session, "log-d"))  # type: ignore[arg-type]
    later = add_task(session, admin, logs.find_log(session, "log-a"))  # type: ignore[arg-type]
    accept(session, later, 0)
    manifest = json.loads(unpacked(exporter)["manifest.json"])
    assert [(e["log_id"], e["task"]) for e in manifest["logs"]] == [("log-a", later), ("log-b", accepted["log-b"])]


def test_two_exports_of_the_same_state_differ_only_in_the_time_of_the_manifest(
    exporter: TestClient, session: Session, admin: Account
) -> None:
    accept(session, add_task(session, admin, add_log(session)), 0)
    first, second = (exporter.get(EXPORT.format("train")).content for _ in range(2))
    assert first == second  # in one transaction the time stands still too


def test_an_empty_split_is_a_valid_archive(exporter: TestClient) -> None:
    files = unpacked(exporter, "test")
    assert list(files) == ["manifest.json"]
    assert json.loads(files["manifest.json"])["logs"] == []


@pytest.mark.parametrize("split", ["all", "Train", "train%00", "..", "train.tar"])
def test_an_unknown_split_is_not_found(exporter: TestClient, split: str) -> None:
    assert exporter.get(EXPORT.format(split)).status_code in (404, 422)


def test_a_pipeline_exports_with_its_token(exporter: TestClient, anonymous: TestClient) -> None:
    made = exporter.post("/api/v1/tokens", json={"name": "nightly", "scopes": ["export:read"]}).json()
    assert list(unpacked(anonymous, Authorization=f"Bearer {made['token']}")) == ["manifest.json"]


def test_the_archive_is_loaded_by_av2_with_its_ground(
    exporter: TestClient, session: Session, admin: Account, tmp_path: Path
) -> None:
    np = pytest.importorskip("numpy")
    map_api = pytest.importorskip("av2.map.map_api", reason="av2 is not installed (requirements-av2.txt)")
    log = add_log(session, direction="prior_to_current")
    raster = io.BytesIO()
    np.save(raster, np.full((60, 90), 1.25, dtype=np.float16))
    logs.insert_asset(session, log.id, "ground.npy", "application/octet-stream", raster.getvalue(), {})
    placement: dict[str, Any] = {"R": [1.0, 0.0, 0.0, 1.0], "t": [2.0, 3.0], "s": 10 / 3}
    logs.insert_asset(session, log.id, "sim2.json", "application/json", json.dumps(placement).encode(), {})
    task_id = add_task(session, admin, log)
    change_task(session, task_id, repaint)
    accept(session, task_id, 1)
    for name, body in unpacked(exporter).items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_bytes(body)
    prior, current = (
        map_api.ArgoverseStaticMap.from_map_dir(tmp_path / side / "log-one" / "map", build_raster=True)
        for side in ("prior", "current")
    )
    assert sorted(prior.vector_pedestrian_crossings) == [21]
    assert sorted(current.vector_pedestrian_crossings) == []
    assert current.vector_lane_segments[11].right_mark_type == "SOLID_WHITE"
    assert current.raster_ground_height_layer.get_ground_height_at_xy(np.array([[5.0, 2.0]]))[0] == 1.25


def test_the_snapshot_of_an_export_reads_and_never_writes(fresh_database: str) -> None:
    from sqlalchemy import text
    from sqlalchemy.exc import InternalError

    from lanewright.db.engine import snapshot, transaction

    with snapshot(fresh_database) as reading:
        assert reading.execute(text("SELECT count(*) FROM account")).scalar_one() == 0
        with transaction(fresh_database) as writing:
            writing.add(Account(name="late", role="admin", password_hash="x"))
        assert reading.execute(text("SELECT count(*) FROM account")).scalar_one() == 0, "one state, to the end"
        with pytest.raises(InternalError, match="read-only"):
            reading.execute(text("DELETE FROM account"))


def test_what_is_exported_is_what_was_stored(session: Session, admin: Account) -> None:
    """The map in the database is the one in the file, bit for bit: an unchanged element keeps its text."""
    log = add_log(session)
    from lanewright.formats.av2_map import parse_map

    document = parse_map(bytes(log.map_document), log.map_file_name)
    assert elements.load(session, log.line_id, 0).state == document.state


def test_a_client_that_goes_away_leaves_no_snapshot_open(
    exporter: TestClient, app: FastAPI, session: Session, admin: Account
) -> None:
    add_task(session, admin, add_log(session))
    is_open: list[bool] = []

    @contextlib.contextmanager
    def watched() -> Iterator[Session]:
        is_open.append(True)
        try:
            yield session
        finally:
            is_open.append(False)

    app.dependency_overrides[get_snapshots] = lambda: watched
    accept(session, session.query(Task).one().id, 0)

    async def go_away_after_the_first_piece() -> None:
        request = exporter.build_request("GET", EXPORT.format("train"))
        scope = {
            "type": "http", "asgi": {"version": "3.0", "spec_version": "2.3"}, "http_version": "1.1", "method": "GET",
            "scheme": "http", "path": request.url.path, "raw_path": request.url.raw_path, "query_string": b"",
            "headers": [(name.lower(), value) for name, value in request.headers.raw], "client": ("127.0.0.1", 1),
            "server": ("127.0.0.1", 80), "root_path": "",
        }  # fmt: skip
        gone = anyio.Event()
        asked = False

        async def receive() -> dict[str, Any]:
            nonlocal asked
            if not asked:
                asked = True
                return {"type": "http.request", "body": b"", "more_body": False}
            await gone.wait()
            return {"type": "http.disconnect"}

        async def send(message: Any) -> None:
            if message["type"] == "http.response.body" and message["body"]:
                gone.set()
                await anyio.sleep_forever()  # nobody reads any more

        await app(scope, receive, send)

    anyio.run(go_away_after_the_first_piece)
    assert is_open == [True, False]
