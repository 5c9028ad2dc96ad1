"""Junctions: the lanes that connect the arms for every movement, and the crossings in front of the arms."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from lanewright.core.elements import LaneType, Line, Mark
from lanewright.demo.ground import Ground
from lanewright.demo.path import Array
from lanewright.demo.plan import CrossSection, Half, Junction, Road, Slot, Turn
from lanewright.demo.street import LaneDraft

THROUGH_WITHIN_DEGREES = 40.0
CURVE_POINTS = 24


@dataclass(frozen=True, slots=True)
class Arm:
    """One road's end at a junction. ``outbound`` is the direction of the road's path away from the junction (±1)."""

    name: str
    road: Road
    station: float
    outbound: int
    section: CrossSection

    @property
    def heading_in(self) -> float:
        """Direction of the traffic that enters the junction, radians."""
        return self.road.path.heading_at(self.station) + (math.pi if self.outbound > 0 else 0.0)

    @property
    def incoming(self) -> Half:
        return self.section.backward if self.outbound > 0 else self.section.forward

    @property
    def outgoing(self) -> Half:
        return self.section.forward if self.outbound > 0 else self.section.backward

    def point(self, to_the_right: float, *, incoming: bool, beyond: float = 0.0) -> Array:
        """A point (2,) on the arm's line, ``to_the_right`` of its traffic; ``beyond`` metres into the junction."""
        forward = (self.outbound > 0) != incoming
        side = -1.0 if forward else 1.0
        station = self.station - self.outbound * beyond
        return np.asarray(self.road.path.points([station], [side * to_the_right])[0])


def _turn(entering: Arm, leaving: Arm) -> tuple[Turn, float]:
    """Movement between two arms, and the change of heading in radians (positive to the left)."""
    change = leaving.heading_in + math.pi - entering.heading_in
    change = (change + math.pi) % (2 * math.pi) - math.pi
    if abs(change) < math.radians(THROUGH_WITHIN_DEGREES):
        return Turn.THROUGH, change
    return (Turn.LEFT if change > 0 else Turn.RIGHT), change


def connectors(junction: Junction, arms: list[Arm], ground: Ground) -> Iterator[LaneDraft]:
    """A lane for every movement that the slots allow. Its name says the function: arm, turn and rank, not the lanes."""
    for entering in arms:
        for leaving in arms:
            if leaving.name == entering.name:
                continue
            turn, _ = _turn(entering, leaving)
            for label, source, target in _movements(entering.incoming, leaving.outgoing, turn):
                name = f"{junction.name}/{entering.name}>{leaving.name}/{label}"
                left, right = _lines(entering, leaving, source, target, ground)
                lane_type = source.lane_type if source.lane_type == target.lane_type else LaneType.VEHICLE
                yield LaneDraft(name, left, right, Mark.NONE, Mark.NONE, lane_type, is_intersection=True)


def _movements(incoming: Half, outgoing: Half, turn: Turn) -> Iterator[tuple[str, Slot, Slot]]:
    """Label, source and target lane: through by name, a left turn from the leftmost, a right from the rightmost."""
    sources = [slot for slot in incoming.slots if turn in slot.turns]
    if turn is Turn.THROUGH:
        for slot in sources:
            target = outgoing.slot(slot.name)
            if target is not None:
                yield slot.name, slot, target
        return
    sources = [slot for slot in sources if slot.lane_type is not LaneType.BIKE]
    targets = [slot for slot in outgoing.slots if slot.lane_type is not LaneType.BIKE]
    if sources and targets:
        if turn is Turn.LEFT:
            yield "left", sources[0], targets[0]
        else:
            yield "right", sources[-1], targets[-1]


def _lines(entering: Arm, leaving: Arm, source: Slot, target: Slot, ground: Ground) -> tuple[Line, Line]:
    begin, end = entering.incoming.lines()[source.name], leaving.outgoing.lines()[target.name]
    headings = entering.heading_in, leaving.heading_in + math.pi
    left, right = (
        ground.survey(
            _curve(
                entering.point(begin[side], incoming=True),
                headings[0],
                leaving.point(end[side], incoming=False),
                headings[1],
            )
        )
        for side in (0, 1)
    )
    return left, right


def _curve(start: Array, heading_start: float, end: Array, heading_end: float) -> Array:
    """A cubic from one pose to another: handles reach towards the corner of the tangents, or a third of the way."""
    u = np.array([math.cos(heading_start), math.sin(heading_start)])
    v = np.array([math.cos(heading_end), math.sin(heading_end)])
    span = end - start
    reach_start = reach_end = float(np.linalg.norm(span)) / 3
    cross = u[0] * v[1] - u[1] * v[0]
    if abs(cross) > math.sin(math.radians(25)):
        to_corner = (span[0] * v[1] - span[1] * v[0]) / cross
        from_corner = (u[0] * span[1] - u[1] * span[0]) / cross
        if to_corner > 0.5 and from_corner > 0.5:
            reach_start, reach_end = 0.58 * to_corner, 0.58 * from_corner
    t = np.linspace(0, 1, CURVE_POINTS)[:, None]
    first, second = start + u * reach_start, end - v * reach_end
    points = (1 - t) ** 3 * start + 3 * (1 - t) ** 2 * t * first + 3 * (1 - t) * t**2 * second + t**3 * end
    return np.asarray(points)


def crossings(junction: Junction, arms: list[Arm], ground: Ground) -> Iterator[tuple[str, Line, Line]]:
    """Name and both edges of each crossing, edges along the walking direction, from curb to curb."""
    for arm in arms:
        zebra = junction.zebras.get(arm.name)
        if zebra is None:
            continue
        road, edges = arm.road, []
        for reach in (zebra.setback, zebra.setback + zebra.width):
            station = arm.station - arm.outbound * reach
            edges.append(ground.survey(road.path.points([station, station], [road.curb_left, -road.curb_right])))
        edges = [(edge[0], edge[-1]) for edge in edges]
        yield f"{junction.name}/{arm.name}/crossing", edges[0], edges[1]
