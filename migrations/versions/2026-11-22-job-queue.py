"""The job queue's tables (procrastinate 3.10.0)

Revision ID: 0002
Revises: 0001
"""

from __future__ import annotations

from pathlib import Path

from alembic import op

revision = "0002"
down_revision = "0001"
branch_labels = None
depends_on = None

SCHEMA = Path(__file__).resolve().parents[1] / "procrastinate-3.10.0.sql"


def upgrade() -> None:
    # On the driver's connection: many statements at once, whose percent signs and colons mean themselves.
    connection = op.get_bind().connection.driver_connection
    connection.execute(SCHEMA.read_text())


def downgrade() -> None:
    raise RuntimeError("restore a backup instead: dropping the queue would lose jobs")
