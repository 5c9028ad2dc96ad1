"""A run of the base and the run of the edited map that took its place: which piece of road is which lane.

The base's lanes give the segmentation. A joint of the edited run stays where something differs across it; where
nothing does, it stays only if that costs no change of category, since cuts in series are no change (spec §2).
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from lanewright.core.elements import LaneSegment
from lanewright.core.geometry import centreline, distance_m, end_midpoint, moved
from lanewright.core.identity import continuous, joinable, one_road
from lanewright.core.series import NEAR_M, Run, Station, along, apart_m

_Cut = tuple[Station, int | None]
"""Where a run is cut, and which joint of the base that is, if any."""


@dataclass(frozen=True, slots=True)
class Piece:
    """A piece of the edited run, and the base lane it is (or is a part of)."""

    lane: LaneSegment
    base: int
    is_part: bool


@dataclass(frozen=True, slots=True)
class Alignment:
    """The edited run in the base's segmentation.

    Attributes:
        pieces: in driving direction.
        recut: whether joints differ from the edited run's own.
        categories: how many categories of change the pieces have.
        displacement_m: mean distance of the two centrelines.
    """

    pieces: tuple[Piece, ...]
    recut: bool
    categories: int
    displacement_m: float

    @property
    def parts(self) -> int:
        """How many pieces are parts of a cut lane."""
        return sum(piece.is_part for piece in self.pieces)


def align(base: Sequence[LaneSegment], edited: Sequence[LaneSegment]) -> Alignment | None:
    """The best alignment: fewest cut lanes, then fewest changed categories, rather the edited run's own joints. None
    where nothing can be cut: lanes are of no length, or the road does not go on from one to the next."""
    was, now = Run.of(base), Run.of(edited)
    displacement = displacement_m(was.whole, now.whole)
    candidates: list[Alignment] = []
    if len(base) == len(edited):
        pieces = tuple(Piece(lane, old.id, False) for lane, old in zip(edited, base, strict=True))
        candidates.append(Alignment(pieces, False, _categories(was, pieces), displacement))
    if (len(base) > 1 or len(edited) > 1) and all(itertools.starmap(continuous, itertools.pairwise(edited))):
        for snap in (NEAR_M, 0.0):
            recut = _recut(was, now, snap)
            if recut is not None:
                candidates.append(Alignment(recut, True, _categories(was, recut), displacement))
    return min(candidates, key=lambda one: (one.parts, one.categories), default=None)


def displacement_m(one: LaneSegment, other: LaneSegment) -> float:
    """Mean distance of two centrelines at equal fractions of their lengths."""
    return float(np.hypot(*(centreline(one) - centreline(other)).T).mean())


def categories_between(was: LaneSegment, now: LaneSegment) -> int:
    """How many of geometry, marking and type differ."""
    return (
        (moved(was.left_boundary, now.left_boundary) or moved(was.right_boundary, now.right_boundary))
        + (was.left_mark is not now.left_mark or was.right_mark is not now.right_mark)
        + (was.lane_type is not now.lane_type or was.is_intersection != now.is_intersection)
    )


def _categories(was: Run, pieces: Sequence[Piece]) -> int:
    """Changed categories of all pieces; a part is compared with the base cut alike."""
    lanes = {lane.id: lane for lane in was.lanes}
    total = 0
    for piece in pieces:
        before = lanes[piece.base]
        if not piece.is_part:
            total += categories_between(before, piece.lane)
            continue
        alone = Run.of([before])
        start = alone.station_of(piece.lane.left_boundary[0], piece.lane.right_boundary[0])
        finish = alone.station_of(piece.lane.left_boundary[-1], piece.lane.right_boundary[-1])
        inner = [station for station in (start, finish) if 0 < station[0] < alone.ends[0] and station[1] > 0]
        cut = alone.pieces(inner)
        total += min(categories_between(part, piece.lane) for part in cut)
    return total


def _recut(was: Run, now: Run, snap_m: float) -> tuple[Piece, ...] | None:
    """The edited run cut at the base's joints, and where its own properties change; None if it cannot be cut there."""
    fixed = [
        index
        for index, (one, other) in enumerate(zip(now.lanes, now.lanes[1:], strict=False))
        if not one_road(one, other)
    ]
    goals = [_goal(was, now, joint) for joint in was.joints]
    taken = _matched_joints(was, now, fixed, goals)
    stations: list[_Cut] = []
    for index, goal in enumerate(goals):
        if index in taken:
            stations.append((now.joints[taken[index]], index))
        else:
            stations.append((_snapped(now, goal, snap_m), index))
    stations += [(now.joints[index], None) for index in fixed if index not in taken.values()]
    ordered = _ordered(stations, now.ends)
    kept = [station for station, _ in ordered]
    if any(now.joints[index] not in kept for index in fixed):
        return None
    return _pieces(was, now, ordered)


