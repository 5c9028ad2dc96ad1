"""Brings a database to the tables that this code expects."""

from __future__ import annotations

from functools import lru_cache

from alembic import command
from alembic.config import Config
from alembic.script import ScriptDirectory
from sqlalchemy import text
from sqlalchemy.exc import DBAPIError

from lanewright.core.errors import LanewrightError
from lanewright.db.engine import engine_for, transaction
from lanewright.settings import REPOSITORY

EXTENSIONS = ("postgis", "btree_gist")


class MissingExtension(LanewrightError):
    """The database server lacks an extension, or its user may not create it."""

    code = "database.extension"


def migrate(url: str) -> None:
    """Applies the migrations that are missing; nothing when there are none. Concurrent calls wait for each other.

    Raises:
        MissingExtension: PostGIS or btree_gist cannot be had.
    """
    _ensure_extensions(url)
    config = _config()
    config.attributes["url"] = url
    command.upgrade(config, "head")


def pending(url: str) -> bool:
    """Whether the database lacks a migration that this code knows."""
    with engine_for(url).connect() as connection:
        known = connection.execute(text("SELECT to_regclass('alembic_version') IS NOT NULL")).scalar_one()
        applied = connection.execute(text("SELECT version_num FROM alembic_version")).scalars().all() if known else ()
    return set(applied) != _heads()


def _ensure_extensions(url: str) -> None:
    for name in EXTENSIONS:
        with transaction(url) as session:
            if session.scalar(text("SELECT true FROM pg_extension WHERE extname = :name"), {"name": name}):
                continue
            try:
                session.execute(text(f"CREATE EXTENSION IF NOT EXISTS {name}"))
            except DBAPIError as error:
                raise MissingExtension(
                    f"The database has no extension {name}, and it cannot be made: {error.orig}.",
                    mend=f"Install it on the database server, then run there as a superuser: CREATE EXTENSION {name};",
                ) from error


@lru_cache(maxsize=1)
def _heads() -> frozenset[str]:
    return frozenset(ScriptDirectory.from_config(_config()).get_heads())


def _config() -> Config:
    return Config(str(REPOSITORY / "alembic.ini"))
