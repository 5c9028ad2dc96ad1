"""A small map with the traps of the real ones, and the real logs."""

from __future__ import annotations

import copy
import json
from pathlib import Path
from typing import Any

import pytest

#   y
#   8 +-------------------+   lane 12: oncoming, its left boundary is lane 11's reversed
#   4 +===================+   shared centre line, SOLID_YELLOW
#   0 +-------------------+   lane 11: successor 99 lies outside the map (the rim)
#     0                  20  x


def points(*triples: tuple[float, float, float]) -> list[dict[str, float]]:
    return [{"x": x, "y": y, "z": z} for x, y, z in triples]


def lane(identity: int, **changes: Any) -> dict[str, Any]:
    attributes: dict[str, Any] = {
        "id": identity,
        "is_intersection": False,
        "lane_type": "VEHICLE",
        "left_lane_boundary": points((0.0, 4.0, 1.0), (20.0, 4.0, 1.5)),
        "left_lane_mark_type": "SOLID_YELLOW",
        "right_lane_boundary": points((0.0, 0.0, 1.0), (10.0, 0.0, 1.2), (20.0, 0.0, 1.5)),
        "right_lane_mark_type": "NONE",
        "successors": [99],
        "predecessors": [],
        "right_neighbor_id": None,
        "left_neighbor_id": 12,
    }
    return attributes | changes


SMALL_MAP: dict[str, Any] = {
    "pedestrian_crossings": {
        "21": {
            "edge1": points((2.0, 0.0, 1.0), (2.0, 8.0, 1.0)),
            "edge2": points((5.0, 0.0, 1.0), (5.0, 8.0, 1.0)),
            "id": 21,
        }
    },
    "lane_segments": {
        "12": lane(
            12,
            left_lane_boundary=points((20.0, 4.0, 1.5), (0.0, 4.0, 1.0)),
            right_lane_boundary=points((20.0, 8.0, 1.5), (0.0, 8.0, 1.0)),
            left_neighbor_id=11,
            successors=[],
        ),
        "11": lane(11),
    },
    "drivable_areas": {
        "31": {"area_boundary": points((0.0, 0.0, 1.0), (20.0, 0.0, 1.5), (20.0, 8.0, 1.5), (0.0, 8.0, 1.0)), "id": 31}
    },
}


@pytest.fixture
def small_map() -> dict[str, Any]:
    """A map as the value of its JSON file; free to be spoilt."""
    return copy.deepcopy(SMALL_MAP)


@pytest.fixture
def small_map_bytes(small_map: dict[str, Any]) -> bytes:
    return json.dumps(small_map).encode()


@pytest.fixture(params=["7fab2350-7eaf-3b7e-a39d-6937a4c1bede", "adcf7d18-0510-35b0-a2fa-b4cea13a6d76"])
def real_log(request: pytest.FixtureRequest, shared_data: Path) -> Path:
    """The folder of each real AV2 Sensor log in turn."""
    folder: Path = shared_data / "av2" / request.param
    return folder
