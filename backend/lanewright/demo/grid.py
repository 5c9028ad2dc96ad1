"""A city grid of any size, for property tests and benches."""

from __future__ import annotations

import math

import numpy as np

from lanewright.core.elements import MapState, Mark
from lanewright.demo.assembly import Names, assemble
from lanewright.demo.ground import Ground
from lanewright.demo.network import draft
from lanewright.demo.path import Array, Bend, Path
from lanewright.demo.plan import Block, CrossSection, Half, Junction, Plan, Road, Slot, Turn, Zebra, Zone
from lanewright.demo.scenarios.scenario import about, half, left_pocket

LEAD_M = 90.0
SPACING_M = (125.0, 160.0)
STORAGE_M, TAPER_M = 20.0, 14.0
POCKET_SHIFT = 1.5


def build_map(seed: int, *, blocks: tuple[int, int] = (2, 2)) -> MapState:
    """An uncropped map of ``blocks`` (columns, rows) city blocks; the same arguments give the same map.

    Each of its (columns + 1) * (rows + 1) junctions brings about 20 to 40 lanes: 2 by 2 blocks make about 300 lanes.
    """
    generator = np.random.default_rng([seed, *blocks])
    plan = _grid(generator, *blocks)
    first = next(iter(plan.roads.values())).path
    ground = Ground.random(generator, first.x, first.y)
    return assemble(draft(plan, ground), Names(generator))


def _grid(generator: np.random.Generator, columns: int, rows: int) -> Plan:
    heading = float(generator.uniform(0, 2 * math.pi))
    origin = generator.uniform(500, 3000, 2)
    along = np.array([math.cos(heading), math.sin(heading)])
    across = np.array([-along[1], along[0]])
    xs = LEAD_M + np.concatenate([[0.0], np.cumsum(generator.uniform(*SPACING_M, columns))])
    ys = LEAD_M + np.concatenate([[0.0], np.cumsum(generator.uniform(*SPACING_M, rows))])
    roads: dict[str, Road] = {}
    for index, y in enumerate(ys):
        start = origin + across * y
        roads[f"row{index}"] = _road(generator, f"row{index}", start, heading, xs)
    for index, x in enumerate(xs):
        start = origin + along * x
        roads[f"column{index}"] = _road(generator, f"column{index}", start, heading + math.pi / 2, ys)
    junctions = tuple(
        Junction(
            f"{i}-{j}",
            {f"row{j}": float(x), f"column{i}": float(y)},
            {f"row{j}-": Zebra(), f"column{i}+": Zebra(3.0, 1.0)} if generator.random() < 0.6 else {},
        )
        for i, x in enumerate(xs)
        for j, y in enumerate(ys)
    )
    return Plan(roads, junctions)


def _road(generator: np.random.Generator, name: str, start: Array, heading: float, stations: Array) -> Road:
    """A straight road over all its junctions: local, street, or main road with turn lanes."""
    length = float(stations[-1]) + LEAD_M
    path = Path(float(start[0]), float(start[1]), heading, (Bend(length),))
    kind = generator.choice(["local", "street", "main"])
    count = len(stations) + 1
    if kind == "local":
        lane = half(Slot("1", about(generator, 2.95)))
        blocks = [Block(CrossSection(lane, lane, Mark.NONE))] * count
        return Road(name, path, tuple(blocks), 5.2, 5.2)
    if kind == "street":
        lane = half(Slot("1", about(generator, 3.3)))
        blocks = [Block(CrossSection(lane, lane, Mark.SOLID_DASH_YELLOW), tile_cuts=(45.0,))] * count
        return Road(name, path, tuple(blocks), 6.0, 6.0)
    width = about(generator, 3.3)
    blocks = [_main_block(width, first=i == 0, last=i == count - 1) for i in range(count)]
    return Road(name, path, tuple(blocks), 10.5, 10.5)


def _main_block(width: float, *, first: bool, last: bool) -> Block:
    def lanes(*, pocket: bool = False, shift: float = 0.0) -> Half:
        turns = Turn.THROUGH if pocket else Turn.THROUGH | Turn.LEFT
        through = Slot("1", width, Mark.SOLID_WHITE if pocket else Mark.DASHED_WHITE, turns=turns)
        outer = Slot("2", width, turns=Turn.THROUGH | Turn.RIGHT)
        return half(*([left_pocket()] if pocket else []), through, outer, inner=shift)

    plain = CrossSection(lanes(), lanes())
    arriving = CrossSection(lanes(pocket=True, shift=-POCKET_SHIFT), lanes(shift=POCKET_SHIFT))
    leaving = CrossSection(lanes(shift=POCKET_SHIFT), lanes(pocket=True, shift=-POCKET_SHIFT))
    return Block(
        plain,
        start=None if first else Zone(leaving, STORAGE_M, TAPER_M),
        end=None if last else Zone(arriving, STORAGE_M, TAPER_M),
    )
