"""The derived atomic changes base -> revision of every saved revision; recomputed by ``lanewright verify``."""

from __future__ import annotations

from sqlalchemy import ARRAY, BigInteger, ForeignKeyConstraint, Index, Integer, Text
from sqlalchemy.orm import Mapped, mapped_column

from lanewright.db.models.base import Base


class AtomicChangeRow(Base):
    """One category on one element in one revision, in the direction of the edit. Never written by hand."""

    __tablename__ = "atomic_change"

    line_id: Mapped[int] = mapped_column(BigInteger, primary_key=True)
    revision: Mapped[int] = mapped_column(Integer, primary_key=True)
    kind: Mapped[str] = mapped_column(Text, primary_key=True)
    element_id: Mapped[int] = mapped_column(BigInteger, primary_key=True)
    category: Mapped[str] = mapped_column(Text, primary_key=True)
    leaves: Mapped[list[str]] = mapped_column(ARRAY(Text))

    __table_args__ = (
        ForeignKeyConstraint(["line_id", "revision"], ["revision.line_id", "revision.number"], ondelete="CASCADE"),
        Index("ix_atomic_change_category_line_id_revision", "category", "line_id", "revision"),
    )
