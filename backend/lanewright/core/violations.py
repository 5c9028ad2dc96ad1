"""Findings of the rule engine as values (spec §5, §8)."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum

from lanewright.core.claims import DeclaredMacros
from lanewright.core.edits import Edit
from lanewright.core.elements import ElementKind


class Severity(StrEnum):
    ERROR = "error"
    WARNING = "warning"
    NONE = "none"
    """A note: the save settles it by itself (``identity.not_canonical``)."""


@dataclass(frozen=True, slots=True)
class Fix:
    """A remedy: edits that can be applied to the edited map as they stand.

    ``declared``: all declarations as they should be, where these are what is wrong; else None.
    """

    title: str
    edits: tuple[Edit, ...]
    declared: tuple[DeclaredMacros, ...] | None = None


@dataclass(frozen=True, slots=True)
class Violation:
    """A rule broken by an edit. ``inherited``: the base map has it already; shown, never blocking."""

    code: str
    severity: Severity
    kind: ElementKind
    elements: tuple[int, ...]
    message: str
    fixes: tuple[Fix, ...] = ()
    inherited: bool = False

    @property
    def id(self) -> str:
        """Deterministic: ``code:kind:sorted element ids``."""
        return f"{self.code}:{self.kind.value}:{','.join(str(i) for i in sorted(self.elements))}"

    @property
    def blocks(self) -> bool:
        """Whether a save must be refused for it."""
        return self.severity is Severity.ERROR and not self.inherited
