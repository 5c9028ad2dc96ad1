"""What the rule engine says: atomic changes, structural updates, violations (spec §8), and the same in words."""

from __future__ import annotations

from typing import Any

from lanewright.api.schemas.base import Outgoing
from lanewright.api.schemas.declarations import DeclarationOut, MacrosOut
from lanewright.api.schemas.elements import EditOut
from lanewright.core.changes import Category
from lanewright.core.elements import ElementKind
from lanewright.core.violations import Severity


class ChangeOut(Outgoing):
    """All that changed on one element, base -> edited, told as the edit made."""

    kind: ElementKind
    id: int
    categories: list[Category]
    leaves: list[str]
    old: dict[str, Any] | None
    new: dict[str, Any] | None
    headline: str
    """E.g. "Lane 38109167 narrowed"."""
    detail: str
    """E.g. "right boundary 1.4 m in, 38 m long; right mark none → solid white"."""
    exported_as: str
    """How the export will read it where the direction inverts it, e.g. "will be exported as deletion"; else empty."""


class UpdateOut(Outgoing):
    """Changes that touch each other, with their macro-modifications."""

    title: str
    elements: list[tuple[ElementKind, int]]
    macros: MacrosOut


class FixOut(Outgoing):
    title: str
    edits: list[EditOut]
    declarations: list[DeclarationOut] | None = None
    """Only in fixes of ``macro.mismatch``: the whole list that takes the place of the present one."""


class ViolationOut(Outgoing):
    """``inherited``: the base has it already; shown, never blocking. ``blocks``: a save is refused for it."""

    id: str
    code: str
    severity: Severity
    kind: ElementKind
    elements: list[int]
    message: str
    fixes: list[FixOut]
    inherited: bool
    blocks: bool


class Findings(Outgoing):
    """Everything the engine says of one edited map against its base."""

    changes: list[ChangeOut]
    updates: list[UpdateOut]
    violations: list[ViolationOut]
