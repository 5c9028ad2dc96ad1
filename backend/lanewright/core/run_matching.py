"""Which runs of the edited map are which of the base's: the best of many pairs, no lane twice."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise

from lanewright.core.alignment import Alignment, align
from lanewright.core.assignment import Assignment
from lanewright.core.comparison import Comparison
from lanewright.core.elements import LaneSegment
from lanewright.core.geometry import readable_element
from lanewright.core.identity import continuous, one_road
from lanewright.core.roadgraph import Chain


def match_runs(
    assignment: Assignment, comparison: Comparison, pairs: Iterable[tuple[Chain, Chain]], *, cut: bool = True
) -> bool:
    """Match pairs of runs, no lane twice: first those for which no lane is cut, then those that save the most
    insertions and deletions (lanes that are one road are inserted as one), then by the fewest categories, the least
    displacement, the smallest ids. Whether there were any.

    ``cut``: also where base lanes must be cut for it.
    """
    candidates: list[tuple[tuple[float, ...], Chain, Chain, Alignment]] = []
    for deleted, inserted in pairs:
        if any((now, was) in assignment.banned for was in deleted for now in inserted):
            continue
        if any(token in assignment.parts for token in inserted) or not assignment.is_free([*deleted, *inserted]):
            continue
        was = [comparison.base.lanes[lane] for lane in deleted]
        now = [assignment.edited.lanes[token] for token in inserted]
        if not all(readable_element(lane) for lane in (*was, *now)):
            continue
        for run, alignment in _alignments(was, now):
            if alignment.parts and not cut:
                continue
            cost = (
                alignment.parts,
                -len(deleted) - sum(not one_road(one, other) for one, other in pairwise(run)),
                alignment.categories,
                round(alignment.displacement_m, 6),
                *deleted,
            )
            candidates.append((cost, deleted, tuple(lane.id for lane in run), alignment))
    used: set[int] = set()
    for _, deleted, inserted, alignment in sorted(candidates, key=lambda one: one[:3]):
        if used.isdisjoint((*deleted, *inserted)):
            used.update((*deleted, *inserted))
            assignment.match_run(deleted, inserted, alignment)
    return bool(used)


def _alignments(
    was: Sequence[LaneSegment], now: Sequence[LaneSegment]
) -> Iterator[tuple[Sequence[LaneSegment], Alignment]]:
    """The alignment of two runs; where the road does not go on from one lane to the next, those of the parts before and
    after."""
    whole = align(was, now)
    if whole is not None:
        yield now, whole
        return
    breaks = [index + 1 for index, pair in enumerate(pairwise(now)) if not continuous(*pair)]
    for first, end in pairwise([0, *breaks, len(now)] if breaks else []):
        part = align(was, now[first:end])
        if part is not None:
            yield now[first:end], part
