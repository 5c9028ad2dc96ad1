"""The canonical form in the annotator's own segmentation, where that tells the same story.

The canonical form cuts the road where the base does, or across from there; a joint that was drawn a little further on
is as good where the changes are the same either way.
"""

from __future__ import annotations

from typing import Any

from lanewright.core.comparison import Comparison
from lanewright.core.diff import atomic_changes
from lanewright.core.elements import Element, ElementKey, LaneSegment, MapState
from lanewright.core.macros import touching_groups


def as_drawn(base: MapState, drawn: MapState, canonical: MapState) -> MapState:
    """The canonical form of what was drawn, with elements as they were drawn wherever all that touch each other tell
    the same story."""
    between = Comparison(drawn, canonical)
    groups = [
        group
        for group in touching_groups(between, between.apart)
        if all(_same_element(drawn, canonical, key) for key in group)
    ]
    if not groups:
        return canonical
    before, after = _told(base, drawn), _told(base, canonical)
    back: list[Element] = []
    for group in groups:
        if all(before.get(key) == after.get(key) for key in group):
            back += filter(None, map(drawn.get, group))
    return canonical.replaced(back)


def _told(base: MapState, edited: MapState) -> dict[ElementKey, Any]:
    return {change.key: (change.categories, change.leaves) for change in atomic_changes(Comparison(base, edited))}


def _same_element(drawn: MapState, canonical: MapState, key: ElementKey) -> bool:
    """Whether an element is in both maps, as the same part of a cut lane or as none."""
    one, other = drawn.get(key), canonical.get(key)
    if isinstance(one, LaneSegment) and isinstance(other, LaneSegment):
        return one.part_of == other.part_of
    return one is not None and other is not None
