"""``lanewright user``, ``token`` and ``export`` as people run them."""

from __future__ import annotations

import hashlib
import json
import tarfile
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from tests.stored_logs import add_log
from typer.testing import CliRunner, Result

from lanewright.cli.main import app
from lanewright.core.workflow import Role
from lanewright.db.engine import transaction
from lanewright.db.models import Task
from lanewright.services import accounts, sessions, tasks
from lanewright.services.passwords import password_holds
from lanewright.settings import get_settings

Run = Callable[..., Result]


@pytest.fixture
def run(fresh_database: str, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Iterator[Run]:
    """The command line on a database of its own."""
    monkeypatch.setenv("DATABASE_URL", fresh_database)
    monkeypatch.setenv("LANEWRIGHT_HOME", str(tmp_path / "home"))
    get_settings.cache_clear()
    yield lambda *arguments, **options: CliRunner().invoke(app, list(arguments), **options)
    get_settings.cache_clear()


def password_of(url: str, name: str, password: str) -> bool:
    with transaction(url) as session:
        return password_holds(password, accounts.by_name(session, name).password_hash)


def test_a_person_from_first_to_last_day(run: Run, fresh_database: str) -> None:
    added = run("user", "add", "rita", "--role", "reviewer")
    assert added.exit_code == 0, added.output
    password = added.output.split()[-1]
    assert password_of(fresh_database, "RITA", password)
    assert "rita\treviewer\tenabled" in run("user", "list").output
    reset = run("user", "reset", "Rita").output.split()[-1]
    assert reset != password
    assert password_of(fresh_database, "rita", reset)
    assert run("user", "reset", "rita", "--ask", input="typed by rita\n").exit_code == 0
    assert password_of(fresh_database, "rita", "typed by rita")
    assert run("user", "disable", "rita").exit_code == 0
    assert "rita\treviewer\tdisabled" in run("user", "list").output
    assert run("user", "enable", "rita").exit_code == 0
    assert "rita\treviewer\tenabled" in run("user", "list").output


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("user", "add", "rita"), "exists"),
        (("user", "add", "with space"), "with space"),
        (("user", "disable", "nobody"), "nobody"),
        (("user", "add", "ben", "--ask"), "password"),
        (("token", "create", "nobody", "--name", "ci", "--scope", "export:read"), "nobody"),
        (("token", "create", "rita", "--name", "ci", "--scope", "export:read"), "annotators"),
        (("token", "revoke", "rita", "7"), "7"),
    ],
)
def test_what_cannot_be_done_is_told_in_a_sentence(run: Run, arguments: tuple[str, ...], words: str) -> None:
    run("user", "add", "rita")
    refused = run(*arguments, input="short\n")
    assert refused.exit_code == 2
    assert refused.stderr.startswith("lanewright: ")
    assert words in refused.stderr
    assert "Traceback" not in refused.output


def test_tokens_are_made_listed_and_revoked(run: Run) -> None:
    run("user", "add", "rita", "--role", "reviewer")
    made = run("token", "create", "rita", "--name", "nightly", "--scope", "export:read", "--scope", "changes:read")
    assert made.output.startswith("lanewright_")
    listed = run("token", "list", "rita").output
    assert made.output.strip() not in listed
    assert "nightly\tchanges:read, export:read\tuntil " in listed
    number = listed.split("\t")[0]
    assert run("token", "revoke", "rita", number).exit_code == 0
    assert "revoked" in run("token", "list", "rita").output


def test_a_split_is_written_as_one_file(run: Run, fresh_database: str, tmp_path: Path) -> None:
    with transaction(fresh_database) as session:
        admin = accounts.add(session, name="admin", role=Role.ADMIN, password="a long password")
        add_log(session)
        made = tasks.create(session, sessions.actor_of(admin), log_id="log-one", direction=None, assignee_id=None)
        task = session.get_one(Task, made.id)
        task.state, task.accepted_revision = "accepted", 0
    file = tmp_path / "train.tar"
    assert run("export", "train", str(file)).exit_code == 0
    with tarfile.open(file) as archive:
        files = {member.name: archive.extractfile(member).read() for member in archive}  # type: ignore[union-attr]
    listed = json.loads(files["manifest.json"])["logs"][0]["files"]
    assert all(hashlib.sha256(files[entry["path"]]).hexdigest() == entry["sha256"] for entry in listed)
    assert not list(tmp_path.glob("*.partial"))
    refused = run("export", "train", str(tmp_path / "missing" / "train.tar"))
    assert refused.exit_code == 2
    assert "missing" in refused.stderr
    assert run("export", "holdout", str(file)).exit_code == 2
