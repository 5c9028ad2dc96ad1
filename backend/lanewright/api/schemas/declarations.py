"""Macros that an annotator declares for a structural update (change mapping §4): statements of the whole task."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Annotated

from pydantic import Field

from lanewright.api.schemas.base import Identifier, Incoming, Outgoing
from lanewright.api.schemas.elements import ElementKeyOut
from lanewright.core.changes import Macros
from lanewright.core.claims import DeclaredMacros
from lanewright.core.elements import ElementKey, ElementKind


class MacrosOut(Outgoing):
    shape: bool
    appearance: bool
    function: bool
    lane_graph: bool
    lane_number: int


class DeclarationOut(Outgoing):
    """The macros declared for the update that these elements are in."""

    elements: list[ElementKeyOut]
    macros: MacrosOut


class ElementKeyIn(Incoming):
    kind: ElementKind = Field(strict=False)
    id: Identifier


class MacrosIn(Incoming):
    shape: bool
    appearance: bool
    function: bool
    lane_graph: bool
    lane_number: int = Field(ge=-10_000, le=10_000)


class DeclarationIn(Incoming):
    """The macros declared for the update that these elements are in; some of its elements are enough."""

    elements: list[ElementKeyIn] = Field(min_length=1, max_length=5000)
    macros: MacrosIn

    def to_core(self) -> DeclaredMacros:
        """The declaration as a value of the domain, its elements sorted and named once."""
        keys = sorted({ElementKey(element.kind, element.id) for element in self.elements})
        return DeclaredMacros(tuple(keys), Macros(**self.macros.model_dump()))


Declarations = Annotated[
    list[DeclarationIn] | None,
    Field(
        max_length=200,
        description="All declarations of the task, not only new ones: the last list sent stands. Left out: those of "
        "the base revision.",
    ),
]


def to_core(declarations: Iterable[DeclarationIn] | None) -> tuple[DeclaredMacros, ...] | None:
    """The declarations as values of the domain; None: none were sent."""
    return None if declarations is None else tuple(declaration.to_core() for declaration in declarations)
