"""Diffs and findings as JSON-ready documents (spec §8): sorted, stable byte for byte."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import asdict
from typing import Any

from lanewright.core.changes import AtomicChange, MapDiff, StructuralUpdate
from lanewright.core.claims import DeclaredMacros
from lanewright.core.edits import Edit
from lanewright.core.violations import Fix, Violation


def diff_document(changes: MapDiff) -> dict[str, Any]:
    """``{"changes": [..], "updates": [..]}``: changes by kind and id, updates by their smallest element."""
    return {
        "changes": [change_document(change) for change in sorted(changes.changes, key=lambda change: change.key)],
        "updates": [_update_document(update) for update in sorted(changes.updates, key=lambda one: one.elements)],
    }


def change_document(change: AtomicChange) -> dict[str, Any]:
    """One atomic change."""
    return {
        "id": change.id,
        "kind": change.kind.value,
        "categories": sorted(category.value for category in change.categories),
        "leaves": sorted(change.leaves),
        "old": None if change.old is None else dict(change.old),
        "new": None if change.new is None else dict(change.new),
    }


def _update_document(update: StructuralUpdate) -> dict[str, Any]:
    return {"elements": sorted(key.id for key in update.elements), "macros": asdict(update.macros)}


def check_document(violations: Iterable[Violation]) -> dict[str, Any]:
    """``{"violations": [..]}`` by id."""
    return {
        "violations": [
            violation_document(violation) for violation in sorted(violations, key=lambda violation: violation.id)
        ]
    }


def violation_document(violation: Violation) -> dict[str, Any]:
    """One violation with its fixes."""
    return {
        "id": violation.id,
        "code": violation.code,
        "severity": violation.severity.value,
        "kind": violation.kind.value,
        "elements": sorted(violation.elements),
        "message": violation.message,
        "fixes": [_fix_document(fix) for fix in violation.fixes],
        "inherited": violation.inherited,
    }


def _fix_document(fix: Fix) -> dict[str, Any]:
    """One fix; ``declarations`` only where the fix is about them."""
    document: dict[str, Any] = {"title": fix.title, "edits": [edit_document(edit) for edit in fix.edits]}
    if fix.declared is not None:
        document["declarations"] = [declaration_document(declared) for declared in fix.declared]
    return document


def declaration_document(declared: DeclaredMacros) -> dict[str, Any]:
    """Macros declared for an update."""
    return {
        "elements": [{"kind": key.kind.value, "id": key.id} for key in declared.elements],
        "macros": asdict(declared.macros),
    }


def edit_document(edit: Edit) -> dict[str, Any]:
    """One edit as the API takes it."""
    return {
        "operation": edit.operation.value,
        "kind": edit.kind.value,
        "id": edit.id,
        "attributes": dict(edit.attributes),
    }
