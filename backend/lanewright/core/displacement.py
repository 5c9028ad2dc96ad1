"""How far and which way boundaries and crossings moved, in numbers and words."""

from __future__ import annotations

import math

import numpy as np

from lanewright.core.elements import LaneSegment, PedestrianCrossing
from lanewright.core.geometry import MOVED_M, Plan, centreline, length_m, moved, plan, readable_element, resample
from lanewright.core.leaves import SHAPE_M, STATIONS, normals
from lanewright.core.wording import listed, metres


def lane_length_m(lane: LaneSegment) -> float:
    """Length of the centreline; 0 for a lane that cannot be read."""
    return length_m(centreline(lane)) if readable_element(lane) else 0.0


def _stations(was: LaneSegment, now: LaneSegment) -> dict[tuple[bool, str], Plan]:
    return {
        (edited, side): resample(plan(getattr(lane, f"{side}_boundary")), STATIONS)
        for edited, lane in ((False, was), (True, now))
        for side in ("left", "right")
    }


def reshaping(was: LaneSegment, now: LaneSegment) -> str:
    """``widened``, ``narrowed``, ``lengthened``, ``shortened``, ``moved`` or ``reshaped``."""
    if not (readable_element(was) and readable_element(now)):
        return "reshaped"
    lines = _stations(was, now)
    before, after = (np.hypot(*(lines[edited, "left"] - lines[edited, "right"]).T) for edited in (False, True))
    wider = after - before
    if np.abs(wider).max() > SHAPE_M and abs(wider.sum()) > 0.5 * np.abs(wider).sum():
        return "widened" if wider.sum() > 0 else "narrowed"
    longer = lane_length_m(now) - lane_length_m(was)
    shifts = [np.abs(_shift(lines, side)).max() for side in ("left", "right")]
    if abs(longer) > max(shifts):
        return "lengthened" if longer > 0 else "shortened"
    return "moved" if np.abs(wider).max() <= SHAPE_M else "reshaped"


def side_shift(was: LaneSegment, now: LaneSegment, side: str) -> str:
    """``right boundary 1.4 m in, 38 m long``; empty where the side did not move."""
    before, after = getattr(was, f"{side}_boundary"), getattr(now, f"{side}_boundary")
    if not moved(before, after):
        return ""
    if not (readable_element(was) and readable_element(now)):
        return f"{side} boundary redrawn"
    lines = _stations(was, now)
    shift = _shift(lines, side)
    peak = float(shift[np.abs(shift).argmax()])
    length = length_m(plan(after))
    longer = length - length_m(plan(before))
    if abs(peak) <= MOVED_M and abs(longer) <= MOVED_M:
        along = float(np.hypot(*(lines[True, side] - lines[False, side]).T).max())
        return f"{side} boundary {metres(along)} along"
    if abs(peak) <= MOVED_M or abs(longer) > 2 * abs(peak):
        return f"{side} boundary {metres(abs(longer))} {'longer' if longer > 0 else 'shorter'}"
    out = (peak > 0) == (side == "left")
    touched = float((np.abs(shift) > MOVED_M).mean()) * length
    return f"{side} boundary {metres(abs(peak))} {'out' if out else 'in'}, {metres(touched)} long"


def _shift(lines: dict[tuple[bool, str], Plan], side: str) -> Plan:
    """Displacement to the left at each station."""
    across = normals(np.mean(list(lines.values()), axis=0))
    shift: Plan = ((lines[True, side] - lines[False, side]) * across).sum(axis=1)
    return shift


def crossing_size(crossing: PedestrianCrossing) -> str:
    """``11 m long, 3.0 m wide``."""
    if not readable_element(crossing):
        return "of no readable size"
    return f"{metres(_length(crossing))} long, {metres(_width(crossing))} wide"


def crossing_shift(was: PedestrianCrossing, now: PedestrianCrossing) -> str:
    """How far the middle moved and how the size changed."""
    if not (readable_element(was) and readable_element(now)):
        return "redrawn"
    (x0, y0), (x1, y1) = _middle(was), _middle(now)
    words = []
    away = math.hypot(x1 - x0, y1 - y0)
    if away > MOVED_M:
        words.append(f"{metres(away)} away")
    for name, before, after in (("long", _length(was), _length(now)), ("wide", _width(was), _width(now))):
        if abs(after - before) > MOVED_M:
            words.append(f"{metres(before)} → {metres(after)} {name}")
    return listed(words) if words else "turned"


def _length(crossing: PedestrianCrossing) -> float:
    return (length_m(plan(crossing.edge1)) + length_m(plan(crossing.edge2))) / 2


def _width(crossing: PedestrianCrossing) -> float:
    one, other = plan(crossing.edge1), plan(crossing.edge2)
    straight = float(np.hypot(*(one - other).T).mean())
    crossed = float(np.hypot(*(one - other[::-1]).T).mean())
    return min(straight, crossed)


def _middle(crossing: PedestrianCrossing) -> tuple[float, float]:
    x, y = np.vstack([plan(crossing.edge1), plan(crossing.edge2)]).mean(axis=0)
    return float(x), float(y)
