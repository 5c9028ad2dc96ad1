"""What a test asks of a check: codes and elements of what the edit introduced."""

from __future__ import annotations

from lanewright.core.edits import apply_edits
from lanewright.core.elements import MapState
from lanewright.core.rules import check
from lanewright.core.violations import Violation


def introduced(base: MapState, edited: MapState) -> list[tuple[str, tuple[int, ...]]]:
    """Code and elements of each violation that the edit introduced."""
    return [(one.code, one.elements) for one in check(base, edited) if not one.inherited]


def only(base: MapState, edited: MapState, code: str) -> Violation:
    """The one violation that the edit introduced."""
    found = [one for one in check(base, edited) if not one.inherited]
    assert [one.code for one in found] == [code], found
    return found[0]


def mended(base: MapState, edited: MapState, code: str) -> MapState:
    """The map after the fix of the one violation; nothing is left to complain about."""
    violation = only(base, edited, code)
    after = apply_edits(edited, violation.fixes[0].edits)
    assert introduced(base, after) == []
    return after
