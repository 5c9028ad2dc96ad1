"""Remedies of identity violations: the structural update they are in, in its canonical form (spec §6)."""

from __future__ import annotations

from collections.abc import Iterator
from weakref import WeakKeyDictionary

from lanewright.core.canonical import Canonical, canonical_form, canonical_update
from lanewright.core.comparison import Comparison
from lanewright.core.elements import ElementKey, ElementKind, MapState
from lanewright.core.macros import update_groups
from lanewright.core.rules.link_one_sided import with_links_completed
from lanewright.core.rules.rule import Remedy
from lanewright.core.violations import Violation
from lanewright.core.wording import listed

Group = tuple[ElementKey, ...] | None
_MOST_NAMED = 3
_NOUNS = {ElementKind.LANE_SEGMENT: "lane", ElementKind.PEDESTRIAN_CROSSING: "crossing"}


_remembered: WeakKeyDictionary[Comparison, dict[Group, Remedy]] = WeakKeyDictionary()
"""All violations of one update have the same remedy, so it is worked out once."""


def identity_remedies(comparison: Comparison, violation: Violation) -> Iterator[Remedy]:
    """The canonical form of the structural update; failing that, of the whole map."""
    keys = {ElementKey(violation.kind, element) for element in violation.elements}
    for group in update_groups(comparison):
        if not keys.isdisjoint(group):
            yield _canonical_remedy(comparison, group)
            break
    yield _canonical_remedy(comparison, None)


def _canonical_remedy(comparison: Comparison, group: Group) -> Remedy:
    known = _remembered.setdefault(comparison, {})
    if group not in known:
        canonical = (
            canonical_update(comparison, group) if group else canonical_form(comparison.uncut_base, comparison.edited)
        )
        edited = with_links_completed(comparison.base, canonical.edited)
        known[group] = Remedy(_button(canonical, comparison.base), edited)
    return known[group]


def _button(canonical: Canonical, base: MapState) -> str:
    """The title of the fix; in an annotator's words where one element gets the id of the one it replaced."""
    if len(canonical.renamed) == 1 and not canonical.joined and not canonical.cut:
        ((key, new),) = canonical.renamed.items()
        if ElementKey(key.kind, new) in base:
            return f"Make it an edit of {_NOUNS[key.kind]} {new}"
    return title_of(canonical)


def title_of(canonical: Canonical) -> str:
    """What the canonical form does, e.g. ``Make canonical: lane 9 becomes lane 1``."""
    words = [
        f"{_NOUNS[key.kind]} {key.id} becomes {_NOUNS[key.kind]} {new}"
        for key, new in sorted(canonical.renamed.items())
    ]
    words += [f"lane {lane} is joined to it" for lane in canonical.joined]
    words += [f"lane {whole} is cut" for whole in canonical.cut]
    if len(words) > _MOST_NAMED:
        words = [*words[:_MOST_NAMED], f"{len(words) - _MOST_NAMED} more"]
    return f"Make canonical: {listed(words)}" if words else "Make canonical"
