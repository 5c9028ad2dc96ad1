"""The first tables: people, logs, lines of revisions with their element versions, tasks

Revision ID: 0001
Revises: nothing
"""

from __future__ import annotations

import sqlalchemy as sa
from alembic import op
from geoalchemy2 import Geometry
from sqlalchemy.dialects.postgresql import JSONB

revision = "0001"
down_revision = None
branch_labels = None
depends_on = None


def upgrade() -> None:
    op.create_table(
        "account",
        sa.Column("id", sa.BigInteger(), sa.Identity(always=True), nullable=False),
        sa.Column("name", sa.Text(), nullable=False),
        sa.Column("role", sa.Text(), nullable=False),
        sa.Column("password_hash", sa.Text(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), server_default=sa.text("now()"), nullable=False),
        sa.Column("disabled_at", sa.DateTime(timezone=True), nullable=True),
        sa.CheckConstraint("role IN ('annotator', 'reviewer', 'admin')", name="role"),
        sa.PrimaryKeyConstraint("id", name="pk_account"),
    )
    op.create_index("uq_account_name", "account", [sa.literal_column("lower(name)")], unique=True)
    op.create_table(
        "log",
        sa.Column("id", sa.BigInteger(), sa.Identity(always=True), nullable=False),
        sa.Column("log_id", sa.Text(), nullable=False),
        sa.Column("dataset", sa.Text(), nullable=False),
        sa.Column("city", sa.Text(), nullable=False),
        sa.Column("source_split", sa.Text(), nullable=True),
        sa.Column("release_split", sa.Text(), nullable=False),
        sa.Column("direction", sa.Text(), nullable=False),
        sa.Column("map_file_name", sa.Text(), nullable=False),
        sa.Column("map_document", sa.LargeBinary(), nullable=False),
        sa.Column("map_sha256", sa.LargeBinary(), nullable=False),
        sa.Column("content_sha256", sa.LargeBinary(), nullable=False),
        sa.Column("line_id", sa.BigInteger(), nullable=False),
        sa.Column("next_new_id", sa.BigInteger(), nullable=False),
        sa.Column("last_new_id", sa.BigInteger(), nullable=False),
        sa.Column("summary", JSONB(), nullable=False),
        sa.Column("imported_at", sa.DateTime(timezone=True), server_default=sa.text("now()"), nullable=False),
        sa.CheckConstraint("direction IN ('prior_to_current', 'current_to_prior')", name="direction"),
        sa.CheckConstraint("release_split IN ('train', 'val', 'test')", name="release_split"),
        sa.CheckConstraint("next_new_id <= last_new_id + 1 AND last_new_id <= 2147483647", name="new_ids"),
        sa.PrimaryKeyConstraint("id", name="pk_log"),
        sa.UniqueConstraint("log_id", name="uq_log_log_id"),
    )
    op.create_index("ix_log_city_release_split", "log", ["city", "release_split"], unique=False)
    op.create_table(
        "login_failure",
        sa.Column("id", sa.BigInteger(), sa.Identity(always=True), nullable=False),
        sa.Column("name", sa.Text(), nullable=False),
        sa.Column("address", sa.Text(), nullable=False),
        sa.Column("at", sa.DateTime(timezone=True), server_default=sa.text("now()"), nullable=False),
        sa.PrimaryKeyConstraint("id", name="pk_login_failure"),
    )
    op.create_index("ix_login_failure_address", "login_failure", ["address"], unique=False)
    op.create_index("ix_login_failure_name", "login_failure", ["name"], unique=False)
    op.create_table(
        "account_session",
        sa.Column("token_sha256", sa.LargeBinary(), nullable=False),
        sa.Column("account_id", sa.BigInteger(), nullable=False),
        sa.Column("csrf_token", sa.Text(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), server_default=sa.text("now()"), nullable=False),
        sa.Column("last_seen_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("expires_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(
            ["account_id"], ["account.id"], name="fk_account_session_account_id", ondelete="CASCADE"
        ),
        sa.PrimaryKeyConstraint("token_sha256", name="pk_account_session"),
    )
    op.create_index("ix_account_session_account_id", "account_session", ["account_id"], unique=False)
    op.create_table(
        "api_token",
        sa.Column("id", sa.BigInteger(), sa.Identity(always=True), nullable=False),
        sa.Column("account_id", sa.BigInteger(), nullable=False),
        sa.Column("name", sa.Text(), nullable=False),
        sa.Column("token_sha256", sa.LargeBinary(), nullable=False),
        sa.Column("scopes", sa.ARRAY(sa.Text()), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), server_default=sa.text("now()"), nullable=False),
        sa.Column("expires_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("revoked_at", sa.DateTime(timezone=True), nullable=True),
        sa.Column("last_used_at", sa.DateTime(timezone=True), nullable=True),
        sa.ForeignKeyConstraint(["account_id"], ["account.id"], name="fk_api_token_account_id", ondelete="CASCADE"),
        sa.PrimaryKeyConstraint("id", name="pk_api_token"),
        sa.UniqueConstraint("token_sha256", name="uq_api_token_token_sha256"),
    )
    op.create_index("ix_api_token_account_id", "api_token", ["account_id"], unique=False)
    op.create_table(
        "line",
        sa.Column("id", sa.BigInteger(), sa.Identity(always=True), nullable=False),
        sa.Column("log_id", sa.BigInteger(), nullable=False),
        sa.Column("head", sa.Integer(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), server_default=sa.text("now()"), nullable=False),
        sa.ForeignKeyConstraint(
            ["log_id"], ["log.id"], name="fk_line_log_id", ondelete="CASCADE", initially="DEFERRED", deferrable=True
        ),
        sa.PrimaryKeyConstraint("id", name="pk_line"),
    )
    op.create_foreign_key("fk_log_line_id", "log", "line", ["line_id"], ["id"])
    op.create_index("ix_line_log_id", "line", ["log_id"], unique=False)
    op.create_table(
        "log_asset",
        sa.Column("log_id", sa.BigInteger(), nullable=False),
        sa.Column("name", sa.Text(), nullable=False),
        sa.Column("media_type", sa.Text(), nullable=False),
        sa.Column("body", sa.LargeBinary(), nullable=False),
        sa.Column("sha256", sa.LargeBinary(), nullable=False),
        sa.Column("details", JSONB(), nullable=False),
        sa.ForeignKeyConstraint(["log_id"], ["log.id"], name="fk_log_asset_log_id", ondelete="CASCADE"),
        sa.PrimaryKeyConstraint("log_id", "name", name="pk_log_asset"),
    )
    op.create_table(
        "revision",
        sa.Column("line_id", sa.BigInteger(), nullable=False),
        sa.Column("number", sa.Integer(), autoincrement=False, nullable=False),
        sa.Column("author_id", sa.BigInteger(), nullable=True),
        sa.Column("created_at", sa.DateTime(timezone=True), server_default=sa.text("now()"), nullable=False),
        sa.Column("note", sa.Text(), nullable=False),
        sa.Column("changeset_uuid", sa.Uuid(), nullable=True),
        sa.Column("body_sha256", sa.LargeBinary(), nullable=True),
        sa.Column("answer", sa.LargeBinary(), nullable=True),
        sa.Column("content_sha256", sa.LargeBinary(), nullable=False),
        sa.Column("updates", JSONB(), nullable=False),
        sa.ForeignKeyConstraint(["author_id"], ["account.id"], name="fk_revision_author_id"),
        sa.ForeignKeyConstraint(["line_id"], ["line.id"], name="fk_revision_line_id", ondelete="CASCADE"),
        sa.PrimaryKeyConstraint("line_id", "number", name="pk_revision"),
        sa.UniqueConstraint(
            "line_id", "author_id", "changeset_uuid", name="uq_revision_line_id_author_id_changeset_uuid"
        ),
    )
    op.create_table(
        "task",
        sa.Column("id", sa.BigInteger(), sa.Identity(always=True), nullable=False),
        sa.Column("log_id", sa.BigInteger(), nullable=False),
        sa.Column("line_id", sa.BigInteger(), nullable=False),
        sa.Column("direction", sa.Text(), nullable=False),
        sa.Column("assignee_id", sa.BigInteger(), nullable=True),
        sa.Column("reviewer_id", sa.BigInteger(), nullable=True),
        sa.Column("state", sa.Text(), nullable=False),
        sa.Column("state_since", sa.DateTime(timezone=True), server_default=sa.text("now()"), nullable=False),
        sa.Column("accepted_revision", sa.Integer(), nullable=True),
        sa.Column("created_at", sa.DateTime(timezone=True), server_default=sa.text("now()"), nullable=False),
        sa.CheckConstraint("direction IN ('prior_to_current', 'current_to_prior')", name="direction"),
        sa.CheckConstraint(
            "state IN ('draft', 'submitted', 'in_review', 'changes_requested', 'accepted')", name="state"
        ),
        sa.ForeignKeyConstraint(["assignee_id"], ["account.id"], name="fk_task_assignee_id"),
        sa.ForeignKeyConstraint(["line_id"], ["line.id"], name="fk_task_line_id"),
        sa.ForeignKeyConstraint(["log_id"], ["log.id"], name="fk_task_log_id", ondelete="CASCADE"),
        sa.ForeignKeyConstraint(["reviewer_id"], ["account.id"], name="fk_task_reviewer_id"),
        sa.PrimaryKeyConstraint("id", name="pk_task"),
        sa.UniqueConstraint("line_id", name="uq_task_line_id"),
    )
    op.create_index("ix_task_assignee_id", "task", ["assignee_id"], unique=False)
    op.create_index("ix_task_log_id", "task", ["log_id"], unique=False)
    op.create_index("ix_task_state_state_since", "task", ["state", "state_since"], unique=False)
    op.create_table(
        "atomic_change",
        sa.Column("line_id", sa.BigInteger(), nullable=False),
        sa.Column("revision", sa.Integer(), nullable=False),
        sa.Column("kind", sa.Text(), nullable=False),
        sa.Column("element_id", sa.BigInteger(), nullable=False),
        sa.Column("category", sa.Text(), nullable=False),
        sa.Column("leaves", sa.ARRAY(sa.Text()), nullable=False),
        sa.ForeignKeyConstraint(
            ["line_id", "revision"],
            ["revision.line_id", "revision.number"],
            name="fk_atomic_change_line_id_revision",
            ondelete="CASCADE",
        ),
        sa.PrimaryKeyConstraint("line_id", "revision", "kind", "element_id", "category", name="pk_atomic_change"),
    )
    op.create_index(
        "ix_atomic_change_category_line_id_revision", "atomic_change", ["category", "line_id", "revision"], unique=False
    )
    op.execute(sa.schema.CreateSequence(sa.Sequence("draft_version")))
    op.create_table(
        "draft",
        sa.Column("task_id", sa.BigInteger(), nullable=False),
        sa.Column("account_id", sa.BigInteger(), nullable=False),
        sa.Column("base_revision", sa.Integer(), nullable=False),
        sa.Column("edits", JSONB(), nullable=False),
        sa.Column("version", sa.Integer(), nullable=False),
        sa.Column("kept_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(["account_id"], ["account.id"], name="fk_draft_account_id", ondelete="CASCADE"),
        sa.ForeignKeyConstraint(["task_id"], ["task.id"], name="fk_draft_task_id", ondelete="CASCADE"),
        sa.PrimaryKeyConstraint("task_id", "account_id", name="pk_draft"),
    )
    op.create_table(
        "element_version",
        sa.Column("line_id", sa.BigInteger(), nullable=False),
        sa.Column("kind", sa.Text(), nullable=False),
        sa.Column("element_id", sa.BigInteger(), autoincrement=False, nullable=False),
        sa.Column("rev_from", sa.Integer(), autoincrement=False, nullable=False),
        sa.Column("rev_to", sa.Integer(), server_default=sa.text("2147483647"), nullable=False),
        sa.Column("attributes", JSONB(), nullable=False),
        sa.Column("geom", Geometry(geometry_type="MULTILINESTRINGZ", dimension=3, spatial_index=False), nullable=False),
        sa.Column("merc", Geometry(geometry_type="MULTILINESTRING", srid=3857, spatial_index=False), nullable=False),
        sa.Column("sha256", sa.LargeBinary(), nullable=False),
        sa.CheckConstraint("kind IN ('lane_segment', 'pedestrian_crossing')", name="kind"),
        sa.CheckConstraint("rev_from < rev_to", name="revisions"),
        sa.ForeignKeyConstraint(
            ["line_id", "rev_from"],
            ["revision.line_id", "revision.number"],
            name="fk_element_version_line_id_rev_from",
            ondelete="CASCADE",
        ),
        sa.PrimaryKeyConstraint("line_id", "kind", "element_id", "rev_from", name="pk_element_version"),
    )
    op.create_index("ix_element_version_line_id_rev_from", "element_version", ["line_id", "rev_from"], unique=False)
    op.create_index(
        "ix_element_version_line_id_rev_to",
        "element_version",
        ["line_id", "rev_to"],
        unique=False,
        postgresql_where=sa.text("rev_to < 2147483647"),
    )
    op.create_index(
        "ix_element_version_merc_live",
        "element_version",
        ["merc"],
        unique=False,
        postgresql_using="gist",
        postgresql_where=sa.text("rev_to = 2147483647"),
    )
    op.create_index(
        "uq_element_version_live",
        "element_version",
        ["line_id", "kind", "element_id"],
        unique=True,
        postgresql_where=sa.text("rev_to = 2147483647"),
    )
    op.create_table(
        "id_block",
        sa.Column("id", sa.BigInteger(), sa.Identity(always=True), nullable=False),
        sa.Column("log_id", sa.BigInteger(), nullable=False),
        sa.Column("task_id", sa.BigInteger(), nullable=False),
        sa.Column("account_id", sa.BigInteger(), nullable=False),
        sa.Column("first_id", sa.BigInteger(), nullable=False),
        sa.Column("last_id", sa.BigInteger(), nullable=False),
        sa.Column("created_at", sa.DateTime(timezone=True), server_default=sa.text("now()"), nullable=False),
        sa.CheckConstraint("first_id <= last_id AND last_id <= 2147483647", name="range"),
        sa.ForeignKeyConstraint(["account_id"], ["account.id"], name="fk_id_block_account_id"),
        sa.ForeignKeyConstraint(["log_id"], ["log.id"], name="fk_id_block_log_id", ondelete="CASCADE"),
        sa.ForeignKeyConstraint(["task_id"], ["task.id"], name="fk_id_block_task_id", ondelete="CASCADE"),
        sa.PrimaryKeyConstraint("id", name="pk_id_block"),
        sa.UniqueConstraint("log_id", "first_id", name="uq_id_block_log_id_first_id"),
    )
    op.create_index("ix_id_block_task_id", "id_block", ["task_id"], unique=False)
    op.create_table(
        "task_event",
        sa.Column("id", sa.BigInteger(), sa.Identity(always=True), nullable=False),
        sa.Column("task_id", sa.BigInteger(), nullable=False),
        sa.Column("actor_id", sa.BigInteger(), nullable=False),
        sa.Column("action", sa.Text(), nullable=False),
        sa.Column("from_state", sa.Text(), nullable=True),
        sa.Column("to_state", sa.Text(), nullable=False),
        sa.Column("revision", sa.Integer(), nullable=False),
        sa.Column("reason", sa.Text(), nullable=False),
        sa.Column("at", sa.DateTime(timezone=True), server_default=sa.text("now()"), nullable=False),
        sa.ForeignKeyConstraint(["actor_id"], ["account.id"], name="fk_task_event_actor_id"),
        sa.ForeignKeyConstraint(["task_id"], ["task.id"], name="fk_task_event_task_id", ondelete="CASCADE"),
        sa.PrimaryKeyConstraint("id", name="pk_task_event"),
    )
    op.create_index("ix_task_event_task_id", "task_event", ["task_id"], unique=False)
    op.create_table(
        "remark",
        sa.Column("id", sa.BigInteger(), sa.Identity(always=True), nullable=False),
        sa.Column("event_id", sa.BigInteger(), nullable=False),
        sa.Column("kind", sa.Text(), nullable=False),
        sa.Column("element_id", sa.BigInteger(), nullable=False),
        sa.Column("text", sa.Text(), nullable=False),
        sa.ForeignKeyConstraint(["event_id"], ["task_event.id"], name="fk_remark_event_id", ondelete="CASCADE"),
        sa.PrimaryKeyConstraint("id", name="pk_remark"),
    )
    op.create_index("ix_remark_event_id", "remark", ["event_id"], unique=False)


def downgrade() -> None:
    raise RuntimeError("restore a backup instead: dropping the tables would lose all work")
