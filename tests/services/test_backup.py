"""Backup and restore: what comes back is what was there, and a bad file changes nothing."""

from __future__ import annotations

import stat
import uuid
from collections.abc import Iterator
from pathlib import Path

import psycopg
import pytest
from sqlalchemy import Text, cast, delete, select, text, update
from sqlalchemy.engine import make_url
from tests.stored_logs import add_log, change_task, cut_in_two

from lanewright.core.elements import MapState
from lanewright.core.errors import Conflict, InvalidInput
from lanewright.core.workflow import Role
from lanewright.db.engine import engine_for, transaction
from lanewright.db.models import Account, ElementVersion, Revision
from lanewright.services import accounts, sessions, tasks
from lanewright.services.backup import backup, restore

VERSION = ElementVersion
CONTENTS = {
    "elements": select(VERSION.line_id, VERSION.element_id, VERSION.rev_from, VERSION.sha256),
    "attributes": select(cast(VERSION.attributes, Text)),
    "revisions": select(Revision.line_id, Revision.number, Revision.content_sha256, cast(Revision.declarations, Text)),
    "people": select(Account.id, Account.name, Account.password_hash),
    "geometry": text("SELECT ST_AsEWKB(geom) FROM element_version ORDER BY 1"),
}


def contents(url: str) -> dict[str, list[tuple[object, ...]]]:
    with transaction(url) as session:
        return {name: sorted(map(tuple, session.execute(query))) for name, query in CONTENTS.items()}


@pytest.fixture
def used_database(fresh_database: str) -> str:
    """A database with a log, an admin, and a task: a crossing deleted, then a lane cut, with declared macros."""
    with transaction(fresh_database) as session:
        admin = accounts.add(session, name="admin", role=Role.ADMIN, password="a long password")
        add_log(session)
        task = tasks.create(session, sessions.actor_of(admin), log_id="log-one", direction=None, assignee_id=admin.id)
        change_task(session, task.id, lambda state: MapState.of(state.lanes.values()))
        change_task(session, task.id, lambda state: cut_in_two(state, 11, 1000))
        session.execute(update(Revision).where(Revision.number == 2).values(declarations=["kept as it is"]))
    return fresh_database


@pytest.fixture
def empty_database(template_url: str) -> Iterator[str]:
    """A database without any table, as a new server has it."""
    name = f"empty_{uuid.uuid4().hex[:12]}"
    url = make_url(template_url).set(database=name).render_as_string()
    with psycopg.connect(make_url(template_url).set(database="postgres").render_as_string(), autocommit=True) as server:
        server.execute(f"CREATE DATABASE {name}")
        yield url
        engine_for(url).dispose()
        server.execute(f"DROP DATABASE {name} WITH (FORCE)")


def test_a_backup_comes_back_in_an_empty_database(used_database: str, empty_database: str, tmp_path: Path) -> None:
    file = tmp_path / "lanewright.backup"
    size = backup(used_database, file)
    assert size == file.stat().st_size > 0
    assert stat.S_IMODE(file.stat().st_mode) == 0o600, "password hashes are in it"
    assert list(tmp_path.iterdir()) == [file]
    restore(empty_database, file, force=False)
    before, after = contents(used_database), contents(empty_database)
    assert len(before["elements"]) == 9
    assert after == before
    with transaction(empty_database) as session:  # identities go on where they were
        added = accounts.add(session, name="next", role=Role.ADMIN, password="a long password")
        assert added.id > before["people"][0][0]


def test_a_database_in_use_is_replaced_only_by_force(used_database: str, tmp_path: Path) -> None:
    file = tmp_path / "lanewright.backup"
    backup(used_database, file)
    before = contents(used_database)
    with transaction(used_database) as session:
        session.execute(delete(ElementVersion).where(ElementVersion.rev_from == 0))
        accounts.add(session, name="later", role=Role.ANNOTATOR, password="a long password")
        session.execute(text("CREATE TABLE of_a_newer_version (id bigint REFERENCES account)"))
    with pytest.raises(Conflict) as refused:
        restore(used_database, file, force=False)
    assert "--force" in refused.value.mend
    restore(used_database, file, force=True)
    assert contents(used_database) == before


@pytest.mark.parametrize("damage", ["no backup", "cut short", "missing"])
def test_a_broken_file_changes_nothing(used_database: str, tmp_path: Path, damage: str) -> None:
    file = tmp_path / "lanewright.backup"
    backup(used_database, file)
    before = contents(used_database)
    if damage == "missing":
        file.unlink()
    else:
        whole = file.read_bytes()
        file.write_bytes(b"no backup" if damage == "no backup" else whole[: len(whole) - 2000])
    with pytest.raises(InvalidInput, match=r"lanewright\.backup"):
        restore(used_database, file, force=True)
    assert contents(used_database) == before


def test_a_file_that_cannot_be_written_is_named(used_database: str, tmp_path: Path) -> None:
    with pytest.raises(InvalidInput, match="missing"):
        backup(used_database, tmp_path / "missing" / "lanewright.backup")
