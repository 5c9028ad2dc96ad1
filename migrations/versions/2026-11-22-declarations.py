"""Declared macros beside revisions and drafts; what a saved draft leaves behind

Revision ID: 0003
Revises: 0002
"""

from __future__ import annotations

import sqlalchemy as sa
from alembic import op
from sqlalchemy.dialects.postgresql import JSONB

revision = "0003"
down_revision = "0002"
branch_labels = None
depends_on = None


def upgrade() -> None:
    for table in ("revision", "draft"):
        op.add_column(table, sa.Column("declarations", JSONB(), server_default=sa.text("'[]'"), nullable=False))
    op.add_column("draft", sa.Column("saved_as", sa.Integer(), nullable=True))


def downgrade() -> None:
    raise RuntimeError("restore a backup instead: dropping the columns would lose declarations")
