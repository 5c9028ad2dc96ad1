"""Bad bodies over HTTP: each is named, and no table changes."""

from __future__ import annotations

import json
from typing import Any

import pytest
from sqlalchemy.orm import Session
from tests.api.desk import Desk, line, repaint, table_counts, update

from lanewright.settings import Settings

NAN = float("nan")


@pytest.mark.parametrize(
    ("edit", "status", "words"),
    [
        (update(404, lane_type="BIKE"), 422, "lane_segment 404"),
        (update(11, lane_type="TRAM"), 422, "lane_type"),
        (update(11, right_lane_mark_type="SOLID_GREEN"), 422, "right_lane_mark_type"),
        (update(11, edge1=line((0.0, 0.0, 0.0), (1.0, 0.0, 0.0))), 422, "edge1"),
        (update(11, is_intersection=None), 422, "is_intersection"),
        (update(11, is_intersection=1), 422, "is_intersection"),
        (update(11, successors=[True]), 422, "successors"),
        (update(11, successors=[2**64]), 422, "successors"),
        (update(11, colour="red"), 422, "colour"),
        (update(11, left_lane_boundary=line((0.0, 0.0, 0.0))), 422, "left_lane_boundary"),
        (update(11, left_lane_boundary=line((True, 0.0, 0.0), (1.0, 0.0, 0.0))), 422, "left_lane_boundary"),
        (update(11, left_lane_boundary=line((1e308, 0.0, 0.0), (1.0, 0.0, 0.0))), 422, "left_lane_boundary"),
        ({**update(11), "operation": "rename"}, 422, "operation"),
        ({**update(11), "kind": "stop_line"}, 422, "kind"),
        ({**update(11), "id": "11"}, 422, "id"),
        ({**update(11), "id": 2**63}, 422, "id"),
        ({"operation": "insert", "kind": "lane_segment", "id": 11, "attributes": {}}, 422, "lane_segment 11"),
        ({"operation": "insert", "kind": "pedestrian_crossing", "id": 50, "attributes": {}}, 422, "edge1"),
        ({"operation": "delete", "kind": "lane_segment", "id": 404}, 422, "lane_segment 404"),
    ],
)
def test_an_edit_that_cannot_be_used_is_named(
    desk: Desk, session: Session, edit: dict[str, Any], status: int, words: str
) -> None:
    counts = table_counts(session)
    for answer in (desk.save(edit), desk.check(edit)):
        assert answer.status_code == status
        assert words in answer.json()["message"]
        assert answer.json()["mend"]
    assert table_counts(session) == counts


@pytest.mark.parametrize(
    "body",
    [
        b"",
        b"{",
        b"[]",
        b"null",
        b'{"base_revision": 0, "base_revision": 1, "edits": []}',
        b'{"base_revision": NaN, "edits": []}',
        b'{"base_revision": 0, "edits": [' + b"[" * 100_000,
        b'{"base_revision": 0, "edits": [], "note": "\\u0000"}',
        b'{"base_revision": 0, "edits": [], "note": "\\ud800"}',
        b"\xff\xfe",
    ],
)
def test_what_is_no_json_or_hides_something_is_refused(desk: Desk, session: Session, body: bytes) -> None:
    counts = table_counts(session)
    for address in ("revisions", "check"):
        answer = desk.client.post(
            f"{desk.address}/{address}", content=body, headers={"Content-Type": "application/json"}
        )
        assert answer.status_code in (400, 422), answer.text
        assert answer.json()["code"]
    assert table_counts(session) == counts


@pytest.mark.parametrize(
    "changed",
    [
        {"base_revision": -1},
        {"base_revision": 1},
        {"base_revision": 2**31},
        {"base_revision": "0"},
        {"base_revision": True},
        {"changeset_uuid": "not-a-uuid"},
        {"changeset_uuid": None},
        {"note": 5},
        {"note": "x" * 4001},
        {"edits": {}},
        {"edits": [None]},
        {"edits": [repaint(11)] * 2},
        {"edits": [repaint(11)] * 5001},
    ],
)
def test_a_field_of_the_wrong_kind_is_refused(desk: Desk, session: Session, changed: dict[str, Any]) -> None:
    counts = table_counts(session)
    answer = desk.save(repaint(11), **changed) if "edits" not in changed else desk.save(**changed)
    assert answer.status_code == 422
    assert next(iter(changed)).partition("_")[0] in json.dumps(answer.json())
    assert table_counts(session) == counts


def test_a_body_over_the_limit_is_not_read(desk: Desk, session: Session, settings: Settings) -> None:
    counts = table_counts(session)
    spaces = b" " * (settings.body_limit_bytes + 1)
    for method, address in (("POST", "revisions"), ("POST", "check"), ("PUT", "draft")):
        answer = desk.client.request(
            method, f"{desk.address}/{address}", content=spaces, headers={"Content-Type": "application/json"}
        )
        assert answer.status_code == 413
        assert answer.json()["code"] == "request.too_large"
    assert table_counts(session) == counts


@pytest.mark.parametrize("task", ["0", "-1", "99999999", str(2**63), "one"])
def test_unknown_tasks_are_not_found(desk: Desk, task: str) -> None:
    for part in ("workspace", "drive", "revisions/0/findings"):
        assert desk.client.get(f"/api/v1/tasks/{task}/{part}").status_code in (404, 422)
