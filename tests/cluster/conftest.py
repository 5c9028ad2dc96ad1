"""Homes for private clusters, with what a test started stopped again."""

from __future__ import annotations

import shutil
import tempfile
from collections.abc import Callable, Iterator
from pathlib import Path

import psycopg
import pytest

from lanewright.cluster import PrivateCluster


@pytest.fixture
def home() -> Iterator[Path]:
    """A folder that root's stand-in account can reach, as in an ordinary checkout."""
    folder = Path(tempfile.mkdtemp(prefix="lanewright-cluster-"))
    folder.chmod(0o711)
    yield folder / "home"
    shutil.rmtree(folder, ignore_errors=True)


@pytest.fixture(scope="session")
def stopped_cluster(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A whole cluster's folder: a copy of it saves the tests that are about something else from making one."""
    cluster = PrivateCluster(tmp_path_factory.mktemp("cluster"), durable=False)
    cluster.up()
    cluster.down()
    return cluster.folder


@pytest.fixture
def make_cluster(stopped_cluster: Path) -> Iterator[Callable[..., PrivateCluster]]:
    """Makes clusters that are stopped when the test ends; ``new``: from nothing, not from a copy."""
    made: list[PrivateCluster] = []

    def make(home: Path, *, durable: bool = False, new: bool = False) -> PrivateCluster:
        cluster = PrivateCluster(home, durable=durable)
        if not new and not cluster.data.exists():
            shutil.copytree(stopped_cluster / "data", cluster.data)
        made.append(cluster)
        return cluster

    yield make
    for cluster in made:
        cluster.down()


@pytest.fixture
def ask() -> Callable[[str, str], object]:
    """The single value that a statement gives, if any."""

    def ask(url: str, query: str) -> object:
        with psycopg.connect(url, autocommit=True) as connection:
            cursor = connection.execute(query)
            row = cursor.fetchone() if cursor.description else None
            return row[0] if row else None

    return ask
