"""The leaves that refine the categories of a change (spec §3, paper supplement A.7)."""

from __future__ import annotations

import numpy as np

from lanewright.core.elements import LaneSegment, LaneType, Mark
from lanewright.core.geometry import Plan, plan, readable_element, resample

STATIONS = 21
SHAPE_M = 0.10
"""Width differences and uneven displacements up to this are none."""
TOPOLOGY = "geometry.topology"


def geometry_leaves(was: LaneSegment, now: LaneSegment, moved_left: bool, moved_right: bool) -> set[str]:
    """``geometry.width.*`` and ``geometry.border.*`` of a lane whose boundaries moved; a moved side always has one."""
    if not (readable_element(was) and readable_element(now)):
        return {f"geometry.border.{side}" for side, moved in _sides(moved_left, moved_right) if moved}
    lines = {
        (edited, side): resample(plan(line), STATIONS)
        for edited, lane in ((False, was), (True, now))
        for side, line in (("left", lane.left_boundary), ("right", lane.right_boundary))
    }
    # Summed by map first, so that the inverse change has the very same normals.
    sums = [lines[edited, "left"] + lines[edited, "right"] for edited in (False, True)]
    across = normals((sums[0] + sums[1]) / 4)
    widened = np.abs(_width(lines, edited=True) - _width(lines, edited=False)).max() > SHAPE_M
    leaves: set[str] = set()
    for side, moved in _sides(moved_left, moved_right):
        if not moved:
            continue
        if widened:
            leaves.add(f"geometry.width.{side}")
        shift = ((lines[True, side] - lines[False, side]) * across).sum(axis=1)
        if not widened or np.abs(shift - shift.mean()).max() > SHAPE_M:
            leaves.add(f"geometry.border.{side}")
    return leaves


def _sides(left: bool, right: bool) -> tuple[tuple[str, bool], tuple[str, bool]]:
    return ("left", left), ("right", right)


def _width(lines: dict[tuple[bool, str], Plan], *, edited: bool) -> Plan:
    across: Plan = np.hypot(*(lines[edited, "left"] - lines[edited, "right"]).T)
    return across


def normals(middle: Plan) -> Plan:
    """Unit normals (to the left) at each point by central differences, shape (n, 2); zero where it stands still."""
    tangents = np.gradient(middle, axis=0)
    length = np.hypot(*tangents.T)
    length[length == 0] = 1.0
    across: Plan = np.column_stack([-tangents[:, 1], tangents[:, 0]]) / length[:, None]
    return across


def marking_leaves(was: LaneSegment, now: LaneSegment) -> set[str]:
    """``marking.type.*`` and ``marking.color.*``: a mark is two properties, its pattern and its colour."""
    leaves: set[str] = set()
    for side, old, new in (("left", was.left_mark, now.left_mark), ("right", was.right_mark, now.right_mark)):
        leaves |= _mark_leaves(side, old, new)
    return leaves


def _mark_leaves(side: str, old: Mark, new: Mark) -> set[str]:
    leaves: set[str] = set()
    if old.pattern != new.pattern:
        leaves.add(f"marking.type.{side}")
    if old.colour != new.colour:
        leaves.add(f"marking.color.{side}")
    return leaves


def type_leaves(was: LaneSegment, now: LaneSegment) -> set[str]:
    """``type.restriction``, ``type.opening``, ``type.conversion`` and ``type.intersection``."""
    leaves: set[str] = set()
    if was.is_intersection != now.is_intersection:
        leaves.add("type.intersection")
    if was.lane_type is not now.lane_type:
        if was.lane_type is LaneType.VEHICLE:
            leaves.add("type.restriction")
        elif now.lane_type is LaneType.VEHICLE:
            leaves.add("type.opening")
        else:
            leaves.add("type.conversion")
    return leaves
