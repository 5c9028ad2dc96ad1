"""Giving lanes other ids and joining lanes in series, with every reference to them."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from lanewright.core.elements import Element, ElementKey, LaneSegment, Line, MapState
from lanewright.core.geometry import same_plan


def renamed(state: MapState, lanes: Mapping[int, int], crossings: Mapping[int, int] | None = None) -> MapState:
    """The state with lanes and crossings under other ids, all at once; links and neighbours follow.

    Unrelated elements stay the same objects.
    """
    renamed_lanes = [_renamed_lane(lane, lanes) for lane in state.lanes.values()]
    renamed_crossings = [
        dataclasses.replace(crossing, id=crossings[crossing.id]) if crossings and crossing.id in crossings else crossing
        for crossing in state.crossings.values()
    ]
    elements: list[Element] = [*renamed_lanes, *renamed_crossings]
    return MapState.of(sorted(elements, key=lambda element: element.key))


def _renamed_lane(lane: LaneSegment, ids: Mapping[int, int]) -> LaneSegment:
    changed: dict[str, Any] = {}
    if lane.id in ids:
        changed["id"] = ids[lane.id]
    for name in ("successors", "predecessors"):
        links: tuple[int, ...] = getattr(lane, name)
        if any(other in ids for other in links):
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


def with_series_joined(state: MapState, parts: Sequence[int]) -> MapState:
    """The state with lanes in series joined into the first of them; whoever named a part names that one."""
    whole = joined([state.lanes[part] for part in parts])
    ids = dict.fromkeys(parts, parts[0])
    gone = set(parts)
    rest = [_renamed_lane(lane, ids) for key, lane in state.lanes.items() if key not in gone]
    others: list[Element] = [*rest, _renamed_lane(whole, ids), *state.crossings.values()]
    return with_neighbors_settled(
        MapState.of(sorted(others, key=lambda element: element.key)),
        [whole.id, *(lane.id for lane in rest if whole.id in (lane.left_neighbor_id, lane.right_neighbor_id))],
    )


def with_neighbors_settled(state: MapState, lanes: Iterable[int]) -> MapState:
    """The state where the named lanes keep a neighbour id only if the neighbour shares that very line."""
    changed = []
    for key in lanes:
        lane = state.lanes[key]
        fields: dict[str, Any] = {
            f"{side}_neighbor_id": None
            for side in ("left", "right")
            if (named := getattr(lane, f"{side}_neighbor_id")) is not None
            and named in state.lanes
            and not shares_line(lane, state.lanes[named], side)
        }
        if fields:
            changed.append(dataclasses.replace(lane, **fields))
    return state.replaced(changed) if changed else state


def shares_line(lane: LaneSegment, neighbor: LaneSegment, side: str) -> bool:
    """Whether a neighbour names the lane back and has the same line on the shared side (reversed if oncoming)."""
    line: Line = getattr(lane, f"{side}_boundary")
    if side == "left" and neighbor.left_neighbor_id == lane.id and neighbor.right_neighbor_id != lane.id:
        return same_plan(line, neighbor.left_boundary[::-1])
    opposite = "right" if side == "left" else "left"
    return getattr(neighbor, f"{opposite}_neighbor_id") == lane.id and same_plan(
        line, getattr(neighbor, f"{opposite}_boundary")
    )


def unlinked(state: MapState, lanes: Iterable[int], crossings: Iterable[int] = ()) -> MapState:
    """The state without those elements; whoever named a removed lane names it no more."""
    gone, gone_crossings = set(lanes), set(crossings)
    kept: list[Element] = []
    for lane in state.lanes.values():
        if lane.id not in gone:
            kept.append(_without(lane, gone))
    kept += [crossing for crossing in state.crossings.values() if crossing.id not in gone_crossings]
    return MapState.of(kept)


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
    """The smallest id above all that the maps have or name, and above the others given."""
    taken = {key.id for key in also_taken}
    for state in states:
        taken.update(state.crossings)
        for lane in state.lanes.values():
            taken.update((lane.id, *lane.successors, *lane.predecessors))
            taken.update(other for other in (lane.left_neighbor_id, lane.right_neighbor_id) if other is not None)
    return max(taken, default=0) + 1
