"""What a person at the command line sees when it works, and when it does not."""

from __future__ import annotations

import re
import sys
import types

import pytest
import typer
from tests.cli.command import Lanewright
from typer.testing import CliRunner

from lanewright import __version__
from lanewright.cli.main import COMMANDS, app
from lanewright.core.errors import NotFound
from lanewright.settings import get_settings


@pytest.fixture
def broken(monkeypatch, tmp_path):
    """Puts a command called ``broken`` into the table that raises what it is given."""

    def put(error: BaseException) -> None:
        part = typer.Typer()

        @part.command()
        def broken() -> None:
            raise error

        module = types.ModuleType("lanewright.cli.broken")
        module.app = part
        module.__spec__ = types.SimpleNamespace()
        monkeypatch.setitem(sys.modules, module.__name__, module)
        monkeypatch.setitem(COMMANDS, "broken", (module.__name__, "Fails."))

    monkeypatch.setenv("LANEWRIGHT_HOME", str(tmp_path))
    get_settings.cache_clear()
    yield put
    get_settings.cache_clear()


def test_help_lists_every_command_without_importing_any(command: Lanewright):
    listed = command.run("--help").stdout
    assert all(re.search(rf"^  {name} ", listed, re.MULTILINE) for name in COMMANDS)
    script = "import sys; sys.argv = ['lanewright', '--help']; import lanewright.cli.main as m\n"
    script += "try: m.app()\nexcept SystemExit: pass\nprint([n for n in sys.modules if n.startswith('sqlalchemy')])"
    assert command.python(script).stdout.endswith("[]\n")


def test_every_command_has_help():
    for name in COMMANDS:
        asked = CliRunner().invoke(app, [name, "--help"])
        assert asked.exit_code == 0, (name, asked.output)


def test_version():
    assert CliRunner().invoke(app, ["--version"]).output == f"lanewright {__version__}\n"


def test_domain_error_is_one_sentence_with_its_mend(broken):
    broken(NotFound("There is no log x.", mend="Import it."))
    ended = CliRunner().invoke(app, ["broken"])
    assert ended.exit_code == 2
    assert ended.stderr == "lanewright: There is no log x. Import it.\n"


def test_unexpected_error_is_one_sentence_that_names_the_log_with_the_trace(broken, tmp_path):
    broken(ZeroDivisionError("division by zero"))
    ended = CliRunner().invoke(app, ["broken"])
    assert ended.exit_code == 2
    assert ended.stderr.count("\n") == 1
    assert "ZeroDivisionError: division by zero" in ended.stderr
    assert "Traceback" not in ended.stderr
    log = tmp_path / "logs" / "errors.log"
    assert str(log) in ended.stderr
    assert "Traceback" in log.read_text()


def test_unreachable_database_is_named(command: Lanewright):
    ended = command.run("migrate", DATABASE_URL=f"postgresql://127.0.0.1:{command.port}/none")
    assert ended.returncode == 2
    assert "The database of DATABASE_URL does not answer: " in ended.stderr
    assert ended.stderr.count("\n") == 1


def test_wrong_setting_is_named(command: Lanewright):
    ended = command.run("db", "url", LANEWRIGHT_PORT="many")
    assert ended.returncode == 2
    assert ended.stderr.startswith("lanewright: LANEWRIGHT_PORT: ")
    ended = command.run("db", "url", DATABASE_URL="mysql://somewhere")
    assert ended.stderr.startswith("lanewright: DATABASE_URL: ")
    assert "postgresql://" in ended.stderr


def test_database_goes_up_answers_and_goes_down(command: Lanewright):
    up = command.run("db", "up")
    assert up.returncode == 0, up.stderr
    assert command.run("db", "url").stdout == up.stdout
    assert command.run("migrate").returncode == 0
    asked = command.run("db", "psql", "-Atc", "SELECT count(*) FROM account")
    assert asked.stdout == "0\n"
    assert command.run("db", "down").stdout == "The private cluster has stopped.\n"
    assert command.run("db", "url").returncode == 2
    assert command.processes() == []
