"""Maps at the limits of what a file may hold, each with an edit; the whole engine put to them in a process of its own.

python -m tests.fuzz.extreme_maps NAME     prints what the engine found and the memory it took
"""

from __future__ import annotations

import dataclasses
import resource
import sys
from collections.abc import Callable, Iterable, Iterator
from typing import Any

from lanewright.core.canonical import canonicalise
from lanewright.core.comparison import Comparison
from lanewright.core.diff import diff_of
from lanewright.core.elements import Element, LaneSegment, LaneType, Line, MapState, Mark, PedestrianCrossing
from lanewright.core.restore import restore
from lanewright.core.rules import check_of
from lanewright.core.sentences import describe_update, sentence

Pair = tuple[MapState, MapState]
CAP = 1e6


def lane(key: int, start: tuple[float, float], finish: tuple[float, float], **fields: Any) -> LaneSegment:
    """A lane of two straight sides, 3.5 m wide."""
    sides = {
        "left_boundary": tuple((x, y + 3.5, 0.0) for x, y in (start, finish)),
        "right_boundary": tuple((x, y, 0.0) for x, y in (start, finish)),
    }
    marks = {"is_intersection": False, "lane_type": LaneType.VEHICLE, "left_mark": Mark.NONE, "right_mark": Mark.NONE}
    return LaneSegment(key, **(marks | sides | fields))


def _state(elements: Iterable[Element]) -> MapState:
    return MapState.of(elements)


def _repainted(state: MapState, every: int = 7) -> MapState:
    return _state(
        dataclasses.replace(one, left_mark=Mark.SOLID_WHITE)
        if isinstance(one, LaneSegment) and one.id % every == 0
        else one
        for one in state
    )


def _without(state: MapState, every: int) -> MapState:
    return _state(one for one in state if one.id % every)


def _renumbered(state: MapState, by: int = 1_000_000) -> MapState:
    return _state(
        dataclasses.replace(
            one,
            id=one.id + by,
            successors=tuple(other + by for other in one.successors),
            predecessors=tuple(other + by for other in one.predecessors),
        )
        for one in state.lanes.values()
    )


def one_vertex() -> Pair:
    """150 lanes that end where 150 others start, all linked."""
    into = [lane(key, (-20.0, 4.0 * key), (0.0, 0.0), successors=tuple(range(1000, 1150))) for key in range(150)]
    out = [lane(1000 + key, (0.0, 0.0), (20.0, 4.0 * key)) for key in range(150)]
    base = _state([*into, *out])
    return base, _without(_repainted(base), 50)


def ring() -> Pair:
    """1,000 lanes in a ring; all of them under other ids."""
    count = 1000
    spots = [
        (3.0 * key if key < count / 2 else 3.0 * (count - key), 0.0 if key < count / 2 else 9.0) for key in range(count)
    ]
    base = _state(
        lane(key, spots[key], spots[(key + 1) % count], successors=((key + 1) % count,)) for key in range(count)
    )
    return base, _renumbered(base)


def self_links() -> Pair:
    """300 lanes that lead to themselves."""
    base = _state(
        lane(key, (30.0 * key, 0.0), (30.0 * key + 20, 0.0), successors=(key,), predecessors=(key,))
        for key in range(300)
    )
    return base, _without(_repainted(base), 3)


def points_without_length() -> Pair:
    """300 lanes whose sides are one point twice; half of them elsewhere after the edit."""
    base = _state(lane(key, (5.0 * key, 0.0), (5.0 * key, 0.0)) for key in range(300))
    return base, _state(lane(key, (5.0 * key, key % 2), (5.0 * key, key % 2)) for key in range(300))


def at_the_cap() -> Pair:
    """Lanes across the whole of the allowed plane, 2,800 km long; five of them bent, and 55 drawn anew."""
    base = _state(lane(key, (-CAP, -CAP + key), (CAP, CAP - 10 * key), successors=(key + 1,)) for key in range(5))
    return base, _state(
        lane(key, (-CAP, -CAP + key), (CAP, CAP - 11 * key), successors=(key + 1,)) for key in range(60)
    )


def collapsed_crossings() -> Pair:
    """60 crossings with edges of no length, moved, and as many drawn anew."""

    def crossings(first: int, by: float) -> list[PedestrianCrossing]:
        edges: list[Line] = [((4.0 * key + by, 0.0, 0.0),) * 2 for key in range(60)]
        return [PedestrianCrossing(first + key, edge, edge) for key, edge in enumerate(edges)]

    return _state(crossings(0, 0.0)), _state([*crossings(0, 0.5)[:30], *crossings(1000, 0.1)[30:]])


def most_points() -> Pair:
    """A lane with the most points that a line may have; the middle of one side moved."""

    def dense(moved_m: float) -> LaneSegment:
        left, right = (
            tuple(
                (0.05 * index, side + 0.02 * (index % 2) + (moved_m if side and 4_000 < index < 6_000 else 0.0), 0.0)
                for index in range(10_000)
            )
            for side in (3.5, 0.0)
        )
        return dataclasses.replace(lane(1, (0.0, 0.0), (1.0, 0.0)), left_boundary=left, right_boundary=right)

    return _state([dense(0.0)]), _state([dense(0.3)])


