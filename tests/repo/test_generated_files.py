"""What programs made from the sources is what they would make today."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

from typer.testing import CliRunner

from lanewright.cli.main import app
from lanewright.db.migration import pending

REPOSITORY = Path(__file__).resolve().parents[2]
MEND = "Run make types, and commit what it changes."


def test_openapi_description_is_the_one_of_the_sources():
    printed = CliRunner().invoke(app, ["openapi"])
    assert printed.exit_code == 0, printed.output
    assert json.loads((REPOSITORY / "frontend" / "openapi.json").read_text()) == json.loads(printed.stdout), MEND


def test_frontend_types_are_those_of_the_openapi_description(tmp_path: Path):
    made = tmp_path / "schema.gen.ts"
    command = [
        "node_modules/.bin/openapi-typescript",
        "openapi.json",
        "--default-non-nullable=false",
        "-o",
        str(made),
    ]
    # Where the system has no Node.js, the one beside Python serves.
    path = f"{os.environ['PATH']}{os.pathsep}{Path(sys.executable).parent}"
    subprocess.run(
        command, cwd=REPOSITORY / "frontend", env={**os.environ, "PATH": path}, check=True, capture_output=True
    )
    assert made.read_text() == (REPOSITORY / "frontend" / "src" / "api" / "schema.gen.ts").read_text(), MEND


def test_tables_of_the_models_are_those_of_the_migrations(database_url: str):
    assert not pending(database_url)
    command = [sys.executable, "-m", "alembic", "check"]
    checked = subprocess.run(
        command,
        cwd=REPOSITORY,
        env={"DATABASE_URL": database_url, "PATH": "/usr/bin:/bin"},
        capture_output=True,
        text=True,
    )
    assert checked.returncode == 0, checked.stdout + checked.stderr
