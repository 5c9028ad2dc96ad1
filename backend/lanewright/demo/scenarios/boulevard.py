"""A boulevard with a median: a bus lane, a bike lane and a left turn pocket are new, a right turn is gone."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from lanewright.core.changes import Direction
from lanewright.core.elements import LaneType, Mark
from lanewright.demo.path import Bend, Path, crossing_path, curve
from lanewright.demo.plan import Block, CrossSection, Half, Junction, Plan, Road, Slot, Turn, Zebra, Zone
from lanewright.demo.scenarios.scenario import LEAD_M, Scenario, about, bike, every, half, left_pocket

CURB = 13.4
MEDIAN_HALF = 2.0
PALM_BEFORE_M = 210.0
COVE_BEFORE_M = 200.0


def boulevard(generator: np.random.Generator) -> Scenario:
    """The map on disk is stale; the sweeps show the world after the update."""
    x, y = generator.uniform(-1300, -1000), generator.uniform(2000, 2400)
    path = Path(x, y, math.radians(generator.uniform(186, 200)), (Bend(LEAD_M + 250.0), Bend(150.0, 0.0, -1 / 300)))
    lane, angle = about(generator, 3.3, 0.05), generator.uniform(-94, -86)
    stale, current = (_plan(path, angle, lane, updated=updated) for updated in (False, True))
    return Scenario(
        name="boulevard",
        city="MIA",
        season="Winter_2021",
        source_split="val",
        split="test",
        direction=Direction.PRIOR_TO_CURRENT,
        stale=stale,
        current=current,
        route=("boulevard/0/along.0/forward/1", "palm/2/along.0/forward/1"),
        drive=(LEAD_M + 22.0, 185.0),
    )


def _plan(path: Path, angle: float, lane: float, *, updated: bool) -> Plan:
    palm = crossing_path(path, LEAD_M + 130.0, -angle, PALM_BEFORE_M, 290.0)
    cove = crossing_path(palm, PALM_BEFORE_M + 90.0, 90.0, COVE_BEFORE_M, 230.0)
    bay = crossing_path(path, LEAD_M + 235.0, -88.0, 0.0, 55.0, (*curve(40, 50, 20), Bend(130.0)))
    roads = (
        Road("boulevard", path, _boulevard_blocks(lane, updated=updated), CURB, CURB),
        Road("palm", palm, _palm_blocks(updated=updated), 5.9, 5.9),
        Road("cove", cove, (_cove_block(), _cove_block()), 4.6, 4.6),
        Road("bay", bay, (_bay_block(updated=updated),), 5.2, 5.2),
    )
    zebras = {"palm+": Zebra(3.6, 1.9 if updated else 0.8), "boulevard+": Zebra(4.0, 1.0)}
    zebras["boulevard-" if updated else "palm-"] = Zebra(4.0, 1.0)
    junctions = (
        Junction("signal", {"boulevard": LEAD_M + 130.0, "palm": PALM_BEFORE_M}, zebras, 8.0),
        Junction("bay-end", {"boulevard": LEAD_M + 235.0, "bay": 0.0}, {"bay+": Zebra(3.0, 1.0)}, 7.0),
        Junction("shade", {"palm": PALM_BEFORE_M + 90.0, "cove": COVE_BEFORE_M}, {"cove-": Zebra(2.8, 0.8)}, 5.0),
    )
    return Plan({road.name: road for road in roads}, junctions)


def _boulevard_blocks(lane: float, *, updated: bool) -> tuple[Block, ...]:
    through = Turn.THROUGH

    def east(*, pocket: bool = False, near: bool = False) -> Half:
        """Three lanes, the outer one for buses since the update; a pocket in the median."""
        line = Mark.SOLID_WHITE if near else Mark.DASHED_WHITE
        first = Slot("1", lane, line, turns=through if pocket else Turn.LEFT | through)
        second = Slot("2", lane, Mark.DASH_SOLID_WHITE if updated else line, turns=through)
        third = Slot("3", lane + 0.1, turns=through | Turn.RIGHT)
        if updated:
            third = replace(third, lane_type=LaneType.BUS)
        slots = (left_pocket(), first, second, third) if pocket else (first, second, third)
        return half(*slots, inner=MEDIAN_HALF - (3.0 if pocket else 0.0))

    def west(*, near: bool = False, right: bool = True) -> Half:
        """Three lanes, and a bike lane behind a double line since the update."""
        line = Mark.SOLID_WHITE if near else Mark.DASHED_WHITE
        first = Slot("1", lane, line, turns=Turn.LEFT | through)
        third = Slot("3", lane + 0.3, turns=through | Turn.RIGHT if right else through)
        lanes = (first, Slot("2", lane, line, turns=through), third)
        if not updated:
            return half(*lanes, inner=MEDIAN_HALF)
        return half(
            *lanes[:2], replace(third, width=lane - 0.2, outer=Mark.DOUBLE_SOLID_WHITE), bike(1.8), inner=MEDIAN_HALF
        )

    yellow = Mark.SOLID_YELLOW
    plain = CrossSection(east(), west(), yellow)
    return (
        Block(
            plain,
            end=Zone(CrossSection(east(pocket=updated, near=True), west(), yellow), 30.0, 20.0),
            tile_cuts=every(60.0, 190.0),
        ),
        Block(
            plain,
            start=Zone(CrossSection(east(), west(near=True, right=not updated), yellow), 24.0, 0.0),
            tile_cuts=(50.0,),
        ),
        Block(plain, tile_cuts=every(60.0, 150.0)),
    )


def _palm_blocks(*, updated: bool) -> tuple[Block, ...]:
    """One way, two lanes."""

    def section(line: Mark) -> CrossSection:
        return CrossSection(half(Slot("1", 3.3, line), Slot("2", 3.4), inner=-3.3), centre=Mark.SOLID_YELLOW)

    near = section(Mark.SOLID_WHITE if updated else Mark.DASHED_WHITE)
    dashed = section(Mark.DASHED_WHITE)
    return (
        Block(dashed, end=Zone(near, 22.0, 0.0), tile_cuts=every(60.0, 160.0)),
        Block(dashed, cuts=(-0.38,)),
        Block(dashed, tile_cuts=every(60.0, 190.0)),
    )


def _cove_block() -> Block:
    """Two-way without a centre line: two lanes on the same ground."""
    section = CrossSection(half(Slot("1", 5.0), inner=-2.5), half(Slot("1", 5.0), inner=-2.5), Mark.NONE)
    return Block(section, tile_cuts=every(60.0, 220.0))


def _bay_block(*, updated: bool) -> Block:
    lane = half(Slot("1", 3.2))
    return Block(
        CrossSection(lane, lane, Mark.DOUBLE_SOLID_YELLOW if updated else Mark.DASHED_YELLOW), cuts=every(60.0, 190.0)
    )
