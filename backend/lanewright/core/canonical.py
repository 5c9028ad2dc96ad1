"""One explanation per map update (spec §6): the canonical assignment of identity.

Ids of the edited map (within the scope) are forgotten. Lanes take the id of the base lane in whose place they are:
first those with the same lines, then whoever took the place of a deleted chain or kept its function; what the rules
forbid is taken back, what the right-hand side decides is exchanged. Ties are settled by what is seen, never by the
ids the edited map happens to have: fewest categories, least displacement, smallest base id, then position.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass
from weakref import WeakKeyDictionary

from lanewright.core.alignment import categories_between
from lanewright.core.as_drawn import as_drawn
from lanewright.core.assignment import Assignment, other_than_itself
from lanewright.core.comparison import Comparison
from lanewright.core.elements import ElementKey, ElementKind, MapState
from lanewright.core.identity import fresh_ids, one_road, renamed
from lanewright.core.macros import update_groups
from lanewright.core.matching import lanes_by_place, place_of
from lanewright.core.objections import objected
from lanewright.core.scope import widened, worked_out_together
from lanewright.core.settlement import settle


@dataclass(frozen=True, slots=True)
class Canonical:
    """The edited map under canonical identity.

    Attributes:
        edited: the map, ids and cuts aside the same as before.
        renamed: lanes and crossings whose id changed, old to new.
        joined: lanes that became part of the lane before or after them in series.
        cut: base lanes that are cut, since a property changes half-way, and lanes drawn in one piece that are several.
    """

    edited: MapState
    renamed: dict[ElementKey, int]
    joined: tuple[int, ...]
    cut: tuple[int, ...]


def canonicalise(base: MapState, edited: MapState) -> MapState:
    """The edited map under its canonical assignment of identity (spec §6); idempotent."""
    return canonical_form(base, edited).edited


def canonical_form(base: MapState, edited: MapState, scope: Collection[ElementKey] | None = None) -> Canonical:
    """The canonical form, with what was renamed.

    ``scope``: only these elements (of either map), and lanes linked to those of them that came or went, are looked at
    anew; all others keep their ids. None: all.
    """
    if scope is not None:
        scope = widened(Comparison(base, edited), scope)
    assignment = Assignment.start(base, edited, scope)
    settle(assignment)
    return _named(assignment, edited, fresh_ids((base, edited)))


def canonical_map(comparison: Comparison) -> Canonical:
    """The edited map with every structural update in its canonical form, but for those that stand as drawn."""
    standing = [key for update in update_groups(comparison) if stands(comparison, update) for key in update]
    return canonical_form(comparison.uncut_base, comparison.edited, comparison.changed_keys.difference(standing))


def stands(comparison: Comparison, update: Collection[ElementKey]) -> bool:
    """Whether a structural update stays as it was drawn: its canonical form is the same, or a longer story and no rule
    of identity asks for it. The steps to the canonical form look at what is near, so what was drawn may be shorter."""
    together = worked_out_together(comparison, update)
    form = canonical_update(comparison, together)
    if form.edited is comparison.edited:
        return True
    canonical = Comparison(comparison.uncut_base, form.edited)
    apart = form.edited.apart(comparison.edited)
    longer = _length(canonical, apart) > _length(comparison, apart)
    return longer and objected(comparison).isdisjoint(together)


def lengthening_updates(comparison: Comparison) -> list[tuple[ElementKey, ...]]:
    """The updates in which a lane came that only makes another one longer: legal as drawn, and no note is told of it
    (any lane of a map may be put back as it was), but the save joins them, since drawn as one it is the same road."""
    return [
        update
        for update in update_groups(comparison)
        if any(key.id in comparison.inserted_lanes and _runs_on(comparison, key) for key in update)
        and not stands(comparison, update)
    ]


def _runs_on(comparison: Comparison, key: ElementKey) -> bool:
    """Whether nothing differs between a lane and the one before or after it in series."""
    if key.kind is not ElementKind.LANE_SEGMENT:
        return False
    graph, lanes = comparison.edited_graph, comparison.edited.lanes
    before, after = graph.previous_in_series(key.id, lanes), graph.next_in_series(key.id, lanes)
    joints = [
        (one, other) for one, other in ((before, key.id), (key.id, after)) if one is not None and other is not None
    ]
    return any(one_road(lanes[one], lanes[other]) for one, other in joints)


def _length(comparison: Comparison, among: Collection[ElementKey]) -> tuple[int, int]:
    """Insertions and deletions, then categories of change (links all over the map, as either side may write them)."""
    base, edited = comparison.base, comparison.edited
    whole = sum((key in base) is not (key in edited) for key in among)
    in_place = sum(_categories(comparison, key) for key in among if key in base and key in edited)
    return whole, whole + in_place + len({lane for link, _ in comparison.changed_links for lane in link})


def _categories(comparison: Comparison, key: ElementKey) -> int:
    """How many categories of change in place a survivor has."""
    if key.kind is ElementKind.PEDESTRIAN_CROSSING:
        return int(comparison.crossing_moved(key.id))
    return categories_between(comparison.base.lanes[key.id], comparison.edited.lanes[key.id])


_remembered: WeakKeyDictionary[Comparison, dict[frozenset[ElementKey], Canonical]] = WeakKeyDictionary()


def canonical_update(comparison: Comparison, update: Collection[ElementKey]) -> Canonical:
    """The edited map with one structural update in its canonical form. It is settled as if it were the only one; lanes
    linked to what came or went are looked at along with it, since one of them may be the one to replace, and so are
    other updates that meet these. Worked out once per comparison."""
    known = _remembered.setdefault(comparison, {})
    question = worked_out_together(comparison, update)
    if question not in known:
        known[question] = _settled(comparison, question)
    return known[question]


def _settled(comparison: Comparison, question: Collection[ElementKey]) -> Canonical:
    base, edited = comparison.uncut_base, comparison.edited
    scope = widened(comparison, question)
    others = comparison.changed_keys.difference(scope)
    back = [element for element in map(base.get, others) if element is not None]
    alone = edited.replaced(back, [key for key in others if key not in comparison.base])
    assignment = Assignment.start(base, alone, scope)
    settle(assignment)
    form = _named(assignment, alone, fresh_ids((base, edited)))
    if form.edited is alone:
        return dataclasses.replace(form, edited=edited)
    settled = {key: form.edited.get(key) for key in form.edited.apart(alone).difference(others)}
    put_in = [element for element in settled.values() if element is not None]
    merged = edited.replaced(put_in, [key for key, element in settled.items() if element is None])
    return dataclasses.replace(form, edited=merged)


def canonical_updates(comparison: Comparison, updates: Iterable[Collection[ElementKey]]) -> Canonical:
    """The edited map with several structural updates in their canonical form."""
    return canonical_update(comparison, [key for update in updates for key in update])


def _named(assignment: Assignment, original: MapState, fresh: Iterator[int]) -> Canonical:
    """The assignment under final ids."""
    taken = {*assignment.base.lanes, *assignment.base.crossings}
    assignment.own_lane_ids = _drawn_lanes(assignment, original)
    lanes = _final_ids(assignment.edited.lanes, assignment.lanes, assignment.own_lane_ids, taken, fresh)
    crossings = _final_ids(assignment.edited.crossings, assignment.crossings, assignment.own_crossing_ids, taken, fresh)
    final = assignment.with_parts_named(renamed(assignment.edited, *map(other_than_itself, (lanes, crossings))), lanes)
    renames = dict(_renames(assignment, lanes, crossings))
    if assignment.recut:
        final = as_drawn(assignment.base, original, final, renames)
    final = _with_known_objects(final, original)
    return Canonical(
        final,
        renames,
        tuple(sorted(assignment.drawn.difference(map(assignment.own_lane_ids.get, lanes), lanes.values()))),
        tuple(sorted({*_newly_cut(assignment, original), *_cut_as_drawn(assignment, lanes, original, final)})),
    )


def _drawn_lanes(assignment: Assignment, original: MapState) -> dict[int, int]:
    """Token -> the lane that was drawn: the one on the same lines, else the one with the id that it gets, else the one
    that it came from."""
    came_from = {token: own for token, own in assignment.own_lane_ids.items() if token in assignment.edited.lanes}
    if not assignment.recut:
        return came_from
    drawn = lanes_by_place({lane: original.lanes[lane] for lane in sorted(assignment.drawn)})
    found: dict[int, int] = {}
    for token in sorted(assignment.edited.lanes.keys() - original.lanes.keys()):
        here = drawn.get(place_of(assignment.edited.lanes[token]), [])
        if here:
            found[token] = came_from[token] if came_from.get(token) in here else here[0]
            here.remove(found[token])
    for candidates in (assignment.lanes, came_from):
        known = set(found.values())
        found |= {
            token: own
            for token, own in candidates.items()
            if token not in found and own not in known and own in original.lanes
        }
    return found


def _newly_cut(assignment: Assignment, original: MapState) -> Iterator[int]:
    """Base lanes that have a part of which the original has no such record."""
    for token, whole in assignment.parts.items():
        known = original.lanes.get(assignment.own_lane_ids.get(token, token))
        if known is None or known.part_of != whole:
            yield whole


def _cut_as_drawn(
    assignment: Assignment, lanes: Mapping[int, int], original: MapState, final: MapState
) -> Iterator[int]:
    """Lanes that were drawn in one piece of which the canonical form makes several."""
    for token, drawn in assignment.pieces_of.items():
        piece = final.lanes.get(lanes.get(token, token))
        if piece is not None and piece.part_of is None and piece.id not in original.lanes:
            yield drawn


def _final_ids(
    tokens: Iterable[int],
    matched: Mapping[int, int],
    own: Mapping[int, int],
    taken: Collection[int],
    fresh: Iterator[int],
) -> dict[int, int]:
    """Token -> id: the base's for what is matched; new elements keep their own where the base does not have it, else
    take one that a matched element gave up, else a fresh one."""
    final = {token: matched[token] for token in tokens if token in matched}
    homeless = []
    for token in tokens:
        if token not in matched:
            if token in own and own[token] not in taken:
                final[token] = own[token]
            else:
                homeless.append(token)
    given_up = sorted(key for token, key in own.items() if token in matched and key not in taken)
    for token in sorted(homeless):
        final[token] = given_up.pop(0) if given_up else next(fresh)
    return final


def _renames(
    assignment: Assignment, lanes: dict[int, int], crossings: dict[int, int]
) -> Iterator[tuple[ElementKey, int]]:
    for kind, own, final in (
        (ElementKind.LANE_SEGMENT, assignment.own_lane_ids, lanes),
        (ElementKind.PEDESTRIAN_CROSSING, assignment.own_crossing_ids, crossings),
    ):
        for token, before in own.items():
            if token in final and final[token] != before:
                yield ElementKey(kind, before), final[token]


def _with_known_objects(state: MapState, original: MapState) -> MapState:
    """The state with the original's own objects and order where nothing differs."""
    apart = sorted(state.apart(original))
    changed = [key for key in apart if state.get(key) != original.get(key)]
    put_in = [element for element in map(state.get, changed) if element is not None]
    return original.replaced(put_in, changed) if changed else original
