"""Somebody at work on a task: the requests that an editor sends, with as little in the way as possible."""

from __future__ import annotations

import uuid
from typing import Any

from httpx import Response
from sqlalchemy import func, select
from sqlalchemy.orm import Session
from starlette.testclient import TestClient

from lanewright.db.models import Base


class Desk:
    """A signed-in client beside one task."""

    def __init__(self, client: TestClient, task_id: int) -> None:
        self.client = client
        self.task_id = task_id
        self.address = f"/api/v1/tasks/{task_id}"

    def open(self, **query: Any) -> dict[str, Any]:
        answer = self.client.get(f"{self.address}/workspace", params=query)
        assert answer.status_code == 200, answer.text
        opened: dict[str, Any] = answer.json()
        return opened

    def save(self, *edits: dict[str, Any], base: int = 0, **body: Any) -> Response:
        """Saves under a new UUID, unless one is given."""
        sent = {"base_revision": base, "changeset_uuid": str(uuid.uuid4()), "edits": list(edits), "note": ""} | body
        return self.client.post(f"{self.address}/revisions", json=sent)

    def saved(self, *edits: dict[str, Any], base: int = 0) -> dict[str, Any]:
        """Saves, and it must work."""
        answer = self.save(*edits, base=base)
        assert answer.status_code == 201, answer.text
        document: dict[str, Any] = answer.json()
        return document

    def check(self, *edits: dict[str, Any], base: int = 0, **body: Any) -> Response:
        return self.client.post(f"{self.address}/check", json={"base_revision": base, "edits": list(edits)} | body)

    def canonical(self, *edits: dict[str, Any], base: int = 0) -> Response:
        return self.client.post(f"{self.address}/canonical", json={"base_revision": base, "edits": list(edits)})

    def keep_draft(self, *edits: dict[str, Any], version: int = 0, base: int = 0, **body: Any) -> Response:
        sent = {"base_revision": base, "edits": list(edits), "version": version} | body
        return self.client.put(f"{self.address}/draft", json=sent)

    def new_id(self) -> int:
        answer = self.client.post(f"{self.address}/id-blocks")
        assert answer.status_code == 201, answer.text
        return int(answer.json()["first_id"])


def edit(operation: str, kind: str, identity: int, **attributes: Any) -> dict[str, Any]:
    return {"operation": operation, "kind": kind, "id": identity, "attributes": attributes}


def update(lane: int, **attributes: Any) -> dict[str, Any]:
    return edit("update", "lane_segment", lane, **attributes)


def repaint(lane: int, mark: str = "DASHED_WHITE") -> dict[str, Any]:
    """The right side of a lane, which nobody shares on the small map."""
    return update(lane, right_lane_mark_type=mark)


def remove_crossing(identity: int = 21) -> dict[str, Any]:
    return edit("delete", "pedestrian_crossing", identity)


def insert_crossing(identity: int, x: float = 10.0, z: float | None = None) -> dict[str, Any]:
    """Across both lanes of the small map, 3 m wide from ``x``."""
    edges = [[{"x": x + step, "y": y, "z": z} for y in (0.0, 8.0)] for step in (0.0, 3.0)]
    return edit("insert", "pedestrian_crossing", identity, edge1=edges[0], edge2=edges[1])


def line(*points: tuple[float, float, float | None]) -> list[dict[str, float | None]]:
    return [{"x": x, "y": y, "z": z} for x, y, z in points]


def table_counts(session: Session) -> dict[str, int]:
    """Rows of every table: bad input leaves them as they are."""
    return {
        table.name: session.execute(select(func.count()).select_from(table)).scalar_one()
        for table in Base.metadata.sorted_tables
    }
