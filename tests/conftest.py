"""What every test can ask for: a real PostGIS database of its own, and the real logs where they are at hand."""

from __future__ import annotations

import contextlib
import fcntl
import shutil
import tempfile
import time
import uuid
from collections.abc import Iterator
from pathlib import Path

import hypothesis
import psycopg
import pytest
from sqlalchemy.engine import make_url
from sqlalchemy.orm import Session

from lanewright.cluster import ClusterError, PrivateCluster

REPOSITORY = Path(__file__).resolve().parents[1]
SHARED_DATA = REPOSITORY.parent / "shared" / "data"
HOME_PREFIX = "lanewright-tests-"
TEMPLATE = "lanewright"  # the cluster's own database: migrated once, then only copied

# Machines are shared and noisy: no test may fail for being slow.
hypothesis.settings.register_profile("lanewright", deadline=None)
hypothesis.settings.load_profile("lanewright")


@pytest.fixture(scope="session")
def template_url() -> Iterator[str]:
    """A cluster for this run of the tests, with the migrated database that all others are copies of."""
    from lanewright.db.engine import engine_for
    from lanewright.db.migration import migrate

    _remove_abandoned_homes()
    home = Path(tempfile.mkdtemp(prefix=HOME_PREFIX))
    home.chmod(0o711)  # so that root's stand-in account reaches its cluster
    try:
        with PrivateCluster(home, durable=False).lease() as url:
            migrate(url)
            engine_for(url).dispose()  # a database that somebody is connected to cannot be copied
            yield url
    except ClusterError as error:
        pytest.fail(f"The tests need PostgreSQL with PostGIS: {error}", pytrace=False)
    finally:
        shutil.rmtree(home, ignore_errors=True)


@pytest.fixture(scope="session")
def database_url(template_url: str) -> Iterator[str]:
    """The database that tests with the ``session`` fixture share, each in a transaction that is rolled back."""
    with _copy_of_template(template_url) as url:
        yield url


@pytest.fixture
def fresh_database(template_url: str) -> Iterator[str]:
    """URL of a migrated database for one test that needs real commits; dropped afterwards."""
    with _copy_of_template(template_url) as url:
        yield url


@pytest.fixture
def session(database_url: str) -> Iterator[Session]:
    """A session in a transaction that is rolled back; a commit inside the test only ends a savepoint."""
    from lanewright.db.engine import engine_for

    with engine_for(database_url).connect() as connection, connection.begin() as outer:
        with Session(connection, join_transaction_mode="create_savepoint", expire_on_commit=False) as session:
            yield session
        outer.rollback()


@pytest.fixture(scope="session")
def shared_data() -> Path:
    """The folder with the real logs (``av2/``) and labels (``tbv/``), which are not ours to distribute."""
    if not SHARED_DATA.is_dir():
        pytest.skip("the real logs are not at ../shared/data (they are not part of the repository)")
    return SHARED_DATA


@pytest.fixture(scope="session")
def real_logs(shared_data: Path) -> list[Path]:
    """Folders of the real Argoverse 2 logs, sorted by log id."""
    return sorted(folder for folder in (shared_data / "av2").iterdir() if (folder / "map").is_dir())


@contextlib.contextmanager
def _copy_of_template(template_url: str) -> Iterator[str]:
    from lanewright.db.engine import engine_for

    name = f"test_{uuid.uuid4().hex[:12]}"
    url = make_url(template_url).set(database=name).render_as_string()
    with psycopg.connect(make_url(template_url).set(database="postgres").render_as_string(), autocommit=True) as admin:
        # file_copy: three times faster than a copy through the log, as fsync is off
        admin.execute(f"CREATE DATABASE {name} TEMPLATE {TEMPLATE} STRATEGY file_copy")
        try:
            yield url
        finally:
            engine_for(url).dispose()
            admin.execute(f"DROP DATABASE {name} WITH (FORCE)")


def _remove_abandoned_homes() -> None:
    """A run that was killed leaves its cluster running: stop it, once nobody holds its lease."""
    for home in Path(tempfile.gettempdir()).glob(f"{HOME_PREFIX}*"):
        try:
            if time.time() - home.stat().st_mtime < 600:
                continue
            with (home / "cluster.users").open("a") as users:
                fcntl.flock(users, fcntl.LOCK_EX | fcntl.LOCK_NB)
                PrivateCluster(home).down()
            shutil.rmtree(home, ignore_errors=True)
        except OSError:
            continue  # in use, or another user's
