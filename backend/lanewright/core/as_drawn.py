"""The canonical form in the annotator's own segmentation, where that tells the same story.

The canonical form cuts the road where the base does, or across from there; a joint that was drawn a little further on
is as good where the changes are the same either way.
"""

from __future__ import annotations

from collections.abc import Mapping

from lanewright.core.changes import Category
from lanewright.core.comparison import Comparison
from lanewright.core.diff import atomic_changes
from lanewright.core.elements import Element, ElementKey, LaneSegment, MapState
from lanewright.core.geometry import lines_of, overlap
from lanewright.core.macros import touching_groups

_MUCH = 0.3
"""Of the union, as for crossings (spec §5)."""


def as_drawn(base: MapState, drawn: MapState, canonical: MapState, renames: Mapping[ElementKey, int]) -> MapState:
    """The canonical form of what was drawn, with elements as they were drawn wherever all that touch each other tell
    the same story under the same ids (``renames``: those that differ)."""
    between = Comparison(drawn, canonical)
    renamed = {*renames, *(ElementKey(key.kind, new) for key, new in renames.items())}
    groups = [
        group
        for group in touching_groups(between, between.apart)
        if renamed.isdisjoint(group) and all(_same_place(between, key) for key in group)
    ]
    if not groups:
        return canonical
    before, after = _told(base, drawn), _told(base, canonical)
    back: list[Element] = []
    for group in groups:
        if all(before.get(key) == after.get(key) for key in group):
            back += filter(None, map(drawn.get, group))
    return canonical.replaced(back)


def _told(base: MapState, edited: MapState) -> dict[ElementKey, tuple[tuple[Category, ...], tuple[str, ...]]]:
    return {change.key: (change.categories, change.leaves) for change in atomic_changes(Comparison(base, edited))}


def _same_place(between: Comparison, key: ElementKey) -> bool:
    """Whether an element is in both maps, as the same part of a cut lane or as none, in much the same place."""
    drawn, canonical = between.base.get(key), between.edited.get(key)
    if drawn is None or canonical is None:
        return False
    if isinstance(drawn, LaneSegment) and isinstance(canonical, LaneSegment) and drawn.part_of != canonical.part_of:
        return False
    shapes = (between.shape(key, edited=edited) for edited in (False, True))
    return lines_of(drawn) == lines_of(canonical) or overlap(*shapes) >= _MUCH
