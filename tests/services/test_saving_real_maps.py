"""Saves on real maps: what was drawn is stored exactly, the rest stays bit for bit, and everything verifies."""

from __future__ import annotations

import dataclasses
import math
import uuid
from pathlib import Path

import orjson
import pytest
from bench.legal_edits import legally_edited
from sqlalchemy import select
from sqlalchemy.orm import Session

from lanewright.core.changes import Direction
from lanewright.core.edits import Edit, Operation, apply_edits, edits_between
from lanewright.core.elements import Element, ElementKey, LaneSegment, Line, MapState
from lanewright.core.workflow import Role
from lanewright.db.models import Account, Log, Task
from lanewright.db.repositories import elements
from lanewright.formats.av2_map import parse_map
from lanewright.formats.splits import SourceSplits, Split
from lanewright.services import tasks
from lanewright.services.actor import Actor
from lanewright.services.id_blocks import take_block
from lanewright.services.importing import Placing, import_log
from lanewright.services.saving import save
from lanewright.services.verify import subjects, verify

pytestmark = pytest.mark.shared
TEST = Placing(SourceSplits(), release=Split.TEST, direction=Direction.PRIOR_TO_CURRENT)


@pytest.fixture
def boss(session: Session) -> Actor:
    account = Account(name="boss", role="admin", password_hash="")
    session.add(account)
    session.flush()
    return Actor(account.id, account.name, Role.ADMIN)


@pytest.fixture
def tasks_on_real_logs(session: Session, real_logs: list[Path], boss: Actor) -> list[Task]:
    made = []
    for folder in real_logs:
        log_id = import_log(session, folder, TEST).log_id
        made.append(tasks.create(session, boss, log_id=log_id, direction=None, assignee_id=boss.id).id)
    return [session.get_one(Task, task_id) for task_id in made]


def with_own_ids(session: Session, boss: Actor, task: Task, edits: tuple[Edit, ...]) -> list[Edit]:
    first, last = take_block(session, boss, task.id)
    ids = iter(range(first, last + 1))
    return [dataclasses.replace(edit, id=next(ids)) if edit.operation is Operation.INSERT else edit for edit in edits]


def stored(session: Session, task: Task, revision: int) -> MapState:
    return elements.load(session, task.line_id, revision).state


def lines_of(element: Element) -> tuple[Line, Line]:
    if isinstance(element, LaneSegment):
        return element.left_boundary, element.right_boundary
    return element.edge1, element.edge2


def test_edits_of_a_real_map_are_stored_as_drawn(session: Session, tasks_on_real_logs: list[Task], boss: Actor) -> None:
    for seed, task in enumerate(tasks_on_real_logs):
        base = stored(session, task, 0)
        edits = with_own_ids(session, boss, task, edits_between(base, legally_edited(base, 20, seed)))
        answer = orjson.loads(
            save(session, boss, task.id, base_revision=0, edits=edits, changeset_uuid=uuid.uuid4(), note="")
        )
        edited = stored(session, task, 1)
        touched = {ElementKey(edit.kind, edit.id) for edit in edits}
        assert {change["id"] for change in answer["findings"]["changes"]} <= {key.id for key in touched}
        for element in base:
            if element.key not in touched:
                assert edited.get(element.key) == element
        for element in edited:
            assert all(math.isfinite(z) for line in lines_of(element) for _, _, z in line)
    assert [found for subject in subjects(session) for found in verify(session, subject)] == []


def test_taking_everything_back_renders_the_file_that_was_imported(
    session: Session, tasks_on_real_logs: list[Task], boss: Actor
) -> None:
    for task in tasks_on_real_logs:
        base = stored(session, task, 0)
        edits = with_own_ids(session, boss, task, edits_between(base, legally_edited(base, 10)))
        back = edits_between(apply_edits(base, edits), base)
        for revision, changeset in enumerate((edits, back)):
            save(
                session,
                boss,
                task.id,
                base_revision=revision,
                edits=list(changeset),
                changeset_uuid=uuid.uuid4(),
                note="",
            )
        log = session.scalars(select(Log).where(Log.id == task.log_id)).one()
        document = parse_map(log.map_document, log.map_file_name)
        assert stored(session, task, 1) != base
        assert document.render(stored(session, task, 2)) == log.map_document
