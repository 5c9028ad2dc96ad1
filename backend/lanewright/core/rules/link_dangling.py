"""``link.dangling``: a lane names an id that no map knows (spec §5)."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterator
from typing import Any

from lanewright.core.comparison import Comparison
from lanewright.core.elements import ElementKind
from lanewright.core.rules.rule import Remedy, Rule
from lanewright.core.survey import named_by
from lanewright.core.violations import Severity, Violation
from lanewright.core.wording import lanes_named

CODE = "link.dangling"


def find(comparison: Comparison) -> Iterator[Violation]:
    """Violations for each lane that names ids neither in the edited map nor on the rim of the base."""
    lanes = comparison.edited.lanes
    references = comparison.survey.references
    keys = set(comparison.touched_lanes)
    for deleted in comparison.deleted_lanes:
        keys.update(key for key in references.get(deleted, ()) if key in lanes)
    for key in sorted(keys):
        dangling = sorted({other for other in named_by(lanes[key]) if not _known(comparison, other)})
        if dangling:
            yield Violation(
                CODE,
                Severity.ERROR,
                ElementKind.LANE_SEGMENT,
                (key,),
                f"Lane {key} names {lanes_named(dangling)}, which {'is' if len(dangling) == 1 else 'are'} not in "
                "the map: take the reference out.",
            )


def _known(comparison: Comparison, key: int) -> bool:
    """Whether an id is in the edited map or on the rim: named by the base without being in it."""
    return key in comparison.edited.lanes or (key in comparison.survey.references and key not in comparison.base.lanes)


def remedies(comparison: Comparison, violation: Violation) -> Iterator[Remedy]:
    """Take the unknown ids out of the lane's lists."""
    lane = comparison.edited.lanes[violation.elements[0]]
    fields: dict[str, Any] = {
        name: tuple(other for other in getattr(lane, name) if _known(comparison, other))
        for name in ("successors", "predecessors")
    }
    fields |= {
        name: None
        for name in ("left_neighbor_id", "right_neighbor_id")
        if (other := getattr(lane, name)) is not None and not _known(comparison, other)
    }
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