def oncoming_on_each_other() -> Pair:
    """80 two-way streets of two lanes on the same ground; every second pair drawn anew."""

    def streets(first: int, keys: Iterable[int]) -> list[LaneSegment]:
        found = []
        for key in keys:
            one = lane(first + 2 * key, (0.0, 8.0 * key), (40.0, 8.0 * key))
            turned = {"left_boundary": one.right_boundary[::-1], "right_boundary": one.left_boundary[::-1]}
            found += [one, dataclasses.replace(one, id=first + 2 * key + 1, **turned)]
        return found

    return _state(streets(0, range(80))), _state([*streets(0, range(0, 80, 2)), *streets(5000, range(1, 80, 2))])


def all_dangling() -> Pair:
    """600 lanes with 200 links each, none of them in the map, all of them others after the edit."""

    def lanes(first: int) -> list[LaneSegment]:
        rim = tuple(range(first, first + 200))
        return [lane(key, (0.0, 4.0 * key), (9.0, 4.0 * key), successors=rim, predecessors=rim) for key in range(600)]

    return _state(lanes(10_000)), _state(lanes(20_000))


def one_place() -> Pair:
    """60 lanes on each other, all under other ids."""
    base = _state(lane(key, (0.0, 0.0), (20.0, 0.0), successors=((key + 1) % 60,)) for key in range(60))
    return base, _renumbered(base)


def crowded() -> Pair:
    """400 lanes on each other, without links; all of them moved by a metre at one end."""

    def lanes(by: float) -> Iterator[LaneSegment]:
        return (lane(key, (0.0, 0.0), (20.0, by)) for key in range(400))

    return _state(lanes(0.0)), _state(lanes(1.0))


def far_apart() -> Pair:
    """400 lanes, each by itself, each under another id: as many updates, violations and fixes."""
    spots = [(60.0 * (key % 20), 30.0 * (key // 20)) for key in range(400)]
    base = _state(lane(key, (x, y), (x + 20, y)) for key, (x, y) in enumerate(spots))
    return base, _renumbered(base)


def tangled() -> Pair:
    """A lane whose sides go to and fro 1,500 times across each other; one of them drawn the other way round."""
    to_and_fro = tuple((0.01 * index, 100.0 * (index % 2), 0.0) for index in range(3_000))
    across = tuple((100.0 * (index % 2), 0.01 * index, 0.0) for index in range(3_000))
    base = _state([lane(1, (0.0, 0.0), (1.0, 0.0), left_boundary=to_and_fro, right_boundary=across)])
    return base, _state([dataclasses.replace(base.lanes[1], right_boundary=across[::-1])])


def cut_to_pieces() -> Pair:
    """One lane of 800 m becomes 400 in series."""
    base = _state([lane(1, (0.0, 0.0), (800.0, 0.0))])
    pieces = [lane(10 + key, (2.0 * key, 0.0), (2.0 * key + 2, 0.0), successors=(11 + key,)) for key in range(400)]
    return base, _state(pieces)


def nothing_in_common() -> Pair:
    """Two grids of 144 lanes side by side, far apart, with other ids."""

    def grid(first: int, by: float) -> MapState:
        return _state(
            lane(
                first + 12 * row + column,
                (20.0 * column + by, 4.0 * row),
                (20.0 * column + 20 + by, 4.0 * row),
                successors=(first + 12 * row + column + 1,) if column < 11 else (),
            )
            for row in range(12)
            for column in range(12)
        )

    return grid(0, 0.0), grid(1000, 2000.0)


EXTREMES: dict[str, Callable[[], Pair]] = {
    build.__name__: build
    for build in (
        one_vertex,
        ring,
        self_links,
        points_without_length,
        at_the_cap,
        collapsed_crossings,
        most_points,
        oncoming_on_each_other,
        all_dangling,
        one_place,
        crowded,
        far_apart,
        tangled,
        cut_to_pieces,
        nothing_in_common,
    )
}


def explore(base: MapState, edited: MapState) -> str:
    """Everything that the engine does with two maps; what came out, in a line."""
    comparison = Comparison(base, edited)
    changes = diff_of(comparison)
    told = [str(sentence(change, comparison.base, comparison.edited)) for change in changes.changes]
    told += [str(describe_update(one, changes.changes, comparison.base, comparison.edited)) for one in changes.updates]
    violations = check_of(comparison)
    restore(base, edited)
    canonicalise(base, edited)
    return f"{len(changes.changes)} changes, {len(changes.updates)} updates, {len(violations)} violations"


if __name__ == "__main__":
    found = explore(*EXTREMES[sys.argv[1]]())
    print(f"{found}, {resource.getrusage(resource.RUSAGE_SELF).ru_maxrss // 1024} MiB")
