"""Edits of a map state: one value in four notations (undo entry, request body, fix of a violation, database rows).

An edit has an inverse and composes; a list of edits is applied as a whole or not at all.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from enum import StrEnum
from typing import Any

from lanewright.core.attributes import element_attributes, parse_attributes, parse_element
from lanewright.core.elements import Element, ElementKey, ElementKind, MapState
from lanewright.core.errors import InvalidInput, Place


class Operation(StrEnum):
    INSERT = "insert"
    UPDATE = "update"
    DELETE = "delete"


@dataclass(frozen=True, slots=True)
class Edit:
    """One edit of one element.

    ``attributes`` are AV2 attributes as in the file: all of them for an insert, the changed ones for an update,
    none for a delete.
    """

    operation: Operation
    kind: ElementKind
    id: int
    attributes: Mapping[str, Any] = dataclasses.field(default_factory=dict)

    @property
    def key(self) -> ElementKey:
        return ElementKey(self.kind, self.id)


def apply_edits(state: MapState, edits: Iterable[Edit], *, drawn: bool = False) -> MapState:
    """The state after all edits, in order; ``drawn``: points whose z is null are taken, as NaN (core.elevation).

    Raises:
        InvalidInput: an edit names an element that is not there (or already is), or has unusable attributes.
    """
    edited: dict[ElementKey, Element | None] = {}
    for edit in edits:
        known = edited[edit.key] if edit.key in edited else state.get(edit.key)
        try:
            edited[edit.key] = _applied(edit, known, drawn)
        except InvalidInput as error:
            raise error.within(element=f"{edit.kind.value} {edit.id}") from None
    put_in = [element for element in edited.values() if element is not None]
    return state.replaced(put_in, [key for key, element in edited.items() if element is None])


def _applied(edit: Edit, known: Element | None, drawn: bool) -> Element | None:
    """What an edit makes of the element of its key; None: there is none."""
    if edit.attributes.get("id", edit.id) != edit.id:
        raise InvalidInput("has another id in its attributes", "Name one id, that of the edit.", Place(key="id"))
    if edit.operation is Operation.INSERT:
        if known is not None:
            raise InvalidInput("is inserted but already there", "Use an update, or a new id.", Place(key="id"))
        return parse_element(edit.kind, {**edit.attributes, "id": edit.id}, drawn=drawn)
    if known is None:
        raise InvalidInput(
            f"cannot be {edit.operation.value}d: it is not in the map", "Reload the task.", Place(key="id")
        )
    if edit.operation is Operation.DELETE:
        return None
    return dataclasses.replace(known, **parse_attributes(edit.kind, edit.attributes, drawn=drawn))


def edits_between(before: MapState, after: MapState) -> tuple[Edit, ...]:
    """The smallest edits that turn ``before`` into ``after``: deletes, updates, inserts, each by kind and id."""
    deletes, updates, inserts = [], [], []
    for key in sorted(before.apart(after)):
        old, new = before.get(key), after.get(key)
        if new is None:
            deletes.append(Edit(Operation.DELETE, *key))
        elif old is None:
            inserts.append(Edit(Operation.INSERT, *key, element_attributes(new)))
        elif old != new:
            was, now = element_attributes(old), element_attributes(new)
            changed = {name: now.get(name) for name in {**was, **now} if now.get(name) != was.get(name)}
            updates.append(Edit(Operation.UPDATE, *key, changed))
    return (*deletes, *updates, *inserts)
