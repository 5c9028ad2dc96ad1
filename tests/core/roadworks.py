"""Random edits at joints, junctions and crossings, beside those of ``rewriting``; each leaves the map as it was where
there is no room for it."""

from __future__ import annotations

import dataclasses
import math
from random import Random

from tests.core.rewriting import EDITS, Rewrite, any_lane

from lanewright.core.elements import LaneSegment, LaneType, Line, MapState, PedestrianCrossing, Point
from lanewright.core.identity import fresh_id, without_link
from lanewright.core.roadgraph import Link, RoadGraph

WIDEST_GAP_M = 60.0
CROSSING_WIDTH_M = 3.0


def move_joint(random: Random, state: MapState) -> MapState:
    """A point where lanes meet, moved in all lanes that have it."""
    lane = any_lane(random, state)
    old = random.choice((lane.left_boundary, lane.right_boundary))[random.choice((0, -1))]
    by = random.choice((0.02, 0.3, 0.8))
    new = (old[0] + random.uniform(-by, by), old[1] + random.uniform(-by, by), old[2])
    moved = []
    for other in state.lanes.values():
        lines = {
            side: tuple(new if point[:2] == old[:2] else point for point in getattr(other, side))
            for side in ("left_boundary", "right_boundary")
        }
        if any(getattr(other, side) != line for side, line in lines.items()):
            moved.append(dataclasses.replace(other, **lines))
    return state.replaced(moved)


def stretch(random: Random, state: MapState) -> MapState:
    """A lane that leads nowhere made longer or shorter, and lanes beside it that end at the same points with it."""
    graph = RoadGraph.of(state)
    loose = [lane for key, lane in sorted(state.lanes.items()) if not graph.successors[key]]
    if not loose:
        return state
    lane, by = random.choice(loose), random.choice((-6.0, -2.0, 1.0, 5.0, 20.0))
    moved = {}
    for line in (lane.left_boundary, lane.right_boundary):
        dx, dy = _step(*line[-2:])
        length = math.hypot(dx, dy)
        if length + by > 0.5:
            moved[line[-1][:2]] = _shifted(line[-1], (dx / length * by, dy / length * by))
    ending = [
        other
        for other in state.lanes.values()
        if {other.left_boundary[-1][:2], other.right_boundary[-1][:2]} & moved.keys()
    ]
    if any(graph.successors[other.id] for other in ending):
        return state
    return state.replaced(
        dataclasses.replace(
            other,
            left_boundary=_with_last_moved(other.left_boundary, moved),
            right_boundary=_with_last_moved(other.right_boundary, moved),
        )
        for other in ending
    )


def _with_last_moved(line: Line, moved: dict[tuple[float, float], Point]) -> Line:
    return (*line[:-1], moved.get(line[-1][:2], line[-1]))


def toggle_intersection(random: Random, state: MapState) -> MapState:
    lane = any_lane(random, state)
    return state.replaced([dataclasses.replace(lane, is_intersection=not lane.is_intersection)])


def fill_gap(random: Random, state: MapState) -> MapState:
    """A lane from one that leads nowhere to one ahead of it that nothing leads to."""
    graph = RoadGraph.of(state)
    loose = [lane for key, lane in sorted(state.lanes.items()) if not graph.successors[key]]
    awaiting = [lane for key, lane in sorted(state.lanes.items()) if not graph.predecessors[key]]
    gaps = [(one, other) for one in loose for other in awaiting if one is not other and _lies_ahead(one, other)]
    if not gaps:
        return state
    one, other = random.choice(gaps)
    new = dataclasses.replace(
        one,
        id=fresh_id([state]),
        left_boundary=(one.left_boundary[-1], other.left_boundary[0]),
        right_boundary=(one.right_boundary[-1], other.right_boundary[0]),
        successors=(other.id,),
        predecessors=(one.id,),
        left_neighbor_id=None,
        right_neighbor_id=None,
        part_of=None,
    )
    return state.replaced(
        [
            new,
            dataclasses.replace(one, successors=(*one.successors, new.id)),
            dataclasses.replace(other, predecessors=(*other.predecessors, new.id)),
        ]
    )


def drive_on(random: Random, state: MapState) -> MapState:
    """A lane in the direction of one that leads nowhere, like it or of another type."""
    graph = RoadGraph.of(state)
    loose = [key for key in sorted(state.lanes) if not graph.successors[key]]
    if not loose:
        return state
    one, by = state.lanes[random.choice(loose)], random.choice((2.0, 8.0, 25.0))
    ahead = []
    for line in (one.left_boundary, one.right_boundary):
        dx, dy = _step(*line[-2:])
        length = math.hypot(dx, dy)
        ahead.append((line[-1], _shifted(line[-1], (dx / length * by, dy / length * by))))
    new = dataclasses.replace(
        one,
        id=fresh_id([state]),
        lane_type=random.choice((one.lane_type, one.lane_type, LaneType.BUS)),
        left_boundary=ahead[0],
        right_boundary=ahead[1],
        successors=(),
        predecessors=(one.id,),
        left_neighbor_id=None,
        right_neighbor_id=None,
        part_of=None,
    )
    return state.replaced([new, dataclasses.replace(one, successors=(*one.successors, new.id))])


