"""The migrations make the tables that the models say."""

from __future__ import annotations

from alembic.autogenerate import compare_metadata
from alembic.migration import MigrationContext
from geoalchemy2 import alembic_helpers
from sqlalchemy import CheckConstraint, text
from sqlalchemy.orm import Session

from lanewright.db.models import Base


def ours(thing: object, name: str | None, kind: str, reflected: bool, compared: object) -> bool:
    """Neither the job queue's tables nor PostGIS's own."""
    if reflected and name is not None and "procrastinate" in name:
        return False
    table = getattr(getattr(thing, "table", None), "name", "")
    return "procrastinate" not in table and bool(alembic_helpers.include_object(thing, name, kind, reflected, compared))


def test_models_and_migrations_say_the_same(session: Session) -> None:
    context = MigrationContext.configure(
        session.connection(), opts={"target_metadata": Base.metadata, "include_object": ours}
    )
    assert compare_metadata(context, Base.metadata) == []


def test_every_check_constraint_is_in_the_database(session: Session) -> None:
    """Alembic does not compare these."""
    written = {
        (table.name, constraint.name)
        for table in Base.metadata.sorted_tables
        for constraint in table.constraints
        if isinstance(constraint, CheckConstraint)
    }
    found = session.execute(
        text("SELECT conrelid::regclass::text, conname FROM pg_constraint WHERE contype = 'c' AND conname LIKE 'ck_%'")
    )
    named = {(table, f"ck_{table}_{name}" if not str(name).startswith("ck_") else str(name)) for table, name in written}
    assert named == set(map(tuple, found))


def test_sequences_are_there(session: Session) -> None:
    assert session.execute(text("SELECT to_regclass('draft_version') IS NOT NULL")).scalar_one()
