"""``neighbor.inconsistent``: neighbours that do not agree on their shared line (spec §5)."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterator
from typing import Any

from lanewright.core.comparison import Comparison
from lanewright.core.elements import ElementKind, LaneSegment, Line, MapState, Mark
from lanewright.core.geometry import same_plan
from lanewright.core.rules.rule import Remedy, Rule
from lanewright.core.violations import Severity, Violation

CODE = "neighbor.inconsistent"
_OPPOSITE = {"left": "right", "right": "left"}
_MIRRORED = {mark: mark.mirrored for mark in Mark}


def find(comparison: Comparison) -> Iterator[Violation]:
    """Violations for each pair of lanes of which one names the other and they do not agree."""
    lanes = comparison.edited.lanes
    found: dict[tuple[int, int], tuple[str, bool]] = {}
    for key in sorted(_worth_a_look(comparison)):
        lane = lanes[key]
        for side, other in (("left", lane.left_neighbor_id), ("right", lane.right_neighbor_id)):
            if other is None or other not in lanes:
                continue
            problem = disagreement(lane, lanes[other], side)
            if problem is not None:
                pair = (min(lane.id, other), max(lane.id, other))
                inherited = _inherited(comparison, lane, lanes[other], side, problem)
                known = found.get(pair, (problem, True))
                found[pair] = (known[0] if known[1] is False else problem, known[1] and inherited)
    for pair, (problem, inherited) in sorted(found.items()):
        yield Violation(
            CODE,
            Severity.ERROR,
            ElementKind.LANE_SEGMENT,
            tuple(sorted(set(pair))),
            f"Lanes {pair[0]} and {pair[1]} are neighbours but {problem}.",
            inherited=inherited,
        )


def _worth_a_look(comparison: Comparison) -> set[int]:
    """Lanes that were touched or name one that was, and those that disagree in the base."""
    references = comparison.survey.references
    keys = set(comparison.touched_lanes).union(comparison.survey.fact(_disagreeing_lanes))
    for lane in comparison.touched_lanes:
        keys.update(references.get(lane, ()))
    return {key for key in keys if key in comparison.edited.lanes}


def _disagreeing_lanes(state: MapState) -> frozenset[int]:
    return frozenset(
        lane.id
        for lane in state.lanes.values()
        for side, other in (("left", lane.left_neighbor_id), ("right", lane.right_neighbor_id))
        if other is not None and other in state.lanes and disagreement(lane, state.lanes[other], side) is not None
    )


def disagreement(lane: LaneSegment, other: LaneSegment, side: str) -> str | None:
    """What two lanes disagree about, where the first names the second as its neighbour on that side; or None."""
    answered = answering_side(lane, other, side)
    if answered is None:
        return f"lane {other.id} does not name lane {lane.id} back"
    line: Line = getattr(lane, f"{side}_boundary")
    theirs: Line = getattr(other, f"{answered}_boundary")
    if not same_plan(line, theirs[::-1] if answered == side else theirs):
        return "their shared line differs"
    if getattr(lane, f"{side}_mark") is not _MIRRORED[getattr(other, f"{answered}_mark")]:
        return "the mark on their shared line differs"
    return None


def answering_side(lane: LaneSegment, other: LaneSegment, side: str) -> str | None:
    """The side on which the neighbour names the lane back: the opposite one, or left for left if oncoming."""
    opposite = _OPPOSITE[side]
    if getattr(other, f"{opposite}_neighbor_id") == lane.id:
        return opposite
    if side == "left" and other.left_neighbor_id == lane.id:
        return "left"
    return None


def _inherited(comparison: Comparison, lane: LaneSegment, other: LaneSegment, side: str, problem: str) -> bool:
    """Whether the base has the same disagreement, and what disagrees was not edited."""
    base = comparison.base.lanes
    was, were = base.get(lane.id), base.get(other.id)
    if was is None or were is None or getattr(was, f"{side}_neighbor_id") != other.id:
        return False
    if was is lane and were is other:
        return True
    answered = answering_side(lane, other, side)
    if answering_side(was, were, side) != answered or disagreement(was, were, side) != problem:
        return False
    if answered is None:
        return True
    return (
        same_plan(getattr(was, f"{side}_boundary"), getattr(lane, f"{side}_boundary"))
        and same_plan(getattr(were, f"{answered}_boundary"), getattr(other, f"{answered}_boundary"))
        and getattr(was, f"{side}_mark") is getattr(lane, f"{side}_mark")
        and getattr(were, f"{answered}_mark") is getattr(other, f"{answered}_mark")
    )


def remedies(comparison: Comparison, violation: Violation) -> Iterator[Remedy]:
    """Answer the neighbour, or carry the edited mark over; else let them be neighbours no more."""
    edited = comparison.edited
    one, other = violation.elements[0], violation.elements[-1]
    for lane, neighbor in ((one, other), (other, one)):
        for side in ("left", "right"):
            if getattr(edited.lanes[lane], f"{side}_neighbor_id") == neighbor:
                yield from _agreeing(comparison, lane, neighbor, side)
    yield Remedy(f"Let lanes {one} and {other} be neighbours no more", _parted(edited, one, other))


def _agreeing(comparison: Comparison, lane: int, neighbor: int, side: str) -> Iterator[Remedy]:
    edited = comparison.edited
    mine, theirs = edited.lanes[lane], edited.lanes[neighbor]
    answered = answering_side(mine, theirs, side)
    if answered is None:
        for back in dict.fromkeys((_OPPOSITE[side], side)):
            if getattr(theirs, f"{back}_neighbor_id") is None:
                fields: dict[str, Any] = {f"{back}_neighbor_id": lane}
                answering = edited.replaced([dataclasses.replace(theirs, **fields)])
                if disagreement(mine, answering.lanes[neighbor], side) is None:
                    yield Remedy(f"Let lane {neighbor} name lane {lane} back", answering)
        return
    if comparison.base.lanes.get(lane) == mine and comparison.base.lanes.get(neighbor) != theirs:
        return  # the neighbour is the edited one: its line and mark are carried over in its own turn
    line: Line = getattr(mine, f"{side}_boundary")
    fields = {
        f"{answered}_boundary": line[::-1] if answered == side else line,
        f"{answered}_mark": _MIRRORED[getattr(mine, f"{side}_mark")],
    }
    carried = edited.replaced([dataclasses.replace(theirs, **fields)])
    yield Remedy(f"Give lane {neighbor} the line and mark of lane {lane}", carried)


def _parted(state: MapState, one: int, other: int) -> MapState:
    changed = []
    for key, gone in {(one, other), (other, one)}:
        lane = state.lanes[key]
        fields: dict[str, Any] = {
            name: None for name in ("left_neighbor_id", "right_neighbor_id") if getattr(lane, name) == gone
        }
        changed.append(dataclasses.replace(lane, **fields))
    return state.replaced(changed)


RULE = Rule(
    code=CODE,
    find=find,
    remedies=remedies,
    what="A lane names a neighbour that does not name it back (right for left, or left for left of oncoming lanes), "
    "or the line they share differs: other points, or another mark (mixed marks are mirrored).",
    why="Real maps write the shared line twice, point for point. Two versions of one line would be two stories (A1).",
    mend="Move and repaint the shared line in both lanes. The fix carries the edited one over.",
    gives_way_to=("replacement.", "identity.", "insertion.", "deletion."),
)
