"""Declared macros (change mapping §4): statements of a whole task, so every save sends and stores all of them."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from sqlalchemy.orm import Session

from lanewright.core.changes import Macros
from lanewright.core.claims import DeclaredMacros
from lanewright.core.elements import ElementKey, ElementKind
from lanewright.core.report import declaration_document
from lanewright.db.repositories import revisions

Declared = tuple[DeclaredMacros, ...]


def declared_at(session: Session, line_id: int, revision: int) -> Declared:
    """What stands at a revision."""
    return from_documents(revisions.declarations(session, line_id, revision))


def in_order(declared: Iterable[DeclaredMacros]) -> Declared:
    """Each declaration once, sorted: equal statements are equal values."""
    return tuple(sorted(set(declared), key=lambda one: (one.elements, dataclasses.astuple(one.macros))))


def merged(seen: Declared, head: Declared, mine: Declared) -> Declared:
    """The declarations of an editor who had ``seen`` before them, where others meanwhile made them ``head``.

    What either added, withdrew or changed counts; of two new statements on the same elements, the editor's.
    """
    added = [one for one in mine if one not in seen]
    told = {one.elements for one in added}
    theirs = [one for one in head if one not in seen and one.elements not in told]
    return in_order([*added, *theirs, *(one for one in mine if one in seen and one in head)])


def renamed(declared: Declared, ids: Mapping[ElementKey, int]) -> Declared:
    """The declarations about elements that have other ids now."""
    return in_order(
        dataclasses.replace(
            one, elements=tuple(sorted(ElementKey(key.kind, ids.get(key, key.id)) for key in one.elements))
        )
        for one in declared
    )


def documents(declared: Iterable[DeclaredMacros]) -> list[dict[str, Any]]:
    """As the API's JSON, which is also what is stored."""
    return [declaration_document(one) for one in declared]


def from_documents(stored: Sequence[Any]) -> Declared:
    """Back from ``documents``."""
    return in_order(
        DeclaredMacros(
            tuple(ElementKey(ElementKind(element["kind"]), element["id"]) for element in one["elements"]),
            Macros(**one["macros"]),
        )
        for one in stored
    )
