"""What others say of a map update, which the engine does not derive but checks."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from lanewright.core.changes import AtomicChange, Macros
from lanewright.core.elements import Element, ElementKey


@dataclass(frozen=True, slots=True)
class DeclaredMacros:
    """Macros that an annotator declares for the update that these elements form."""

    elements: tuple[ElementKey, ...]
    macros: Macros


@dataclass(frozen=True, slots=True)
class Claims:
    """Statements to be checked along with the two maps.

    Attributes:
        retired: elements that this map once deleted, as they last were; their ids must stand for nothing else.
        declared: declared macros (spec §4).
        annotated: atomic changes of a foreign annotation (spec §5, ``change.exclusive``).
    """

    retired: Mapping[ElementKey, Element] = field(default_factory=dict)
    declared: tuple[DeclaredMacros, ...] = ()
    annotated: tuple[AtomicChange, ...] = ()


NO_CLAIMS = Claims()
