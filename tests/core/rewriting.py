"""Random edits that an annotator may make, and random ways to write the same map differently."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from random import Random

from lanewright.core.elements import LaneSegment, LaneType, Line, MapState, Mark
from lanewright.core.identity import fresh_id, one_road, renamed, unlinked, with_lanes_exchanged
from lanewright.core.roadgraph import RoadGraph
from lanewright.core.series import Run

Rewrite = Callable[[Random, MapState], MapState]


def any_lane(random: Random, state: MapState) -> LaneSegment:
    return state.lanes[random.choice(sorted(state.lanes))]


def repaint(random: Random, state: MapState) -> MapState:
    side = random.choice(("left", "right"))
    return on_both_sides(state, any_lane(random, state), side, mark=random.choice(list(Mark)))


def bend(random: Random, state: MapState) -> MapState:
    lane, side = any_lane(random, state), random.choice(("left", "right"))
    line = list(getattr(lane, f"{side}_boundary"))
    if len(line) < 3:
        return state
    at = random.randrange(1, len(line) - 1)
    by = random.choice((0.02, 0.3, 0.8))
    x, y, z = line[at]
    line[at] = (x + random.uniform(-by, by), y + random.uniform(-by, by), z)
    return on_both_sides(state, lane, side, line=tuple(line))


def on_both_sides(
    state: MapState, lane: LaneSegment, side: str, line: Line | None = None, mark: Mark | None = None
) -> MapState:
    """A boundary moved or repainted in every lane that shares it, mixed marks mirrored."""
    old = [point[:2] for point in getattr(lane, f"{side}_boundary")]
    changed = []
    for other in state.lanes.values():
        fields = {}
        for where in ("left", "right"):
            here = [point[:2] for point in getattr(other, f"{where}_boundary")]
            if old not in (here, here[::-1]):
                continue
            if line is not None:
                fields[f"{where}_boundary"] = line if here == old else line[::-1]
            if mark is not None:
                fields[f"{where}_mark"] = mark if where == side and here == old else mark.mirrored
        if fields:
            changed.append(dataclasses.replace(other, **fields))
    return state.replaced(changed)


def retype(random: Random, state: MapState) -> MapState:
    lane = any_lane(random, state)
    return state.replaced([dataclasses.replace(lane, lane_type=random.choice(list(LaneType)))])


def delete(random: Random, state: MapState) -> MapState:
    return unlinked(state, [any_lane(random, state).id]) if len(state.lanes) > 1 else state


def delete_crossing(random: Random, state: MapState) -> MapState:
    return unlinked(state, [], [random.choice(sorted(state.crossings))]) if state.crossings else state


def insert_beside(random: Random, state: MapState) -> MapState:
    """A lane on the right of one that has no neighbour there."""
    free = [lane for lane in state.lanes.values() if lane.right_neighbor_id is None]
    if not free:
        return state
    lane = random.choice(sorted(free, key=lambda one: one.id))
    (x0, y0, _), (x1, y1, _) = lane.left_boundary[0], lane.right_boundary[0]
    right = tuple((x + x1 - x0, y + y1 - y0, z) for x, y, z in lane.right_boundary)
    new = dataclasses.replace(
        lane,
        id=fresh_id([state]),
        left_boundary=lane.right_boundary,
        left_mark=lane.right_mark.mirrored,
        right_boundary=right,
        successors=(),
        predecessors=(),
        left_neighbor_id=lane.id,
        right_neighbor_id=None,
    )
    return state.replaced([new, dataclasses.replace(lane, right_neighbor_id=new.id)])


EDITS: tuple[Rewrite, ...] = (repaint, bend, retype, delete, delete_crossing, insert_beside)


def rename(random: Random, state: MapState) -> MapState:
    """Some lanes deleted and drawn again as they were."""
    first = fresh_id([state]) + 1000
    chosen = random.sample(sorted(state.lanes), min(len(state.lanes), random.randint(1, 4)))
    return renamed(state, {key: first + index for index, key in enumerate(chosen)})


def exchange(random: Random, state: MapState) -> MapState:
    """Two lanes under each other's ids."""
    if len(state.lanes) < 2:
        return state
    one, other = random.sample(sorted(state.lanes), 2)
    return renamed(state, {one: other, other: one})


