"""Remedies of identity violations: the edited map with a place in the road graph under its old id again."""

from __future__ import annotations

from collections.abc import Iterator

from lanewright.core.comparison import Comparison
from lanewright.core.elements import ElementKind
from lanewright.core.identity import joinable, renamed, with_series_joined
from lanewright.core.rules.rule import Remedy
from lanewright.core.violations import Violation
from lanewright.core.wording import lanes_named


def identity_remedies(comparison: Comparison, violation: Violation) -> Iterator[Remedy]:
    """The inserted elements take the ids of the deleted ones whose place they have."""
    if not violation.code.startswith("replacement."):
        return
    if violation.kind is ElementKind.PEDESTRIAN_CROSSING:
        was, now = sorted(violation.elements, key=lambda key: key in comparison.inserted_crossings)
        yield Remedy(f"Edit crossing {was} in place", renamed(comparison.edited, {}, {now: was}))
        return
    deleted = [lane for lane in violation.elements if lane in comparison.deleted_lanes]
    inserted = [lane for lane in violation.elements if lane in comparison.inserted_lanes]
    order = next(iter(comparison.edited_graph.chains(inserted)), ())
    if len(deleted) != 1 or len(order) != len(inserted):
        return
    state = comparison.edited
    parts = [state.lanes[lane] for lane in order]
    if not all(joinable(parts[0], part) for part in parts):
        return
    if len(order) > 1:
        state = with_series_joined(state, order)
    yield Remedy(f"Edit {lanes_named(deleted)} in place", renamed(state, {order[0]: deleted[0]}))
