"""verify finds what was tampered with, wherever it was."""

from __future__ import annotations

import uuid

import pytest
from sqlalchemy import text
from sqlalchemy.orm import Session
from tests.stored_logs import add_log

from lanewright.core.edits import Edit, Operation
from lanewright.core.elements import ElementKind
from lanewright.core.errors import NotFound
from lanewright.core.workflow import Role
from lanewright.db.models import Account
from lanewright.services import tasks
from lanewright.services.actor import Actor
from lanewright.services.saving import save
from lanewright.services.verify import subjects, verify


@pytest.fixture
def task_id(session: Session) -> int:
    """A task with two saves: lane 11 repainted, then crossing 21 deleted."""
    add_log(session)
    account = Account(name="boss", role="admin", password_hash="")
    session.add(account)
    session.flush()
    boss = Actor(account.id, account.name, Role.ADMIN)
    task_id = tasks.create(session, boss, log_id="log-one", direction=None, assignee_id=account.id).id
    saves = [
        Edit(Operation.UPDATE, ElementKind.LANE_SEGMENT, 11, {"right_lane_mark_type": "DASHED_WHITE"}),
        Edit(Operation.DELETE, ElementKind.PEDESTRIAN_CROSSING, 21),
    ]
    for base, edit in enumerate(saves):
        save(session, boss, task_id, base_revision=base, edits=[edit], changeset_uuid=uuid.uuid4(), note="")
    return task_id


def found(session: Session, task_id: int | None = None) -> list[str]:
    session.flush()
    session.expire_all()
    return [str(difference) for subject in subjects(session, task_id) for difference in verify(session, subject)]


def test_what_nobody_touched_does_not_differ(session: Session, task_id: int) -> None:
    assert found(session) == found(session, task_id) == []


def test_an_unknown_task_is_named(session: Session) -> None:
    with pytest.raises(NotFound, match="404"):
        found(session, 404)


ON_TASK = "line_id = (SELECT line_id FROM task)"
TAMPERING = {
    "an attribute": (
        """UPDATE element_version SET attributes = attributes || '{"lane_type": "BUS"}' WHERE element_id = 12""",
        ["lane_segment 12 of revision 0 has another content", "revision 0: the map", "revision 2: the map"],
    ),
    "a millimetre": (
        f"UPDATE element_version SET geom = ST_Translate(geom, 0.001, 0) WHERE {ON_TASK} AND element_id = 12",
        ["lane_segment 12 of revision 0 has another content", "revision 1: the map"],
    ),
    "a hash": (
        f"UPDATE revision SET content_sha256 = '' WHERE {ON_TASK} AND number = 1",
        ["revision 1: the map has another content"],
    ),
    "a change made up": (
        "INSERT INTO atomic_change SELECT line_id, 2, 'lane_segment', 12, 'type', '{}' FROM task",
        ["revision 2: the stored type of lane_segment 12 does not follow"],
    ),
    "a change lost": (
        "DELETE FROM atomic_change WHERE revision = 2 AND category = 'deletion'",
        ["revision 2: the deletion of pedestrian_crossing 21 is not stored"],
    ),
    "a leaf": (
        "UPDATE atomic_change SET leaves = '{}' WHERE revision = 1",
        ["revision 1: the marking of lane_segment 11 is not stored", "revision 1: the stored marking"],
    ),
    "an update": (
        f"UPDATE revision SET updates = '[]' WHERE {ON_TASK} AND number = 2",
        ["revision 2: the structural updates are not stored as derived"],
    ),
    "an overlap": (
        f"UPDATE element_version SET rev_to = 2 WHERE {ON_TASK} AND element_id = 11 AND rev_from = 0",
        ["lane_segment 11 has two versions at revision 1"],
    ),
    "the head": ("UPDATE line SET head = 5 WHERE id = (SELECT line_id FROM task)", ["but the head is 5"]),
    "the map file": (
        "UPDATE log SET map_document = replace(encode(map_document, 'escape'), 'BIKE', 'BUS')::bytea || ' '",
        ["log log-one: the map file has another content"],
    ),
    "a kept file": (
        "UPDATE log_asset SET body = 'x' WHERE name = 'sensors.json'",
        ["sensors.json has another content"],
    ),
}


@pytest.mark.parametrize("what", TAMPERING)
def test_tampering_is_found_where_it_was_done(session: Session, task_id: int, what: str) -> None:
    statement, words = TAMPERING[what]
    session.execute(text(statement.replace(":", "\\:").replace("\\:\\:", "::")))
    told = "\n".join(found(session))
    for word in words:
        assert word in told


def test_the_base_map_must_be_what_the_file_says(session: Session, task_id: int) -> None:
    session.execute(text("DELETE FROM element_version WHERE element_id = 12 AND line_id = (SELECT line_id FROM log)"))
    assert any("log log-one: the base map is not what the map file says" in line for line in found(session))
