"""Changes and structural updates told as a mapper would say them; numbers with their units (issue: change list)."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from lanewright.core.changes import AtomicChange, Category, Direction, MapDiff, StructuralUpdate
from lanewright.core.diff import invert
from lanewright.core.displacement import crossing_shift, crossing_size, lane_length_m, reshaping, side_shift
from lanewright.core.elements import ElementKey, ElementKind, LaneSegment, MapState
from lanewright.core.leaves import TOPOLOGY
from lanewright.core.wording import (
    TYPE_WORDS,
    lanes_named,
    listed,
    mark_words,
    metres,
)


@dataclass(frozen=True, slots=True)
class Sentence:
    """A heading ("Lane 38109167 narrowed") and what stands behind it ("right boundary 1.4 m in, 38 m long")."""

    headline: str
    detail: str = ""

    def __str__(self) -> str:
        return f"{self.headline}: {self.detail}." if self.detail else f"{self.headline}."


def sentence(change: AtomicChange, base: MapState, edited: MapState) -> Sentence:
    """One atomic change between the two maps, in the words of an edit made."""
    if change.kind is ElementKind.PEDESTRIAN_CROSSING:
        return _crossing_sentence(change, base, edited)
    if Category.INSERTION in change.categories:
        return Sentence(f"Lane {change.id} inserted", _lane_words(edited.lanes[change.id]))
    if Category.DELETION in change.categories:
        return Sentence(f"Lane {change.id} deleted", _lane_words(base.lanes[change.id]))
    was, now = base.lanes[change.id], edited.lanes[change.id]
    verbs: list[str] = []
    details: list[str] = []
    if Category.GEOMETRY in change.categories:
        verbs.append("re-routed" if TOPOLOGY in change.leaves else reshaping(was, now))
        details += _shift_words(was, now)
    if Category.TYPE in change.categories:
        verbs.append(_type_verb(was, now))
        details += _type_details(was, now)
    if Category.MARKING in change.categories:
        verbs.append("repainted")
        details += _mark_details(was, now)
    if Category.CONNECTIVITY in change.categories:
        verbs.append("relinked")
        details += _link_details(was, now, base, edited)
    return Sentence(f"Lane {change.id} {listed(verbs)}", "; ".join(details))


def exported_as(change: AtomicChange, base: MapState, edited: MapState, direction: Direction) -> str:
    """How the export will read an edit where the direction inverts it: ``will be exported as: …``; else empty."""
    if direction is Direction.PRIOR_TO_CURRENT:
        return ""
    told = sentence(invert(MapDiff((change,))).changes[0], edited, base)
    return f"will be exported as: {told.headline[:1].lower()}{str(told).rstrip('.')[1:]}"


def describe_update(
    update: StructuralUpdate,
    changes: Iterable[AtomicChange],
    base: MapState,
    edited: MapState,
    direction: Direction = Direction.PRIOR_TO_CURRENT,
) -> Sentence:
    """The heading of a structural update, e.g. ``One lane added: shape, lane graph (lanes 1 and 9)``.

    With ``current_to_prior`` the detail ends with how the export will read the lane number.
    """
    members = set(update.elements)
    mine = [change for change in changes if change.key in members]
    headline = _update_headline(update, mine, base, edited)
    names = [
        name
        for name, holds in (
            ("shape", update.macros.shape),
            ("appearance", update.macros.appearance),
            ("function", update.macros.function),
            ("lane graph", update.macros.lane_graph),
        )
        if holds
    ]
    if update.macros.lane_number:
        names.append(f"lane number {_signed(update.macros.lane_number)}")
    detail = ", ".join(names)
    if direction is Direction.CURRENT_TO_PRIOR and update.macros.lane_number:
        detail += f"; will be exported as lane number {_signed(-update.macros.lane_number)}"
    return Sentence(headline, detail)


def _signed(number: int) -> str:
    return f"+{number}" if number > 0 else f"−{-number}"


def _update_headline(
    update: StructuralUpdate, changes: Sequence[AtomicChange], base: MapState, edited: MapState
) -> str:
    if len(changes) == 1:
        return sentence(changes[0], base, edited).headline
    number = update.macros.lane_number
    words: list[str] = []
    if number:
        count = "One lane" if abs(number) == 1 else f"{abs(number)} lanes"
        words.append(f"{count} {'more' if number > 0 else 'fewer'}")
    elif update.macros.lane_graph:
        words.append("Lanes re-routed")
    if not words and update.macros.function:
        words.append("Lane use changed")
    if not words and update.macros.shape:
        words.append("Road reshaped")
    if not words:
        words.append("Road repainted")
    return f"{words[0]} ({_elements_named(update.elements)})"


def _elements_named(elements: Sequence[ElementKey]) -> str:
    lanes = [key.id for key in elements if key.kind is ElementKind.LANE_SEGMENT]
    crossings = len(elements) - len(lanes)
    parts = []
    if lanes:
        parts.append(lanes_named(lanes) if len(lanes) <= 3 else f"{len(lanes)} lane segments")
    if crossings:
        parts.append("1 crossing" if crossings == 1 else f"{crossings} crossings")
    return listed(parts)


def _lane_words(lane: LaneSegment) -> str:
    place = " in an intersection" if lane.is_intersection else ""
    return (
        f"{TYPE_WORDS[lane.lane_type]}{place}, {metres(lane_length_m(lane))} long; "
        f"left mark {mark_words(lane.left_mark)}, right mark {mark_words(lane.right_mark)}"
    )


def _shift_words(was: LaneSegment, now: LaneSegment) -> list[str]:
    return [words for side in ("left", "right") if (words := side_shift(was, now, side))]


def _type_verb(was: LaneSegment, now: LaneSegment) -> str:
    if was.lane_type is not now.lane_type:
        return f"turned into a {TYPE_WORDS[now.lane_type]}"
    return "counted to the intersection" if now.is_intersection else "taken out of the intersection"


def _type_details(was: LaneSegment, now: LaneSegment) -> list[str]:
    details = []
    if was.lane_type is not now.lane_type:
        details.append(f"type {was.lane_type.value.lower()} → {now.lane_type.value.lower()}")
        if was.is_intersection != now.is_intersection:
            details.append("now inside an intersection" if now.is_intersection else "no longer inside an intersection")
    return details


def _mark_details(was: LaneSegment, now: LaneSegment) -> list[str]:
    return [
        f"{side} mark {mark_words(old)} → {mark_words(new)}"
        for side, old, new in (("left", was.left_mark, now.left_mark), ("right", was.right_mark, now.right_mark))
        if old is not new
    ]


def _link_details(was: LaneSegment, now: LaneSegment, base: MapState, edited: MapState) -> list[str]:
    shared = base.lanes.keys() & edited.lanes.keys()
    gone, new = (
        {
            (end, other)
            for end, ids in (("to", lane.successors), ("from", lane.predecessors))
            for other in ids
            if other in shared
        }
        for lane in (was, now)
    )
    details = [f"no link {end} lane {other} any more" for end, other in sorted(gone - new)]
    return details + [f"new link {end} lane {other}" for end, other in sorted(new - gone)]


def _crossing_sentence(change: AtomicChange, base: MapState, edited: MapState) -> Sentence:
    if Category.INSERTION in change.categories:
        return Sentence(f"Crossing {change.id} inserted", crossing_size(edited.crossings[change.id]))
    if Category.DELETION in change.categories:
        return Sentence(f"Crossing {change.id} deleted", crossing_size(base.crossings[change.id]))
    return Sentence(
        f"Crossing {change.id} moved", crossing_shift(base.crossings[change.id], edited.crossings[change.id])
    )
