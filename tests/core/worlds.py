"""Small maps for the core's tests, written as a reader would sketch them: x runs east, lanes head east."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from lanewright.core.attributes import parse_element
from lanewright.core.elements import ElementKind, LaneSegment, LaneType, Line, MapState, Mark, PedestrianCrossing

FIXTURES = Path(__file__).parents[1] / "fixtures" / "bijective"
REAL_MAPS = sorted((Path(__file__).parents[3] / "shared/data/av2").glob("*/map/log_map_archive_*.json"))
REAL_MAPS_MISSING = "the real logs are not at ../shared/data/av2"


@dataclass(frozen=True)
class Scenario:
    """One bijective fixture: two maps and what the engine must say of them."""

    name: str
    base: MapState
    edited: MapState
    expected: Mapping[str, Any]


def scenario(name: str) -> Scenario:
    """The fixture of that name."""
    document = json.loads((FIXTURES / f"{name}.json").read_text())
    return Scenario(name, map_of(document["base"]), map_of(document["edited"]), document)


def scenario_names() -> list[str]:
    return sorted(path.stem for path in FIXTURES.glob("*.json"))


def map_of(document: Mapping[str, Any]) -> MapState:
    """A map state from an AV2 map document."""
    lanes = (parse_element(ElementKind.LANE_SEGMENT, one) for one in document["lane_segments"].values())
    crossings = (
        parse_element(ElementKind.PEDESTRIAN_CROSSING, one) for one in document["pedestrian_crossings"].values()
    )
    return MapState.of([*lanes, *crossings])


def real_map(path: Path) -> MapState:
    return map_of(json.loads(path.read_text()))


def line(text: str, z: float = 0.0) -> Line:
    """``"0,0 20,0"`` as a line at height z."""
    points = (point.split(",") for point in text.split())
    return tuple((float(x), float(y), z) for x, y in points)


def lane(key: int, left: str, right: str, **fields: Any) -> LaneSegment:
    """A vehicle lane with unpainted sides from two lines as text."""
    values: dict[str, Any] = {
        "is_intersection": False,
        "lane_type": LaneType.VEHICLE,
        "left_mark": Mark.NONE,
        "right_mark": Mark.NONE,
    }
    return LaneSegment(id=key, left_boundary=line(left), right_boundary=line(right), **(values | fields))


def straight(
    key: int, start: float, finish: float, bottom: float = 0.0, top: float = 3.5, **fields: Any
) -> LaneSegment:
    """A lane heading east between two x and two y."""
    return lane(key, f"{start},{top} {finish},{top}", f"{start},{bottom} {finish},{bottom}", **fields)


def crossing(key: int, x: float, width: float = 3.0) -> PedestrianCrossing:
    """A crossing over the road at x, from y = -2 to y = 9."""
    return PedestrianCrossing(key, line(f"{x},-2 {x},9"), line(f"{x + width},-2 {x + width},9"))


def world(*elements: LaneSegment | PedestrianCrossing) -> MapState:
    return MapState.of(elements)


def street() -> MapState:
    """Three lanes in a row::

    100 (0..20) -> 1 (20..60) -> 200 (60..80)
    """
    return world(
        straight(100, 0, 20, successors=(1,)),
        straight(1, 20, 60, successors=(200,), predecessors=(100,)),
        straight(200, 60, 80, predecessors=(1,)),
    )
