"""What the database itself refuses, and what a line says of its past."""

from __future__ import annotations

import dataclasses

import pytest
from sqlalchemy import insert, select, text
from sqlalchemy.exc import IntegrityError
from sqlalchemy.orm import Session
from tests.stored_logs import add_log

from lanewright.core.elements import ElementKey, ElementKind, Mark
from lanewright.core.errors import Conflict
from lanewright.db.mapping import to_rows
from lanewright.db.models import ElementVersion, Revision
from lanewright.db.repositories import elements, revisions
from lanewright.services.forking import fork

LANE = ElementKey(ElementKind.LANE_SEGMENT, 11)
CROSSING = ElementKey(ElementKind.PEDESTRIAN_CROSSING, 21)


@pytest.fixture
def line_id(session: Session) -> int:
    """A line forked from the small log: lanes 11 and 12, crossing 21."""
    return fork(session, add_log(session)).id


def next_revision(session: Session, line_id: int) -> int:
    head = session.execute(select(Revision.number).where(Revision.line_id == line_id)).scalars().all()
    number = revisions.advance_head(session, line_id, max(head))
    revisions.insert_revision(session, line_id=line_id, number=number, content_sha256=b"", updates=[])
    return number


def repainted(session: Session, line_id: int, mark: Mark) -> list[elements.ElementRow]:
    lane = elements.load(session, line_id, 0).state.lanes[11]
    return to_rows([dataclasses.replace(lane, right_mark=mark)], lambda xy: xy)


def test_a_fork_holds_the_same_map(session: Session, line_id: int) -> None:
    base_line_id = session.execute(text("SELECT line_id FROM log")).scalar_one()
    assert elements.load(session, line_id, 0) == elements.load(session, base_line_id, 0)


def test_the_database_refuses_a_second_live_version(session: Session, line_id: int) -> None:
    number = next_revision(session, line_id)
    with pytest.raises(IntegrityError, match="uq_element_version_live"):
        elements.insert_versions(session, line_id, number, repainted(session, line_id, Mark.SOLID_WHITE))


def test_the_database_refuses_a_version_outside_every_changeset(session: Session, line_id: int) -> None:
    elements.close_versions(session, line_id, 1, {LANE: 0})
    with pytest.raises(IntegrityError, match="fk_element_version_line_id_rev_from"):
        elements.insert_versions(session, line_id, 7, repainted(session, line_id, Mark.SOLID_WHITE))


def test_the_database_refuses_a_version_that_ends_before_it_begins(session: Session, line_id: int) -> None:
    with pytest.raises(IntegrityError, match="ck_element_version_revisions"):
        elements.close_versions(session, line_id, 0, {LANE: 0})


def test_the_database_refuses_two_revisions_of_one_number(session: Session, line_id: int) -> None:
    next_revision(session, line_id)
    with pytest.raises(IntegrityError, match="pk_revision"):
        session.execute(
            insert(Revision).values(line_id=line_id, number=1, content_sha256=b"", updates=[], note="", author_id=None)
        )


def test_closing_a_version_that_is_not_live_is_noticed(session: Session, line_id: int) -> None:
    elements.close_versions(session, line_id, 1, {LANE: 0})
    with pytest.raises(Conflict):
        elements.close_versions(session, line_id, 2, {LANE: 0, CROSSING: 0})


def test_the_head_moves_only_from_where_it_is(session: Session, line_id: int) -> None:
    assert revisions.advance_head(session, line_id, 0) == 1
    with pytest.raises(Conflict):
        revisions.advance_head(session, line_id, 0)


def test_every_revision_stays_readable(session: Session, line_id: int) -> None:
    first = next_revision(session, line_id)
    elements.close_versions(session, line_id, first, {LANE: 0, CROSSING: 0})
    elements.insert_versions(session, line_id, first, repainted(session, line_id, Mark.SOLID_WHITE))
    second = next_revision(session, line_id)
    elements.close_versions(session, line_id, second, {LANE: first})
    elements.insert_versions(session, line_id, second, repainted(session, line_id, Mark.SOLID_BLUE))
    marks = [elements.load(session, line_id, number).state.lanes[11].right_mark for number in (0, 1, 2)]
    assert marks == [Mark.NONE, Mark.SOLID_WHITE, Mark.SOLID_BLUE]
    assert [CROSSING in elements.load(session, line_id, number).state for number in (0, 1, 2)] == [True, False, False]


def test_a_departure_from_the_base_makes_the_whole_map(session: Session, line_id: int) -> None:
    base = elements.load(session, line_id, 0)
    assert elements.load_departure(session, line_id, 0).applied_to(base) is base
    first = next_revision(session, line_id)
    elements.close_versions(session, line_id, first, {LANE: 0, CROSSING: 0})
    elements.insert_versions(session, line_id, first, repainted(session, line_id, Mark.SOLID_WHITE))
    departure = elements.load_departure(session, line_id, first)
    assert departure.removed == (CROSSING,)
    assert departure.applied_to(base) == elements.load(session, line_id, first)


def test_coordinates_are_exact_in_the_database(session: Session, line_id: int) -> None:
    lane = elements.load(session, line_id, 0).state.lanes[11]
    odd = dataclasses.replace(lane, id=77, right_boundary=((0.1 + 0.2, -1e-300, 1 / 3), (5e5 + 1 / 7, 2.0, -0.0)))
    elements.insert_versions(session, line_id, 0, to_rows([odd], lambda xy: xy))
    stored = elements.load(session, line_id, 0).state.lanes[77]
    assert [value.hex() for point in stored.right_boundary for value in point] == [
        value.hex() for point in odd.right_boundary for value in point
    ]
    rows = session.execute(select(ElementVersion.sha256).where(ElementVersion.element_id == 77)).scalars().all()
    assert len(rows) == 1
