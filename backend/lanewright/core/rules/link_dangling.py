"""``link.dangling``: a lane names an id that no map knows (spec §5)."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterator, Mapping
from typing import Any

from lanewright.core.comparison import Comparison
from lanewright.core.elements import ElementKind, LaneSegment
from lanewright.core.rules.rule import Remedy, Rule
from lanewright.core.violations import Severity, Violation
from lanewright.core.wording import lanes_named

CODE = "link.dangling"


def find(comparison: Comparison) -> Iterator[Violation]:
    """Violations for each lane that names ids neither in the edited map nor on the rim of the base."""
    lanes = comparison.edited.lanes
    rim: set[int] | None = None
    for lane in lanes.values():
        absent = [other for other in named(lane) if other not in lanes]
        if not absent:
            continue
        if rim is None:
            rim = rim_ids(comparison.base.lanes)
        dangling = sorted(set(absent) - rim)
        if dangling:
            yield Violation(
                CODE,
                Severity.ERROR,
                ElementKind.LANE_SEGMENT,
                (lane.id,),
                f"Lane {lane.id} names {lanes_named(dangling)}, which {'is' if len(dangling) == 1 else 'are'} not in "
                "the map: take the reference out.",
            )


def named(lane: LaneSegment) -> Iterator[int]:
    """All ids that a lane names: links and neighbours."""
    yield from lane.successors
    yield from lane.predecessors
    if lane.left_neighbor_id is not None:
        yield lane.left_neighbor_id
    if lane.right_neighbor_id is not None:
        yield lane.right_neighbor_id


def rim_ids(lanes: Mapping[int, LaneSegment]) -> set[int]:
    """Ids that the lanes name without being among them: what lies beyond the crop."""
    return {other for lane in lanes.values() for other in named(lane) if other not in lanes}


def remedies(comparison: Comparison, violation: Violation) -> Iterator[Remedy]:
    """Take the unknown ids out of the lane's lists."""
    lanes = comparison.edited.lanes
    known = lanes.keys() | rim_ids(comparison.base.lanes)
    lane = lanes[violation.elements[0]]
    fields: dict[str, Any] = {
        name: tuple(other for other in getattr(lane, name) if other in known) for name in ("successors", "predecessors")
    }
    fields |= {name: None for name in ("left_neighbor_id", "right_neighbor_id") if getattr(lane, name) not in known}
    mended = comparison.edited.replaced([dataclasses.replace(lane, **fields)])
    yield Remedy(f"Take the unknown ids out of lane {lane.id}", mended)


RULE = Rule(
    code=CODE,
    find=find,
    remedies=remedies,
    what="A lane names a successor, predecessor or neighbour that is neither in the map nor on the rim of the base (an "
    "id beyond the crop that the base itself names).",
    why="A reference to nothing leaves open which road is meant (A1). It mostly stays behind when a lane is deleted.",
    mend="Take the id out of the list. The fix does.",
    gives_way_to=("replacement.", "identity.", "insertion.", "deletion."),
)
