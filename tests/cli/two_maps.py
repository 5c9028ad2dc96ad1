"""The commands that compare maps, run in this process, and maps for them."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

from typer.testing import CliRunner, Result

from lanewright.cli.main import app

FIXTURES = Path(__file__).parents[1] / "fixtures" / "bijective"
Map = dict[str, Any]


def lanewright(*arguments: str | Path) -> Result:
    """The command as it ran; an exception that got out of it fails the test."""
    return CliRunner().invoke(app, [str(argument) for argument in arguments], catch_exceptions=False)


def fixture(name: str) -> Path:
    """A file that holds both maps."""
    return FIXTURES / f"{name}.json"


def expected(name: str) -> dict[str, Any]:
    document: dict[str, Any] = json.loads(fixture(name).read_text())
    return document


def two_files(folder: Path, name: str, spoil: Callable[[Map, Map], None] = lambda base, edited: None) -> list[Path]:
    """The maps of a fixture as two files, spoilt on the way."""
    document = expected(name)
    spoil(document["base"], document["edited"])
    paths = []
    for side in ("base", "edited"):
        path = folder / f"{side}.json"
        path.write_text(json.dumps(document[side]))
        paths.append(path)
    return paths
