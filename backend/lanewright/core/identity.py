"""Giving lanes other ids and joining lanes in series, with every reference to them."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from typing import Any

from lanewright.core.attributes import LARGEST_ID
from lanewright.core.elements import Element, ElementKey, ElementKind, LaneSegment, Line, MapState
from lanewright.core.geometry import lines_of
from lanewright.core.survey import Survey, ids_named

WIDEST_GAP_M = 0.01
"""Linked ends further apart than this do not meet (spec §5, ``link.gap``)."""


def renamed(state: MapState, lanes: Mapping[int, int], crossings: Mapping[int, int] | None = None) -> MapState:
    """The state with lanes and crossings under other ids, all at once; links and neighbours follow.

    Unrelated elements stay the same objects.
    """
    changed: list[Element] = []
    gone = [ElementKey(ElementKind.LANE_SEGMENT, key) for key in lanes]
    for key in _having_or_naming(state, lanes):
        named = _renamed_lane(state.lanes[key], lanes)
        if named is not state.lanes[key]:
            changed.append(named)
    for key, new in (crossings or {}).items():
        if key in state.crossings:
            changed.append(dataclasses.replace(state.crossings[key], id=new))
            gone.append(ElementKey(ElementKind.PEDESTRIAN_CROSSING, key))
    return state.replaced(changed, gone) if changed else state


def _having_or_naming(state: MapState, ids: Collection[int]) -> list[int]:
    """The lanes that have one of the ids or name it, ascending; among them may be some that once did."""
    if not ids:
        return []
    origin, edited = state.origin
    references = Survey(origin).references
    found = set(ids).union(*(references.get(key, ()) for key in ids))
    found.update(key.id for key in edited if key.kind is ElementKind.LANE_SEGMENT)
    return sorted(key for key in found if key in state.lanes)


def _renamed_lane(lane: LaneSegment, ids: Mapping[int, int]) -> LaneSegment:
    changed: dict[str, Any] = {}
    names = ids.keys()
    if lane.id in ids:
        changed["id"] = ids[lane.id]
    for name in ("successors", "predecessors"):
        links: tuple[int, ...] = getattr(lane, name)
        if not names.isdisjoint(links):
            changed[name] = tuple(dict.fromkeys(ids.get(other, other) for other in links))
    for name in ("left_neighbor_id", "right_neighbor_id"):
        other = getattr(lane, name)
        if other in ids:
            changed[name] = ids[other]
    return dataclasses.replace(lane, **changed) if changed else lane


def joined(parts: Sequence[LaneSegment]) -> LaneSegment:
    """Lanes in series as one, under the first one's id: lines run on, the joint's vertex is written once.

    Neighbours: kept where all parts name the same one.
    """
    first, last = parts[0], parts[-1]
    return dataclasses.replace(
        first,
        left_boundary=_run_on([part.left_boundary for part in parts]),
        right_boundary=_run_on([part.right_boundary for part in parts]),
        successors=last.successors,
        left_neighbor_id=_common(part.left_neighbor_id for part in parts),
        right_neighbor_id=_common(part.right_neighbor_id for part in parts),
    )


def _run_on(lines: Sequence[Line]) -> Line:
    points = list(lines[0])
    for line in lines[1:]:
        points += line[1:] if points[-1][:2] == line[0][:2] else line
    return tuple(points)


def _common(ids: Iterable[int | None]) -> int | None:
    named = set(ids)
    return named.pop() if len(named) == 1 else None


def joinable(one: LaneSegment, other: LaneSegment) -> bool:
    """Whether nothing differs between two lanes in series: marks, type and intersection (spec §2, cuts)."""
    return (
        one.left_mark is other.left_mark
        and one.right_mark is other.right_mark
        and one.lane_type is other.lane_type
        and one.is_intersection == other.is_intersection
    )


def one_road(one: LaneSegment, other: LaneSegment) -> bool:
    """Whether two lanes in series are one piece of road: it goes on from one to the other, and nothing differs."""
    return joinable(one, other) and continuous(one, other)


def continuous(one: LaneSegment, other: LaneSegment) -> bool:
    """Whether two lanes in series may be parts of one lane: their ends meet, and nothing else joins there, beyond the
    rim of the map either."""
    if not {one.id}.issuperset(other.predecessors) or not {other.id}.issuperset(one.successors):
        return False
    return all(
        before and after and math.dist(before[-1][:2], after[0][:2]) <= WIDEST_GAP_M
        for before, after in zip(lines_of(one), lines_of(other), strict=True)
    )


def with_lanes_exchanged(state: MapState, old: Sequence[int], new: Sequence[LaneSegment]) -> MapState:
    """The state with lanes in series (``old``) taken out and other lanes in series put in their place.

    Links into the first and out of the last stay, inner links are rewritten, and neighbours are found anew: lanes
    that share a line, point for point, are neighbours.
    """
    first, last = state.lanes[old[0]], state.lanes[old[-1]]
    into = {old[0]: new[0].id}
    out_of = {old[-1]: new[-1].id}
    gone = set(old)
    put_in = [
        dataclasses.replace(
            piece,
            predecessors=_relinked(first.predecessors, out_of, gone) if index == 0 else (new[index - 1].id,),
            successors=_relinked(last.successors, into, gone) if index == len(new) - 1 else (new[index + 1].id,),
        )
        for index, piece in enumerate(new)
    ]
    lanes = state.lanes.copy()
    loose: set[int] = {piece.id for piece in new}
    for key in gone:
        del lanes[key]
    for key, lane in lanes.items():
        fields: dict[str, Any] = {}
        if not gone.isdisjoint(lane.successors):
            fields["successors"] = _relinked(lane.successors, into, gone)
        if not gone.isdisjoint(lane.predecessors):
            fields["predecessors"] = _relinked(lane.predecessors, out_of, gone)
        for name in ("left_neighbor_id", "right_neighbor_id"):
            if getattr(lane, name) in gone:
                fields[name] = None
                loose.add(key)
        if fields:
            lanes[key] = dataclasses.replace(lane, **fields)
    lanes |= {piece.id: piece for piece in put_in}
    found = with_neighbors_found(lanes, loose)
    changed = [lane for key, lane in found.items() if lane is not state.lanes.get(key)]
    return state.replaced(changed, [ElementKey(ElementKind.LANE_SEGMENT, key) for key in gone])


def _relinked(links: tuple[int, ...], ids: Mapping[int, int], gone: set[int]) -> tuple[int, ...]:
    return tuple(ids.get(other, other) for other in links if other in ids or other not in gone)


def with_neighbors_found(lanes: dict[int, LaneSegment], loose: Iterable[int]) -> dict[int, LaneSegment]:
    """The lanes where each loose one is the neighbour of whoever has the same line beside it and no other there."""
    by_line: dict[tuple[tuple[float, float], ...], list[tuple[int, str]]] = {}
    for key, lane in lanes.items():
        by_line.setdefault(tuple(point[:2] for point in lane.left_boundary), []).append((key, "left"))
        by_line.setdefault(tuple(point[:2] for point in lane.right_boundary), []).append((key, "right"))
    for key in sorted(loose):
        for side, opposite in (("left", "right"), ("right", "left")):
            if getattr(lanes[key], f"{side}_neighbor_id") is not None:
                continue
            line = tuple(point[:2] for point in getattr(lanes[key], f"{side}_boundary"))
            beside = [(other, opposite) for other, where in by_line.get(line, ()) if where == opposite]
            if side == "left":
                beside += [(other, "left") for other, where in by_line.get(line[::-1], ()) if where == "left"]
            for other, where in sorted(beside):
                if other != key and getattr(lanes[other], f"{where}_neighbor_id") is None:
                    mine: dict[str, Any] = {f"{side}_neighbor_id": other}
                    theirs: dict[str, Any] = {f"{where}_neighbor_id": key}
                    lanes[key] = dataclasses.replace(lanes[key], **mine)
                    lanes[other] = dataclasses.replace(lanes[other], **theirs)
                    break
    return lanes


def unlinked(state: MapState, lanes: Iterable[int], crossings: Iterable[int] = ()) -> MapState:
    """The state without those elements; whoever named a removed lane names it no more."""
    gone = set(lanes)
    left = [_without(state.lanes[key], gone) for key in _having_or_naming(state, gone) if key not in gone]
    removed = [ElementKey(ElementKind.LANE_SEGMENT, key) for key in gone]
    removed += [ElementKey(ElementKind.PEDESTRIAN_CROSSING, key) for key in crossings]
    return state.replaced(left, removed)


def _without(lane: LaneSegment, gone: set[int]) -> LaneSegment:
    changed: dict[str, Any] = {
        name: tuple(other for other in getattr(lane, name) if other not in gone)
        for name in ("successors", "predecessors")
        if not gone.isdisjoint(getattr(lane, name))
    }
    changed |= {name: None for name in ("left_neighbor_id", "right_neighbor_id") if getattr(lane, name) in gone}
    return dataclasses.replace(lane, **changed) if changed else lane


def without_link(lanes: Mapping[int, LaneSegment], link: tuple[int, int]) -> list[LaneSegment]:
    """The lanes of a link, naming each other no more in that direction; only those that did."""
    upstream, downstream = link
    changed = []
    if downstream in lanes[upstream].successors:
        changed.append((upstream, "successors", downstream))
    if upstream in lanes[downstream].predecessors:
        changed.append((downstream, "predecessors", upstream))
    updated: dict[int, LaneSegment] = {}
    for key, name, other in changed:
        lane = updated.get(key, lanes[key])
        fields: dict[str, Any] = {name: tuple(named for named in getattr(lane, name) if named != other)}
        updated[key] = dataclasses.replace(lane, **fields)
    return list(updated.values())


def fresh_id(states: Iterable[MapState], also_taken: Iterable[ElementKey] = ()) -> int:
    """The first of the fresh ids."""
    return next(fresh_ids(states, also_taken))


def fresh_ids(states: Iterable[MapState], also_taken: Iterable[ElementKey] = ()) -> Iterator[int]:
    """Ids that the maps neither have nor name, nor the others given: from above them all, then from the gaps."""
    taken = {key.id for key in also_taken}.union(*(Survey(state).fact(ids_named) for state in states))
    yield from range(max(taken, default=0) + 1, LARGEST_ID + 1)
    yield from (key for key in range(1, LARGEST_ID + 1) if key not in taken)
