"""Lines of revisions and the element versions on them (current state and full history in one table).

A log has a base line (revision 0 only); every task forks a line of its own from it. A version is live on revisions
``rev_from <= r < rev_to``; integers measured smaller and faster than range types, manifests or a separate history
table (docs/decisions.md).
"""

from __future__ import annotations

import uuid
from typing import Any

from geoalchemy2 import Geometry
from sqlalchemy import (
    BigInteger,
    CheckConstraint,
    ForeignKey,
    ForeignKeyConstraint,
    Index,
    Integer,
    Text,
    UniqueConstraint,
    text,
)
from sqlalchemy.orm import Mapped, mapped_column

from lanewright.db.models.base import Base, created, identity

LIVE = 2**31 - 1
"""``rev_to`` of a version that no later revision has replaced."""


class Line(Base):
    """A line of revisions of one log's map. ``head`` is its newest revision; updating it is the writers' lock."""

    __tablename__ = "line"

    id: Mapped[identity]
    log_id: Mapped[int] = mapped_column(ForeignKey("log.id", ondelete="CASCADE", deferrable=True, initially="DEFERRED"))
    head: Mapped[int] = mapped_column(Integer, default=0)
    created_at: Mapped[created]

    __table_args__ = (Index("ix_line_log_id", "log_id"),)


class Revision(Base):
    """One changeset, and the state it led to. Author and time come from the server, never from the client.

    ``answer`` is the response body as it was sent: a replay (same account, line, UUID and body) gets it again.
    """

    __tablename__ = "revision"

    line_id: Mapped[int] = mapped_column(ForeignKey("line.id", ondelete="CASCADE"), primary_key=True)
    number: Mapped[int] = mapped_column(Integer, primary_key=True, autoincrement=False)
    author_id: Mapped[int | None] = mapped_column(ForeignKey("account.id"))
    created_at: Mapped[created]
    note: Mapped[str] = mapped_column(Text, default="")
    changeset_uuid: Mapped[uuid.UUID | None]
    body_sha256: Mapped[bytes | None]
    answer: Mapped[bytes | None] = mapped_column(deferred=True)
    content_sha256: Mapped[bytes]
    """Hash over the sorted (kind, id, sha256) of all live versions."""
    updates: Mapped[list[Any]]
    """JSON: the structural updates base -> this revision, spec §8."""
    declarations: Mapped[list[Any]] = mapped_column(server_default=text("'[]'"))
    """JSON: the macros that annotators declare for those updates, all that stand at this revision."""

    __table_args__ = (UniqueConstraint("line_id", "author_id", "changeset_uuid"),)


class ElementVersion(Base):
    """A version of one element. ``geom`` holds its two lines (left, right / edge1, edge2) in exact city metres."""

    __tablename__ = "element_version"

    line_id: Mapped[int] = mapped_column(BigInteger, primary_key=True)
    kind: Mapped[str] = mapped_column(Text, primary_key=True)
    element_id: Mapped[int] = mapped_column(BigInteger, primary_key=True, autoincrement=False)
    rev_from: Mapped[int] = mapped_column(Integer, primary_key=True, autoincrement=False)
    rev_to: Mapped[int] = mapped_column(Integer, server_default=text(str(LIVE)))
    attributes: Mapped[dict[str, Any]]
    """JSON: the AV2 attributes without geometry and id."""
    geom: Mapped[Any] = mapped_column(Geometry("MULTILINESTRINGZ", dimension=3, spatial_index=False))
    merc: Mapped[Any] = mapped_column(Geometry("MULTILINESTRING", srid=3857, spatial_index=False))
    sha256: Mapped[bytes]

    __table_args__ = (
        ForeignKeyConstraint(["line_id", "rev_from"], ["revision.line_id", "revision.number"], ondelete="CASCADE"),
        CheckConstraint("rev_from < rev_to", name="revisions"),
        CheckConstraint("kind IN ('lane_segment', 'pedestrian_crossing')", name="kind"),
        Index(
            "uq_element_version_live",
            "line_id",
            "kind",
            "element_id",
            unique=True,
            postgresql_where=text(f"rev_to = {LIVE}"),
        ),
        Index(
            "ix_element_version_merc_live", "merc", postgresql_using="gist", postgresql_where=text(f"rev_to = {LIVE}")
        ),
        Index("ix_element_version_line_id_rev_from", "line_id", "rev_from"),
        Index("ix_element_version_line_id_rev_to", "line_id", "rev_to", postgresql_where=text(f"rev_to < {LIVE}")),
    )
