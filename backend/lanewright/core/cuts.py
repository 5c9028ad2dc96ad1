"""Recorded cuts (spec §2): a lane whose property changes half-way is cut in base and edited map alike.

The record is ``part_of`` on the parts. Where one map has the parts of a lane and the other still has it whole, the
whole is cut at the parts' joints before anything is compared, so the parts survive as themselves.
"""

from __future__ import annotations

import dataclasses
import itertools
import math
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from lanewright.core.elements import ElementKey, LaneSegment, Line, MapState
from lanewright.core.geometry import readable_element
from lanewright.core.identity import joinable, with_lanes_exchanged
from lanewright.core.roadgraph import RoadGraph
from lanewright.core.series import SAME_POINT_M, Run
from lanewright.core.survey import Survey, parts_recorded


def cut_alike(base: MapState, edited: MapState, apart: Iterable[ElementKey]) -> tuple[MapState, MapState]:
    """Both maps with the cuts that the other one records; the very same objects where there are none.

    ``apart``: what is not one object in both maps; only among those can be new parts.
    """
    before = Survey(base).fact(parts_recorded)
    after: dict[int, list[int]] = {}
    for element in map(edited.get, sorted(apart)):
        if isinstance(element, LaneSegment) and element.part_of is not None:
            after.setdefault(element.part_of, []).append(element.id)
    if not before and not after:
        return base, edited
    return cut_like(base, edited, after), cut_like(edited, base, before)


def cut_like(state: MapState, other: MapState, recorded: Mapping[int, Sequence[int]]) -> MapState:
    """The state with each lane cut of which the other map has the parts."""
    for lane, parts in recorded.items():
        if lane in state.lanes and not any(part in state.lanes for part in parts) and lane not in other.lanes:
            order = _in_series(other, parts)
            if order and readable_element(state.lanes[lane]) and _legal([other.lanes[part] for part in order]):
                state = _cut(state, lane, [other.lanes[part] for part in order])
    return state


def _in_series(state: MapState, parts: Iterable[int]) -> tuple[int, ...]:
    """The parts in driving order, if they are one series of two or more; else none."""
    wanted = set(parts)
    if len(wanted) < 2 or not all(readable_element(state.lanes[part]) for part in wanted):
        return ()
    chains = RoadGraph.of(state).chains(wanted)
    return chains[0] if len(chains) == 1 else ()


def _legal(parts: Sequence[LaneSegment]) -> bool:
    """Whether something differs across every joint."""
    return not any(joinable(one, other) for one, other in itertools.pairwise(parts))


def _cut(state: MapState, lane: int, parts: Sequence[LaneSegment]) -> MapState:
    """The state with that lane cut where the parts meet; as it is where a boundary has no length to be cut."""
    whole = Run.of([state.lanes[lane]])
    stations = [whole.station_of(part.left_boundary[-1], part.right_boundary[-1]) for part in parts[:-1]]
    ends = whole.ends
    steps = [(0.0, 0.0), *stations, ends]
    if any(one[0] >= other[0] or one[1] >= other[1] for one, other in itertools.pairwise(steps)):
        lengths = Run.of(parts)
        total = lengths.ends
        if 0.0 in total:
            return state
        stations = [(ends[0] * joint[0] / total[0], ends[1] * joint[1] / total[1]) for joint in lengths.joints]
    pieces = [
        dataclasses.replace(piece, id=part.id, part_of=lane)
        for piece, part in zip(whole.pieces(stations), parts, strict=True)
    ]
    return with_lanes_exchanged(state, [lane], _with_joints_of(parts, pieces))


def _with_joints_of(parts: Sequence[LaneSegment], pieces: list[LaneSegment]) -> list[LaneSegment]:
    """The pieces with the parts' own joints where these are the same points but for rounding: what was cut once is the
    same to the last digit however often it is cut."""
    for name in ("left_boundary", "right_boundary"):
        lines: list[Line] = [getattr(piece, name) for piece in pieces]
        for index, part in enumerate(parts[:-1]):
            joint = getattr(part, name)[-1]
            if math.dist(joint[:2], lines[index][-1][:2]) <= SAME_POINT_M:
                lines[index] = (*lines[index][:-1], joint)
                lines[index + 1] = (joint, *lines[index + 1][1:])
        fields: list[dict[str, Any]] = [{name: line} for line in lines]
        pieces = [dataclasses.replace(piece, **field) for piece, field in zip(pieces, fields, strict=True)]
    return pieces


def marked_as_parts(state: MapState, parts: Iterable[int], whole: int) -> MapState:
    """The state with the cut recorded on the parts."""
    fields: dict[str, Any] = {"part_of": whole}
    return state.replaced([dataclasses.replace(state.lanes[part], **fields) for part in parts])
