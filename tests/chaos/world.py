"""A log of lanes that have nothing to do with each other, so that any repaint is legal, whoever else is saving."""

from __future__ import annotations

import contextlib
import json
from pathlib import Path
from typing import Any

import httpx
from tests.cli.command import Lanewright
from tests.services.log_folder import LOG_ID, write_log
from tests.stored_logs import lane, points

LANES = 60
PASSWORD = "correct horse battery"
PREPARE = f"""
from pathlib import Path
from lanewright.cli.connection import database
from lanewright.core.changes import Direction
from lanewright.core.workflow import Role
from lanewright.db.engine import transaction
from lanewright.formats.splits import SourceSplits, Split
from lanewright.services import accounts
from lanewright.services.importing import Placing, import_log

with database() as url, transaction(url) as session:
    placing = Placing(SourceSplits(), release=Split.TEST, direction=Direction.PRIOR_TO_CURRENT)
    import_log(session, Path("{{folder}}"), placing)
    for name, role in (("boss", Role.ADMIN), ("anna", Role.ANNOTATOR)):
        accounts.add(session, name=name, role=role, password={PASSWORD!r})
"""


def log_text(count: int = LANES) -> str:
    """Lane k lies between y = 10 k and y = 10 k + 3.5."""
    lanes = {}
    for number in range(1, count + 1):
        y = 10.0 * number
        lanes[str(number)] = lane(
            number,
            left_lane_boundary=points((0.0, y + 3.5, 1.0), (20.0, y + 3.5, 1.0)),
            right_lane_boundary=points((0.0, y, 1.0), (20.0, y, 1.0)),
            left_neighbor_id=None,
            successors=[],
        )
    return json.dumps({"pedestrian_crossings": {}, "lane_segments": lanes, "drivable_areas": {}})


class Site:
    """A running server with one log, one task, and one account that it is assigned to."""

    def __init__(self, command: Lanewright, folder: Path) -> None:
        self.command = command
        self.address = f"http://127.0.0.1:{command.port}"
        prepared = command.python(PREPARE.format(folder=write_log(folder, LOG_ID, map_text=log_text())))
        assert prepared.returncode == 0, prepared.stderr
        command.serve()
        with contextlib.closing(self.sign_in("boss")) as boss:
            people = boss.get("/api/v1/people").json()
            anna = next(person["id"] for person in people if person["name"] == "anna")
            made = boss.post("/api/v1/tasks", json={"log_id": LOG_ID, "assignee_id": anna})
            assert made.status_code == 201, made.text
            self.task_id: int = made.json()["id"]

    def sign_in(self, name: str) -> httpx.Client:
        """A client of that person's, as one more device."""
        client = httpx.Client(base_url=self.address, timeout=60.0)
        answer = client.post("/api/v1/session", json={"name": name, "password": PASSWORD})
        assert answer.status_code == 200, answer.text
        client.headers["X-CSRF-Token"] = answer.json()["csrf_token"]
        return client


def repaint(number: int, mark: str) -> dict[str, Any]:
    return {
        "operation": "update",
        "kind": "lane_segment",
        "id": number,
        "attributes": {"right_lane_mark_type": mark},
    }
