"""An avenue in the grid: a signalised junction with turn lanes, a new bike lane, a new bus lane."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from lanewright.core.changes import Direction
from lanewright.core.elements import LaneType, Mark
from lanewright.demo.path import Bend, Path, crossing_path, curve
from lanewright.demo.plan import Block, CrossSection, Half, Junction, Plan, Road, Slot, Turn, Zebra, Zone
from lanewright.demo.scenarios.scenario import LEAD_M, Scenario, about, bike, every, half, left_pocket

STRAIGHT_ON = Turn.THROUGH | Turn.RIGHT
CURB = 11.0
SHIFT = 1.5
"""The centre line gives way to a left pocket by this much."""


def avenue(generator: np.random.Generator) -> Scenario:
    """Current world: bike lane, bus lane and crossings that the stale map lacks."""
    x, y = generator.uniform(2200, 2600), generator.uniform(3600, 3900)
    path = Path(x, y, math.radians(generator.uniform(-24, -12)), (Bend(LEAD_M + 330.0), Bend(180.0, 0.0, 1 / 400)))
    inner, outer = about(generator, 3.2), about(generator, 3.4)
    angle = generator.uniform(82, 98)
    stale, current = (_plan(path, angle, inner, outer, updated=updated) for updated in (False, True))
    return Scenario(
        name="avenue",
        city="WDC",
        season="Autumn_2021",
        source_split="train",
        split="val",
        direction=Direction.CURRENT_TO_PRIOR,
        stale=stale,
        current=current,
        route=("avenue/0/along.0/forward/2", "avenue/2/along.0/forward/2"),
        drive=(LEAD_M + 40.0, 190.0),
    )


def _plan(path: Path, angle: float, inner: float, outer: float, *, updated: bool) -> Plan:
    first = crossing_path(path, LEAD_M + 150.0, angle, LEAD_M + 110.0, 260.0)
    mews = crossing_path(path, LEAD_M + 285.0, 90.0, 0.0, 28.0, (*curve(-80, 28, 14), Bend(150.0)))
    rear = crossing_path(first, LEAD_M + 202.0, -90.0, 200.0, 260.0)
    roads = (
        Road("avenue", path, _avenue_blocks(inner, outer, updated=updated), CURB, CURB),
        Road("first", first, _first_blocks(updated=updated), 7.2, 7.2),
        Road("rear", rear, (_local_block(), _local_block()), 5.4, 5.4),
        Road("mews", mews, (_mews_block(),), 3.0, 3.0),
    )
    signal = {name: Zebra() for name in ("avenue-", "first-", "first+")}
    signal["first+"] = Zebra(setback=2.2 if updated else 0.9)
    if updated:
        signal["avenue+"] = Zebra(4.0, 0.9)
    junctions = (
        Junction("signal", {"avenue": LEAD_M + 150.0, "first": LEAD_M + 110.0}, signal, 8.0),
        Junction("mews-end", {"avenue": LEAD_M + 285.0, "mews": 0.0}, {} if updated else {"avenue+": Zebra()}, 6.0),
        Junction("corner", {"first": LEAD_M + 202.0, "rear": 200.0}, {"rear-": Zebra(3.0, 0.8)}, 5.0),
    )
    return Plan({road.name: road for road in roads}, junctions)


def _avenue_blocks(inner: float, outer: float, *, updated: bool) -> tuple[Block, ...]:
    def lanes(*, bikes: bool, bus: bool, pocket: bool = False, near: bool = False, shift: float = 0.0) -> Half:
        line = Mark.SOLID_WHITE if near else Mark.DASHED_WHITE
        second = Slot("2", outer, Mark.NONE, turns=STRAIGHT_ON)
        if bikes:
            second = replace(second, width=outer - 0.4, outer=Mark.SOLID_WHITE)
        if bus:
            line = Mark.SOLID_DASH_WHITE if near else Mark.SOLID_WHITE
            second = replace(second, lane_type=LaneType.BUS)
        first = Slot("1", inner, line, turns=STRAIGHT_ON if pocket else Turn.ANY)
        slots = [left_pocket()] if pocket else []
        return half(*slots, first, second, *([bike()] if bikes else []), inner=shift)

    plain, bikes = {"bikes": False, "bus": False}, {"bikes": updated, "bus": False}
    bus = {"bikes": False, "bus": updated}
    before = CrossSection(lanes(**plain), lanes(**plain))
    west = CrossSection(lanes(**plain, pocket=True, near=True, shift=-SHIFT), lanes(**plain, shift=SHIFT))
    between = CrossSection(lanes(**bikes), lanes(**bus))
    east = CrossSection(lanes(**bikes, shift=SHIFT), lanes(**bus, pocket=True, near=True, shift=-SHIFT))
    beyond = replace(between, centre=Mark.DOUBLE_SOLID_YELLOW if updated else Mark.DASHED_YELLOW)
    return (
        Block(before, end=Zone(west, 32.0, 20.0), tile_cuts=every(70.0, 190.0)),
        Block(between, start=Zone(east, 26.0, 18.0), end=Zone(between, 12.0, 0.0)),
        Block(beyond, tile_cuts=every(60.0, 200.0)),
    )


def _first_blocks(*, updated: bool) -> tuple[Block, ...]:
    turns = Turn.THROUGH if updated else STRAIGHT_ON

    def lane(*, pocket: bool = False, shift: float = 0.0, right: Turn = STRAIGHT_ON) -> Half:
        slots = (left_pocket(2.9), Slot("1", 3.2, turns=right)) if pocket else (Slot("1", 3.3),)
        return half(*slots, inner=shift)

    south = CrossSection(lane(pocket=True, shift=-1.4, right=turns), lane(shift=1.4))
    north = CrossSection(lane(shift=1.4), lane(pocket=True, shift=-1.4))
    plain = CrossSection(lane(), lane())
    beyond = CrossSection(lane(), lane(), Mark.SOLID_DASH_YELLOW if updated else Mark.DOUBLE_SOLID_YELLOW)
    return (
        Block(plain, end=Zone(south, 24.0, 18.0), tile_cuts=every(60.0, 150.0)),
        Block(beyond, start=Zone(north, 24.0, 16.0), cuts=(-0.32,)),
        Block(plain, tile_cuts=every(50.0, 140.0)),
    )


def _local_block() -> Block:
    section = CrossSection(half(Slot("1", 3.0)), half(Slot("1", 3.0)), Mark.NONE)
    return Block(section, tile_cuts=every(60.0, 250.0))


def _mews_block() -> Block:
    """Two-way without a centre line: two lanes on the same ground."""
    section = CrossSection(half(Slot("1", 4.6), inner=-2.3), half(Slot("1", 4.6), inner=-2.3), Mark.NONE)
    return Block(section, tile_cuts=every(60.0, 250.0))