def exchange_sides(random: Random, state: MapState) -> MapState:
    """Two neighbours under each other's ids."""
    pairs = [
        (key, other)
        for key, lane in sorted(state.lanes.items())
        if (other := lane.right_neighbor_id) in state.lanes and other != key
    ]
    if not pairs:
        return state
    one, other = random.choice(pairs)
    return renamed(state, {one: other, other: one})


def shuffle(random: Random, state: MapState) -> MapState:
    """Every id of the map exchanged."""
    lanes, crossings = sorted(state.lanes), sorted(state.crossings)
    return renamed(
        state,
        dict(zip(lanes, random.sample(lanes, len(lanes)), strict=True)),
        dict(zip(crossings, random.sample(crossings, len(crossings)), strict=True)),
    )


def cut(random: Random, state: MapState) -> MapState:
    """A lane drawn as two in series between which nothing differs."""
    lane = any_lane(random, state)
    run, share, first = Run.of([lane]), random.uniform(0.3, 0.7), fresh_id([state]) + 5000
    if min(run.ends) < 2:
        return state
    pieces = run.pieces([(run.ends[0] * share, run.ends[1] * share)])
    named = [dataclasses.replace(piece, id=first + index) for index, piece in enumerate(pieces)]
    return with_lanes_exchanged(state, [lane.id], named)


def join(random: Random, state: MapState) -> MapState:
    """Two lanes in series between which nothing differs drawn as one."""
    pairs = _pairs_of_one_road(state)
    if not pairs:
        return state
    pair = random.choice(pairs)
    whole = Run.of([state.lanes[key] for key in pair]).pieces([])[0]
    return with_lanes_exchanged(state, pair, [dataclasses.replace(whole, id=fresh_id([state]) + 9000)])


def shift_joint(random: Random, state: MapState) -> MapState:
    """The joint of two lanes in series between which nothing differs drawn further along the road."""
    pairs = _pairs_of_one_road(state)
    if not pairs:
        return state
    pair = random.choice(pairs)
    run, share = Run.of([state.lanes[key] for key in pair]), random.uniform(0.2, 0.8)
    pieces = run.pieces([(run.ends[0] * share, run.ends[1] * share)])
    named = [dataclasses.replace(piece, id=key) for piece, key in zip(pieces, pair, strict=True)]
    return with_lanes_exchanged(state, pair, named)


def _pairs_of_one_road(state: MapState) -> list[tuple[int, int]]:
    graph = RoadGraph.of(state)
    return [
        (one, other)
        for one in sorted(state.lanes)
        if (other := graph.next_in_series(one, state.lanes)) is not None
        and other != one
        and one_road(state.lanes[one], state.lanes[other])
    ]


def reorder(random: Random, state: MapState) -> MapState:
    """Elements, link lists and crossing edges in another order."""
    lanes = [
        dataclasses.replace(lane, successors=lane.successors[::-1], predecessors=lane.predecessors[::-1])
        for lane in state.lanes.values()
    ]
    random.shuffle(lanes)
    crossings = [
        dataclasses.replace(one, edge1=one.edge2[::-1], edge2=one.edge1[::-1]) for one in state.crossings.values()
    ]
    return MapState.of([*crossings, *lanes])


def write_on_one_side(random: Random, state: MapState) -> MapState:
    """A link that both lanes write, written by one of them."""
    twice = [
        (key, other)
        for key, lane in sorted(state.lanes.items())
        for other in lane.successors
        if other in state.lanes and key in state.lanes[other].predecessors
    ]
    if not twice:
        return state
    one, other = random.choice(twice)
    silent, name, gone = random.choice(((one, "successors", other), (other, "predecessors", one)))
    links = tuple(key for key in getattr(state.lanes[silent], name) if key != gone)
    return state.replaced([dataclasses.replace(state.lanes[silent], **{name: links})])


REWRITES: tuple[Rewrite, ...] = (
    rename,
    exchange,
    exchange_sides,
    shuffle,
    cut,
    join,
    shift_joint,
    reorder,
    write_on_one_side,
)


def several(random: Random, state: MapState, among: tuple[Rewrite, ...], count: int) -> MapState:
    for _ in range(count):
        state = random.choice(among)(random, state)
    return state
