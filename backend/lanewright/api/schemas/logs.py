"""Imported logs."""

from __future__ import annotations

import datetime

from lanewright.api.schemas.base import Outgoing
from lanewright.core.changes import Direction


class LogOut(Outgoing):
    log_id: str
    dataset: str
    city: str
    source_split: str | None
    release_split: str
    direction: Direction
    imported_at: datetime.datetime
    lanes: int
    crossings: int
    sensors: dict[str, int]
    absent: list[str]
    """Parts of a complete log that this one lacks."""
    tasks: int


class LogPage(Outgoing):
    items: list[LogOut]
    total: int
    page: int
    page_size: int
