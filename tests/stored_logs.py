"""Small logs as the import leaves them in the database."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable
from dataclasses import replace
from typing import Any

from sqlalchemy.orm import Session

from lanewright.core.elements import MapState, Mark
from lanewright.core.identity import with_lanes_exchanged
from lanewright.core.series import Run
from lanewright.db.mapping import to_rows
from lanewright.db.models import Line, Log, Task
from lanewright.db.repositories import elements, revisions
from lanewright.db.repositories.logs import insert_asset
from lanewright.formats.av2_map import MapDocument, parse_map
from lanewright.sensors.city import city_frame
from lanewright.services.drive import SENSORS
from lanewright.services.forking import write_base
from lanewright.services.importing import DRIVABLE_AREAS

#   y
#   8 +-------------------+   lane 12: oncoming, its left boundary is lane 11's reversed
#   4 +===================+   shared centre line, SOLID_YELLOW; crossing 21 runs across both
#   0 +-------------------+   lane 11
#     0                  20  x


def points(*triples: tuple[float, float, float]) -> list[dict[str, float]]:
    return [{"x": x, "y": y, "z": z} for x, y, z in triples]


def lane(identity: int, **changes: Any) -> dict[str, Any]:
    """AV2 attributes of lane 11, or of one that differs from it in ``changes``."""
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


def small_map() -> dict[str, Any]:
    """Two lanes and a crossing, in the shape of an AV2 map file."""
    oncoming = lane(
        12,
        left_lane_boundary=points((20.0, 4.0, 1.5), (0.0, 4.0, 1.0)),
        right_lane_boundary=points((20.0, 8.0, 1.5), (0.0, 8.0, 1.0)),
        left_neighbor_id=11,
        successors=[],
    )
    crossing = {
        "edge1": points((2.0, 0.0, 1.0), (2.0, 8.0, 1.0)),
        "edge2": points((5.0, 0.0, 1.0), (5.0, 8.0, 1.0)),
        "id": 21,
    }
    area = points((0.0, 0.0, 1.0), (20.0, 0.0, 1.5), (20.0, 8.0, 1.5), (0.0, 8.0, 1.0))
    return {
        "pedestrian_crossings": {"21": crossing},
        "lane_segments": {"12": oncoming, "11": lane(11)},
        "drivable_areas": {"31": {"area_boundary": area, "id": 31}},
    }


def small_drive() -> dict[str, Any]:
    """Two frames on the way along lane 11, as the import keeps them."""
    still = {"qw": 1.0, "qx": 0.0, "qy": 0.0, "qz": 0.0}
    frames = [
        {
            "index": index,
            "drive": 0,
            "timestamp_ns": f"31596626525983600{index}",
            "pose": {**still, "tx_m": 6.0 * index, "ty_m": 2.0, "tz_m": 1.5},
            "files": {},
        }
        for index in range(2)
    ]
    trajectory = [[0.0, 2.0, 1.5], [6.0, 2.0, 1.5]]
    return {"trajectory": trajectory, "frames": frames, "sensors": {}, "extrinsics": None, "intrinsics": None}


def add_log(
    session: Session,
    log_id: str = "log-one",
    *,
    city: str = "WDC",
    split: str = "train",
    direction: str = "current_to_prior",
    text: str | None = None,
) -> Log:
    """A log with the small map (or the map in ``text``) on its base line."""
    data = (text or json.dumps(small_map())).encode()
    name = f"log_map_archive_{log_id}____{city}_city_1.json"
    document: MapDocument = parse_map(data, name)
    line = Line(head=0)
    log = Log(
        log_id=log_id,
        dataset="tbv",
        city=city,
        source_split=None,
        release_split=split,
        direction=direction,
        map_file_name=name,
        map_document=data,
        map_sha256=hashlib.sha256(data).digest(),
        content_sha256=hashlib.sha256(b"log" + data).digest(),
        next_new_id=1000,
        last_new_id=9999,
        summary={"bounds": [0.0, 0.0, 20.0, 8.0], "lanes": 2, "crossings": 1, "sensors": {}, "absent": ["lidar"]},
    )
    # Log and its base line name each other: the line's key is checked at the end only.
    line.log_id = 0
    session.add(line)
    session.flush()
    log.line_id = line.id
    session.add(log)
    session.flush()
    line.log_id = log.id
    write_base(session, line, city, document.state)
    areas = [[point[:2] for point in ring] for ring in document.drivable_areas.values()]
    insert_asset(session, log.id, DRIVABLE_AREAS, "application/json", json.dumps(areas).encode(), {})
    insert_asset(session, log.id, SENSORS, "application/json", json.dumps(small_drive()).encode(), {})
    return log


def change_task(session: Session, task_id: int, edit: Callable[[MapState], MapState]) -> int:
    """Writes the edited map as the task's next revision, by the store's own functions; returns its number."""
    task = session.get_one(Task, task_id)
    before = elements.load(session, task.line_id, task.line.head)
    after = edit(before.state)
    number = revisions.advance_head(session, task.line_id, task.line.head)
    session.refresh(task.line)
    changed = sorted(
        (element for element in after if before.state.get(element.key) != element), key=lambda element: element.key
    )
    revisions.insert_revision(session, line_id=task.line_id, number=number, content_sha256=b"test", updates=[])
    ended = {element.key: before.versions[element.key] for element in before.state if after.get(element.key) != element}
    elements.close_versions(session, task.line_id, number, ended)
    elements.insert_versions(session, task.line_id, number, to_rows(changed, city_frame(task.log.city).to_mercator))
    return number


def cut_in_two(state: MapState, lane: int, first_part: int) -> MapState:
    """The map with a lane cut in the middle into two recorded parts (ids from ``first_part``), the second repainted."""
    whole = Run.of([state.lanes[lane]])
    one, other = whole.pieces([(whole.ends[0] / 2, whole.ends[1] / 2)])
    parts = [
        replace(one, id=first_part, part_of=lane),
        replace(other, id=first_part + 1, part_of=lane, right_mark=Mark.SOLID_BLUE),
    ]
    return with_lanes_exchanged(state, [lane], parts)
