"""Imported driving logs: the file template of the map, and what the sensors left."""

from __future__ import annotations

from typing import Any

from sqlalchemy import BigInteger, CheckConstraint, ForeignKey, Index, Text
from sqlalchemy.orm import Mapped, mapped_column

from lanewright.db.models.base import Base, created, identity


class Log(Base):
    """One AV2 Sensor or TbV log. ``map_document`` is the map file as it was read: exports are written onto it."""

    __tablename__ = "log"

    id: Mapped[identity]
    log_id: Mapped[str] = mapped_column(Text, unique=True)
    dataset: Mapped[str] = mapped_column(Text)
    city: Mapped[str] = mapped_column(Text)
    source_split: Mapped[str | None] = mapped_column(Text)
    release_split: Mapped[str] = mapped_column(Text)
    direction: Mapped[str] = mapped_column(Text)
    map_file_name: Mapped[str] = mapped_column(Text)
    map_document: Mapped[bytes] = mapped_column(deferred=True)
    map_sha256: Mapped[bytes]
    content_sha256: Mapped[bytes]
    """Hash of everything imported: the same log imported again is recognised by it."""
    line_id: Mapped[int] = mapped_column(ForeignKey("line.id", use_alter=True))
    next_new_id: Mapped[int] = mapped_column(BigInteger)
    """First element id that no block of this log has handed out yet."""
    last_new_id: Mapped[int] = mapped_column(BigInteger)
    """Last one that may be handed out: all from ``next_new_id`` to here are unused by the map, rim ids included."""
    summary: Mapped[dict[str, Any]]
    """JSON: bounds in city metres, counts, sensors present (name -> files), parts absent."""
    imported_at: Mapped[created]

    __table_args__ = (
        Index("ix_log_city_release_split", "city", "release_split"),
        CheckConstraint("release_split IN ('train', 'val', 'test')", name="release_split"),
        CheckConstraint("direction IN ('prior_to_current', 'current_to_prior')", name="direction"),
        CheckConstraint("next_new_id <= last_new_id + 1 AND last_new_id <= 2147483647", name="new_ids"),
    )


class LogAsset(Base):
    """A file kept for a log: ``sensors.json`` (frames, poses, files), ``lidar.png``, ``ground.npy``, ``sim2.json``."""

    __tablename__ = "log_asset"

    log_id: Mapped[int] = mapped_column(ForeignKey("log.id", ondelete="CASCADE"), primary_key=True)
    name: Mapped[str] = mapped_column(Text, primary_key=True)
    media_type: Mapped[str] = mapped_column(Text)
    body: Mapped[bytes]
    sha256: Mapped[bytes]
    details: Mapped[dict[str, Any]]
