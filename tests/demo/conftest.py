"""Three demo logs, written once for all tests here."""

from __future__ import annotations

from pathlib import Path

import pytest

from lanewright.demo import DemoLog, generate

SEED = 7


@pytest.fixture(scope="package")
def demo_folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("demo")


@pytest.fixture(scope="package")
def logs(demo_folder: Path) -> list[DemoLog]:
    return generate(SEED, demo_folder)
