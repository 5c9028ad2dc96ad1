"""What the engine says of a map against its base, as the API's JSON: changes and updates in words, violations."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict
from typing import Any

from lanewright.core.changes import AtomicChange, Direction, MapDiff
from lanewright.core.claims import NO_CLAIMS, Claims
from lanewright.core.comparison import Comparison
from lanewright.core.diff import diff_of
from lanewright.core.elements import MapState
from lanewright.core.report import change_document, violation_document
from lanewright.core.rules import check_of
from lanewright.core.sentences import describe_update, exported_as, sentence
from lanewright.core.violations import Violation


class Findings:
    """The changes base -> edited and the violations in it.

    Args:
        direction: which way the task edits; it decides how the export will read the changes.
        claims: what is said of the update beside the two maps.
    """

    def __init__(self, base: MapState, edited: MapState, direction: str, claims: Claims = NO_CLAIMS) -> None:
        self.comparison = Comparison(base, edited, claims)
        self.direction = Direction(direction)
        self.diff: MapDiff = diff_of(self.comparison)
        self.violations: tuple[Violation, ...] = check_of(self.comparison)

    def document(self) -> dict[str, Any]:
        """Changes by kind and id, updates by their smallest element, violations by id."""
        return {
            "changes": [self._change(change) for change in self.diff.changes],
            "updates": self._updates(),
            "violations": violation_documents(self.violations),
        }

    def _change(self, change: AtomicChange) -> dict[str, Any]:
        base, edited = self.comparison.base, self.comparison.edited
        told = sentence(change, base, edited)
        return {
            **change_document(change),
            "headline": told.headline,
            "detail": told.detail,
            "exported_as": exported_as(change, base, edited, self.direction),
        }

    def _updates(self) -> list[dict[str, Any]]:
        base, edited = self.comparison.base, self.comparison.edited
        documents = []
        for update in self.diff.updates:
            told = describe_update(update, self.diff.changes, base, edited, self.direction)
            documents.append(
                {
                    "title": str(told).rstrip("."),
                    "elements": [[key.kind, key.id] for key in update.elements],
                    "macros": asdict(update.macros),
                }
            )
        return documents


def violation_documents(violations: Sequence[Violation]) -> list[dict[str, Any]]:
    """Violations, each with whether it stops a save."""
    return [{**violation_document(violation), "blocks": violation.blocks} for violation in violations]