def insert_row(random: Random, state: MapState) -> MapState:
    """Lanes on the right of several in series that have no neighbour there, one beside each."""
    graph = RoadGraph.of(state)
    free = {lane.id for lane in state.lanes.values() if lane.right_neighbor_id is None}
    if not free:
        return state
    chain = graph.chain_through(random.choice(sorted(free)), free)
    beside = [state.lanes[key] for key in chain[: random.randint(1, 4)]]
    first = fresh_id([state])
    across = [_step(beside[0].left_boundary[0], beside[0].right_boundary[0])]
    across += [_step(lane.left_boundary[-1], lane.right_boundary[-1]) for lane in beside]
    new = [
        dataclasses.replace(
            lane,
            id=first + index,
            left_boundary=lane.right_boundary,
            left_mark=lane.right_mark.mirrored,
            right_boundary=(
                _shifted(lane.right_boundary[0], across[index]),
                _shifted(lane.right_boundary[-1], across[index + 1]),
            ),
            right_mark=beside[0].right_mark,
            successors=(first + index + 1,) if index + 1 < len(beside) else (),
            predecessors=(first + index - 1,) if index else (),
            left_neighbor_id=lane.id,
            right_neighbor_id=None,
            part_of=None,
        )
        for index, lane in enumerate(beside)
    ]
    named = [dataclasses.replace(lane, right_neighbor_id=one.id) for lane, one in zip(beside, new, strict=True)]
    return state.replaced([*new, *named])


def _lies_ahead(one: LaneSegment, other: LaneSegment) -> bool:
    """Whether straight lines from one lane's finish to another's start go on, both of them, in its direction."""
    return all(
        1.0 < math.hypot(ahead[0], ahead[1]) < WIDEST_GAP_M and ahead[0] * on[0] + ahead[1] * on[1] > 0
        for ahead, on in (
            (_step(one.left_boundary[-1], other.left_boundary[0]), _step(*one.left_boundary[-2:])),
            (_step(one.right_boundary[-1], other.right_boundary[0]), _step(*one.right_boundary[-2:])),
        )
    )


def _step(start: Point, finish: Point) -> tuple[float, float]:
    return finish[0] - start[0], finish[1] - start[1]


def link(random: Random, state: MapState) -> MapState:
    """A link between lanes that meet without one, written on both sides or on one."""
    starts: dict[tuple[Point, Point], list[int]] = {}
    for key, lane in sorted(state.lanes.items()):
        starts.setdefault((lane.left_boundary[0], lane.right_boundary[0]), []).append(key)
    known = RoadGraph.of(state).links()
    free = [
        (key, other)
        for key, lane in sorted(state.lanes.items())
        for other in starts.get((lane.left_boundary[-1], lane.right_boundary[-1]), ())
        if (key, other) not in known
    ]
    return with_link(state, random.choice(free), both=random.random() < 0.8) if free else state


def with_link(state: MapState, link: Link, *, both: bool) -> MapState:
    one, other = link
    upstream = state.lanes[one]
    state = state.replaced([dataclasses.replace(upstream, successors=(*upstream.successors, other))])
    downstream = state.lanes[other]
    if both:
        state = state.replaced([dataclasses.replace(downstream, predecessors=(*downstream.predecessors, one))])
    return state


def open_gap(random: Random, state: MapState) -> MapState:
    """The end of a lane drawn back from where it led; the lanes beside it stay."""
    lane, by = any_lane(random, state), random.choice((0.3, 4.0))
    lines = {}
    for side in ("left_boundary", "right_boundary"):
        line = getattr(lane, side)
        dx, dy = _step(*line[-2:])
        length = math.hypot(dx, dy)
        if length < by + 0.5:
            return state
        lines[side] = (*line[:-1], _shifted(line[-1], (-dx / length * by, -dy / length * by)))
    return state.replaced([dataclasses.replace(lane, **lines)])


def forget_neighbor(random: Random, state: MapState) -> MapState:
    """A lane that names its neighbour on the left no more, but is named by it."""
    beside = [lane for _, lane in sorted(state.lanes.items()) if lane.left_neighbor_id is not None]
    return state.replaced([dataclasses.replace(random.choice(beside), left_neighbor_id=None)]) if beside else state


def unlink(random: Random, state: MapState) -> MapState:
    links = sorted(RoadGraph.of(state).links())
    return state.replaced(without_link(state.lanes, random.choice(links))) if links else state


def insert_crossing(random: Random, state: MapState) -> MapState:
    """A crossing over the start of a lane."""
    lane = any_lane(random, state)
    left, right = lane.left_boundary[0], lane.right_boundary[0]
    dx, dy = _step(*lane.left_boundary[:2])
    length = math.hypot(dx, dy)
    ahead = (dx / length * CROSSING_WIDTH_M, dy / length * CROSSING_WIDTH_M)
    new = PedestrianCrossing(fresh_id([state]), (left, right), (_shifted(left, ahead), _shifted(right, ahead)))
    return state.replaced([new])


def move_crossing(random: Random, state: MapState) -> MapState:
    if not state.crossings:
        return state
    crossing = state.crossings[random.choice(sorted(state.crossings))]
    reach = random.choice((0.02, 1.0, 5.0))
    by = (random.uniform(-reach, reach), random.uniform(-reach, reach))
    edges = {name: tuple(_shifted(point, by) for point in getattr(crossing, name)) for name in ("edge1", "edge2")}
    return state.replaced([dataclasses.replace(crossing, **edges)])


def _shifted(point: Point, by: tuple[float, float]) -> Point:
    return point[0] + by[0], point[1] + by[1], point[2]


ALL_EDITS: tuple[Rewrite, ...] = (
    *EDITS,
    move_joint,
    stretch,
    toggle_intersection,
    fill_gap,
    drive_on,
    insert_row,
    open_gap,
    forget_neighbor,
    link,
    unlink,
    insert_crossing,
    move_crossing,
)
