"""A road that winds uphill: a lane became a bike lane, a side street got a right turn pocket."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from lanewright.core.changes import Direction
from lanewright.core.elements import LaneType, Mark
from lanewright.demo.path import Bend, Path, crossing_path, curve
from lanewright.demo.plan import Block, CrossSection, Junction, Plan, Road, Slot, Turn, Zebra, Zone
from lanewright.demo.scenarios.scenario import LEAD_M, Scenario, about, every, half

RIDGE_BEFORE_M = 200.0


def hillside(generator: np.random.Generator) -> Scenario:
    """Current world: bike lane uphill, pocket, solid lines in the bend. Predecessors are listed on one side only."""
    x, y = generator.uniform(1500, 1900), generator.uniform(300, 700)
    turn, radius = generator.uniform(56, 68), generator.uniform(46, 56)
    bends = (Bend(LEAD_M + 95.0), *curve(turn, radius), Bend(110.0), *curve(-25, 110, 20), Bend(120.0))
    path = Path(x, y, math.radians(generator.uniform(18, 34)), bends)
    bend_end = LEAD_M + 95.0 + sum(bend.length for bend in bends[1:4])
    lane = about(generator, 3.3)
    stale, current = (_plan(path, bend_end, lane, updated=updated) for updated in (False, True))
    return Scenario(
        name="hillside",
        city="PIT",
        season="Spring_2020",
        source_split="train",
        split="train",
        direction=Direction.CURRENT_TO_PRIOR,
        stale=stale,
        current=current,
        route=("grade/0/along.0/forward/1", "grade/3/along.0/forward/1"),
        drive=(LEAD_M - 8.0, 195.0),
        one_sided=True,
    )


def _plan(path: Path, bend_end: float, lane: float, *, updated: bool) -> Plan:
    hollow = crossing_path(path, LEAD_M + 55.0, -78.0, 0.0, 70.0, (*curve(-35, 70, 18), Bend(140.0)))
    court = crossing_path(path, bend_end + 24.0, 88.0, 0.0, 50.0, (*curve(40, 45, 12), Bend(140.0)))
    ridge = crossing_path(path, bend_end + 96.0, 74.0, RIDGE_BEFORE_M, 210.0)
    roads = (
        Road("grade", path, _grade_blocks(lane, updated=updated), 5.8, 6.9),
        Road("hollow", hollow, (_hollow_block(updated=updated),), 6.5, 5.6),
        Road("court", court, (_court_block(),), 2.9, 2.9),
        Road("ridge", ridge, (_ridge_block(narrow=updated), _ridge_block(narrow=False)), 5.6, 5.6),
    )
    junctions = (
        Junction(
            "hollow-end", {"grade": LEAD_M + 55.0, "hollow": 0.0}, {"hollow+": Zebra(3.0, 2.1 if updated else 0.9)}, 6.5
        ),
        Junction(
            "court-end",
            {"grade": bend_end + 24.0, "court": 0.0},
            {"grade-": Zebra(3.2, 0.8)} if updated else {},
            5.5,
        ),
        Junction(
            "crest",
            {"grade": bend_end + 96.0, "ridge": RIDGE_BEFORE_M},
            {"ridge+": Zebra(), "grade+": Zebra()} | ({} if updated else {"grade-": Zebra()}),
            7.0,
        ),
    )
    return Plan({road.name: road for road in roads}, junctions)


def _grade_blocks(lane: float, *, updated: bool) -> tuple[Block, ...]:
    """Uphill two lanes, the outer one a bike lane since the update; downhill one."""
    first = Slot("1", lane, Mark.SOLID_WHITE if updated else Mark.DASHED_WHITE)
    second = Slot("2", 2.1, Mark.NONE, LaneType.BIKE, Turn.THROUGH) if updated else Slot("2", 3.0)
    uphill, downhill = half(first, second), half(Slot("1", 3.4, Mark.SOLID_WHITE))
    plain = CrossSection(uphill, downhill)
    bend = CrossSection(uphill, downhill, Mark.DOUBLE_SOLID_YELLOW if updated else Mark.SOLID_DASH_YELLOW)
    crest = CrossSection(uphill, half(Slot("1", 3.4)), Mark.SOLID_YELLOW)
    return (
        Block(plain, cuts=(-0.34,), tile_cuts=every(60.0, 130.0)),
        Block(bend, cuts=(18.0, 78.0)),
        Block(plain, tile_cuts=(28.0,)),
        Block(crest, cuts=every(60.0, 150.0)),
    )


def _hollow_block(*, updated: bool) -> Block:
    plain = CrossSection(half(Slot("1", 3.2)), half(Slot("1", 3.2)), Mark.DASHED_YELLOW)
    through, right = Slot("1", 3.1, Mark.SOLID_WHITE, turns=Turn.LEFT), Slot("right", 2.9, turns=Turn.RIGHT, parent="1")
    incoming = half(through, right) if updated else half(Slot("1", 3.2))
    near = CrossSection(half(Slot("1", 3.2)), incoming, Mark.SOLID_YELLOW)
    return Block(plain, start=Zone(near, 20.0, 16.0), cuts=every(65.0, 240.0))


def _court_block() -> Block:
    """Two-way without a centre line: two lanes on the same ground."""
    section = CrossSection(half(Slot("1", 4.4), inner=-2.2), half(Slot("1", 4.4), inner=-2.2), Mark.NONE)
    return Block(section, cuts=every(65.0, 200.0))


def _ridge_block(*, narrow: bool) -> Block:
    """One lane each way with room to park; edge lines narrow it in the update, and a right turn goes."""
    lane = Slot("1", 2.95, Mark.SOLID_WHITE) if narrow else Slot("1", 3.3)
    towards = replace(lane, turns=Turn.LEFT | Turn.THROUGH) if narrow else lane
    return Block(CrossSection(half(towards), half(lane), Mark.SOLID_DASH_YELLOW), tile_cuts=every(60.0, 190.0))
