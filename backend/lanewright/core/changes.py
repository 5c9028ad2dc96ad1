"""Atomic changes and structural updates: what a diff is made of (spec §3, §4, §8; paper 4.1, supplement A.7)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from enum import StrEnum
from typing import Any

from lanewright.core.elements import ElementKey, ElementKind


class Category(StrEnum):
    INSERTION = "insertion"
    DELETION = "deletion"
    GEOMETRY = "geometry"
    MARKING = "marking"
    TYPE = "type"
    CONNECTIVITY = "connectivity"


@dataclass(frozen=True, slots=True)
class AtomicChange:
    """All that changed on one element. ``old``/``new`` hold the AV2 attributes that changed (None: no such element)."""

    kind: ElementKind
    id: int
    categories: tuple[Category, ...]
    leaves: tuple[str, ...]
    old: Mapping[str, Any] | None
    new: Mapping[str, Any] | None

    @property
    def key(self) -> ElementKey:
        return ElementKey(self.kind, self.id)


@dataclass(frozen=True, slots=True)
class Macros:
    """Macro-modifications of one structural update (spec §4, matrix C)."""

    shape: bool
    appearance: bool
    function: bool
    lane_graph: bool
    lane_number: int


@dataclass(frozen=True, slots=True)
class StructuralUpdate:
    """Atomic changes that touch each other, with their derived macros; elements sorted by kind, then id."""

    elements: tuple[ElementKey, ...]
    macros: Macros


@dataclass(frozen=True, slots=True)
class MapDiff:
    """The one explanation of a map update: changes by kind and id, updates by their smallest element."""

    changes: tuple[AtomicChange, ...] = ()
    updates: tuple[StructuralUpdate, ...] = ()


class Direction(StrEnum):
    """Which way a task runs (spec §3): whether its base map is the prior or the current one."""

    PRIOR_TO_CURRENT = "prior_to_current"
    CURRENT_TO_PRIOR = "current_to_prior"
