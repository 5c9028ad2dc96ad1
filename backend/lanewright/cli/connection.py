"""The database that a command works on."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import psycopg

from lanewright.cluster import ClusterError, PrivateCluster
from lanewright.settings import get_settings


@contextmanager
def database(*, migrated: bool = True) -> Iterator[str]:
    """The URL of ``DATABASE_URL``, or of the private cluster, which runs at least as long as the block.

    Args:
        migrated: bring the tables to this version first.

    Raises:
        ClusterError: the database cannot be reached.
    """
    settings = get_settings()
    if settings.database_url is None:
        with PrivateCluster(settings.home).lease() as url:
            _prepare(url, migrated)
            yield url
    else:
        try:
            psycopg.connect(settings.database_url, connect_timeout=10).close()
        except psycopg.OperationalError as error:
            reason = str(error).strip().splitlines()[0]
            raise ClusterError(
                f"The database of DATABASE_URL does not answer: {reason}",
                mend="Start it, correct DATABASE_URL, or unset it to use the private cluster.",
            ) from error
        _prepare(settings.database_url, migrated)
        yield settings.database_url


def _prepare(url: str, migrated: bool) -> None:
    if migrated:
        from lanewright.db.migration import migrate

        migrate(url)