def _goal(was: Run, now: Run, joint: Station) -> Station:
    """Where a joint of the base lies on the edited run: across from it, else at the same fraction of the length."""
    left, right = was.place(joint)
    (a, away_a), (b, away_b) = along(now.whole.left_boundary, left), along(now.whole.right_boundary, right)
    if max(away_a, away_b) <= NEAR_M:
        return (a, b)
    # A boundary of no length (all its points are one) has no fractions.
    shares = [part / whole if whole > 0 else 0.0 for part, whole in zip(joint, was.ends, strict=True)]
    return (shares[0] * now.ends[0], shares[1] * now.ends[1])


def _matched_joints(was: Run, now: Run, fixed: Sequence[int], goals: Sequence[Station]) -> dict[int, int]:
    """Base joints by index and the edited joints that they are: near, or with the same change of properties. The
    nearest pairs come first; no two cross."""
    matched: dict[int, int] = {}
    for same_transition in (False, True):
        pairs = [
            (apart_m(now.joints[joint], goal), index, joint)
            for index, goal in enumerate(goals)
            for joint in fixed
            if index not in matched
            and (
                _same_transition(was, index, now, joint)
                if same_transition
                else apart_m(now.joints[joint], goal) <= NEAR_M
            )
        ]
        for _, index, joint in sorted(pairs):
            if index not in matched and all(
                joint != other and (joint > other) == (index > known) for known, other in matched.items()
            ):
                matched[index] = joint
    return matched


def _same_transition(was: Run, index: int, now: Run, joint: int) -> bool:
    return (
        not joinable(was.lanes[index], was.lanes[index + 1])
        and joinable(was.lanes[index], now.lanes[joint])
        and joinable(was.lanes[index + 1], now.lanes[joint + 1])
    )


def _snapped(now: Run, goal: Station, snap_m: float) -> Station:
    """The edited run's own joint near the goal, if any; else the goal."""
    near = [joint for joint in now.joints if apart_m(joint, goal) <= snap_m]
    return min(near, key=lambda joint: apart_m(joint, goal), default=goal)


def _ordered(stations: list[_Cut], ends: Station) -> list[_Cut]:
    """Stations in driving order, each strictly beyond the one before on both sides; those that are not are dropped
    (of a base joint and an edited one at the same place the base joint stands)."""
    kept: list[_Cut] = []
    last = -1
    for station, joint in sorted(stations, key=lambda item: (sum(item[0]), item[1] is None, item[1])):
        low = kept[-1][0] if kept else (0.0, 0.0)
        if low[0] < station[0] < ends[0] and low[1] < station[1] < ends[1] and (joint is None or joint > last):
            kept.append((station, joint))
            last = last if joint is None else joint
    return kept


def _pieces(was: Run, now: Run, cuts: list[_Cut]) -> tuple[Piece, ...]:
    lanes = now.pieces([station for station, _ in cuts])
    joints = [joint for _, joint in cuts if joint is not None]
    bounds = [-1, *joints, len(was.lanes) - 1]
    pieces: list[Piece] = []
    stretch: list[LaneSegment] = []
    for lane, joint in zip(lanes, [*(joint for _, joint in cuts), bounds[-1]], strict=True):
        stretch.append(lane)
        if joint is not None:
            owner = _nearest(was.lanes[bounds[0] + 1 : bounds[1] + 1], stretch)
            pieces += [Piece(part, owner, len(stretch) > 1) for part in stretch]
            stretch, bounds = [], bounds[1:]
    return tuple(pieces)


def _nearest(lanes: Sequence[LaneSegment], stretch: Sequence[LaneSegment]) -> int:
    """Which of the base lanes between two joints a stretch is: where joints fell away, the one that is nearest."""
    start, finish = end_midpoint(stretch[0], 0), end_midpoint(stretch[-1], 1)
    return min(
        lanes, key=lambda lane: distance_m(start, end_midpoint(lane, 0)) + distance_m(finish, end_midpoint(lane, 1))
    ).id
