"""Checking and saving."""

from __future__ import annotations

import datetime
import uuid
from typing import Any

from pydantic import Field

from lanewright.api.schemas.base import Incoming, Outgoing, RevisionNumber, Text
from lanewright.api.schemas.declarations import DeclarationOut, Declarations
from lanewright.api.schemas.elements import EditIn, EditOut, ElementKeyOut, MapOut
from lanewright.api.schemas.findings import Findings
from lanewright.core.changes import Category
from lanewright.core.elements import ElementKind


class CheckIn(Incoming):
    """The draft as it stands; checked like a save, nothing is written."""

    base_revision: RevisionNumber
    edits: list[EditIn] = Field(max_length=5000)
    declarations: Declarations = None


class SaveIn(CheckIn):
    """One changeset. ``changeset_uuid`` is made by the client: the same one with the same body is answered alike."""

    changeset_uuid: uuid.UUID = Field(strict=False)
    note: Text = ""


class RenamedElement(Outgoing):
    """An element that now has another id."""

    kind: ElementKind
    from_id: int = Field(alias="from")
    to_id: int = Field(alias="to")


class CanonicalOut(Outgoing):
    """What takes the draft to its canonical form: edits that are applied as a fix is; none when it is canonical."""

    edits: list[EditOut]
    renamed: list[RenamedElement]
    joined: list[int]
    """Lanes that become part of the lane before or after them."""
    cut: list[int]
    """Lanes of the base that are cut, since a property changes half-way, and drawn lanes that are now several."""


class SavedRevision(Outgoing):
    """What a save led to. ``changed``/``removed``: the elements that now differ from ``base_revision``, as stored."""

    task_id: int
    revision: int
    created_at: datetime.datetime
    changed: MapOut
    removed: list[ElementKeyOut]
    restored: list[ElementKeyOut]
    """Elements whose edit was below tolerance and went back to the base's exact coordinates."""
    canonical: list[RenamedElement]
    """Elements of the draft that were stored under another id, because the canonical form calls them so."""
    joined: list[int]
    """Lanes of the draft that the canonical form made part of the lane before or after them in series."""
    cut: list[int]
    """Lanes that the canonical form cuts: of the base, since a property changes half-way, or drawn in one piece."""
    declarations: list[DeclarationOut]
    """All declarations of the task as stored: merged with those that others saved, ids as in ``canonical``."""
    findings: Findings


class ConflictingElement(Outgoing):
    """One element of a stale save (409 ``save.stale``, facts.conflicts): AV2 attributes, null where it is absent."""

    kind: ElementKind
    id: int
    base: dict[str, Any] | None
    mine: dict[str, Any] | None
    theirs: dict[str, Any] | None


class ChangeRow(Outgoing):
    """A row of the change query: one category on one element at a task's revision, as the edit made."""

    log_id: str
    city: str
    release_split: str
    task_id: int
    revision: int
    kind: ElementKind
    element_id: int
    category: Category
    leaves: list[str]


class ChangePage(Outgoing):
    items: list[ChangeRow]
    total: int
    page: int
    page_size: int
