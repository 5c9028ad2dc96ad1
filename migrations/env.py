"""Alembic's entry: runs the migrations on the database it is given, one process at a time."""

from __future__ import annotations

from alembic import context
from geoalchemy2 import alembic_helpers
from sqlalchemy import create_engine, text

from lanewright.cluster import PrivateCluster
from lanewright.db.models import Base
from lanewright.settings import get_settings

# Any fixed number: whoever else migrates this database waits, and then finds nothing left to do.
MIGRATION_LOCK = 7_203_511


def database_url() -> str:
    given = context.config.attributes.get("url")
    if given:
        return str(given)
    settings = get_settings()
    return settings.database_url or PrivateCluster(settings.home).up()


def include_object(thing: object, name: str | None, kind: str, reflected: bool, compared: object) -> bool:
    """Procrastinate's tables come from its own SQL, PostGIS's from its extension: neither is in our metadata."""
    if reflected and name is not None and name.startswith("procrastinate_"):
        return False
    return bool(alembic_helpers.include_object(thing, name, kind, reflected, compared))


def run() -> None:
    engine = create_engine(database_url().replace("postgresql://", "postgresql+psycopg://", 1))
    with engine.connect() as connection, connection.begin():
        connection.execute(text("SELECT pg_advisory_xact_lock(:key)"), {"key": MIGRATION_LOCK})
        context.configure(
            connection=connection,
            target_metadata=Base.metadata,
            include_object=include_object,
            process_revision_directives=alembic_helpers.writer,
            render_item=alembic_helpers.render_item,
            transaction_per_migration=False,
        )
        context.run_migrations()
    engine.dispose()


run()
