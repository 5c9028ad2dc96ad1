"""Brings a database to the tables that this code expects."""

from __future__ import annotations

from alembic import command
from alembic.config import Config
from alembic.script import ScriptDirectory
from sqlalchemy import text

from lanewright.db.engine import engine_for
from lanewright.settings import REPOSITORY


def migrate(url: str) -> None:
    """Applies the migrations that are missing; nothing when there are none. Concurrent calls wait for each other."""
    command.upgrade(_config(url), "head")


def pending(url: str) -> bool:
    """Whether the database lacks a migration that this code knows."""
    with engine_for(url).connect() as connection:
        known = connection.execute(text("SELECT to_regclass('alembic_version') IS NOT NULL")).scalar_one()
        applied = connection.execute(text("SELECT version_num FROM alembic_version")).scalars().all() if known else ()
    return set(applied) != set(ScriptDirectory.from_config(_config(url)).get_heads())


def _config(url: str) -> Config:
    config = Config(str(REPOSITORY / "alembic.ini"))
    config.attributes["url"] = url
    return config
