"""Saving: what comes back, what is stored, and what a retry, a stale base or a forged body gets."""

from __future__ import annotations

import uuid

import pytest
from sqlalchemy import select
from sqlalchemy.orm import Session
from tests.api.conftest import AddAccount, DeskOf
from tests.api.desk import Desk, insert_crossing, line, remove_crossing, repaint, table_counts, update

from lanewright.api.schemas.findings import ViolationOut
from lanewright.api.schemas.revisions import ConflictingElement, SavedRevision
from lanewright.core.workflow import Role
from lanewright.db.models import Account, AtomicChangeRow, ElementVersion, Revision, Task


def test_a_save_becomes_the_next_revision(desk: Desk, session: Session, anna: Account) -> None:
    answer = desk.saved(repaint(11), remove_crossing())
    SavedRevision.model_validate(answer)
    assert answer["revision"] == 1
    assert [lane["attributes"]["right_lane_mark_type"] for lane in answer["changed"]["lanes"]] == ["DASHED_WHITE"]
    assert answer["removed"] == [{"kind": "pedestrian_crossing", "id": 21}]
    opened = desk.open()
    assert opened["revision"] == 1
    assert opened["changed"] == answer["changed"]
    assert opened["removed"] == answer["removed"]
    saved = session.scalars(select(Revision).where(Revision.number == 1)).one()
    assert saved.author_id == anna.id


def test_changes_are_told_as_edits_made_and_how_they_will_be_exported(desk: Desk) -> None:
    findings = desk.saved(remove_crossing())["findings"]
    assert [change["categories"] for change in findings["changes"]] == [["deletion"]]
    assert "inserted" in findings["changes"][0]["exported_as"]
    assert findings["updates"][0]["macros"]["appearance"]


def test_any_past_revision_can_be_opened(desk: Desk) -> None:
    desk.saved(repaint(11))
    desk.saved(remove_crossing(), base=1)
    first = desk.open(revision=1)
    assert [lane["version"] for lane in first["changed"]["lanes"]] == [1]
    assert first["removed"] == []
    assert desk.open(revision=0)["changed"] == {"lanes": [], "crossings": []}
    assert [entry["changed_elements"] for entry in desk.open()["revisions"]] == [0, 1, 1]
    assert desk.client.get(f"{desk.address}/workspace", params={"revision": 3}).status_code == 404


def test_derived_changes_are_stored_beside_the_revision(desk: Desk, session: Session) -> None:
    desk.saved(repaint(11), remove_crossing())
    rows = session.execute(
        select(AtomicChangeRow.kind, AtomicChangeRow.element_id, AtomicChangeRow.category, AtomicChangeRow.leaves)
    ).all()
    assert [tuple(row) for row in rows] == [
        ("lane_segment", 11, "marking", ["marking.color.right", "marking.type.right"]),
        ("pedestrian_crossing", 21, "deletion", []),
    ]


def test_a_replay_gets_the_same_bytes_and_writes_nothing(desk: Desk, session: Session) -> None:
    key = str(uuid.uuid4())
    first = desk.save(repaint(11), changeset_uuid=key)
    desk.saved(repaint(12), base=1)
    counts = table_counts(session)
    again = desk.save(repaint(11), changeset_uuid=key)
    assert again.status_code == 201
    assert again.content == first.content
    assert table_counts(session) == counts


def test_a_replay_is_answered_even_when_the_task_has_moved_on(desk: Desk, session: Session) -> None:
    key = str(uuid.uuid4())
    first = desk.save(repaint(11), changeset_uuid=key)
    step = desk.client.post(f"{desk.address}/steps", json={"action": "submit", "revision": 1})
    assert step.status_code == 200, step.text
    assert desk.save(repaint(11), changeset_uuid=key).content == first.content


def test_the_same_uuid_with_another_body_is_refused(desk: Desk, session: Session) -> None:
    key = str(uuid.uuid4())
    desk.save(repaint(11), changeset_uuid=key)
    counts = table_counts(session)
    for changed in (desk.save(repaint(12), changeset_uuid=key), desk.save(repaint(11), changeset_uuid=key, note="x")):
        assert changed.status_code == 409
        assert changed.json()["code"] == "save.replayed_differently"
    assert table_counts(session) == counts


def test_disjoint_edits_on_an_older_base_merge(desk: Desk) -> None:
    desk.saved(repaint(11))
    answer = desk.saved(repaint(12))
    assert answer["revision"] == 2
    assert [lane["attributes"]["id"] for lane in answer["changed"]["lanes"]] == [11, 12]


def test_a_stale_edit_is_told_with_base_mine_and_theirs(desk: Desk, session: Session) -> None:
    desk.saved(repaint(11, "DASHED_WHITE"), remove_crossing())
    counts = table_counts(session)
    moved = line((2.0, 0.0, None), (2.0, 7.0, None))
    crossing = {"operation": "update", "kind": "pedestrian_crossing", "id": 21, "attributes": {"edge1": moved}}
    refused = desk.save(repaint(11, "SOLID_WHITE"), crossing)
    assert refused.status_code == 409
    problem = refused.json()
    assert (problem["code"], problem["facts"]["head"]) == ("save.stale", 1)
    lane, gone = (ConflictingElement.model_validate(one, strict=False) for one in problem["facts"]["conflicts"])
    assert [state and state["right_lane_mark_type"] for state in (lane.base, lane.mine, lane.theirs)] == [
        "NONE",
        "SOLID_WHITE",
        "DASHED_WHITE",
    ]
    assert gone.mine
    assert gone.mine["edge1"][1] == {"x": 2.0, "y": 7.0, "z": 1.0}
    assert gone.theirs is None
    assert table_counts(session) == counts
    assert desk.check(repaint(11, "SOLID_WHITE")).json()["code"] == "save.stale"


def test_a_stale_edit_is_told_with_what_others_declared(desk: Desk) -> None:
    macros = {"shape": False, "appearance": True, "function": False, "lane_graph": False, "lane_number": 0}
    theirs = {"elements": [{"kind": "lane_segment", "id": 11}], "macros": macros}
    assert desk.save(repaint(11, "DASHED_WHITE"), declarations=[theirs]).status_code == 201
    refused = desk.save(repaint(11, "SOLID_WHITE"), base=0, declarations=[])
    assert refused.json()["facts"]["declarations"] == [theirs]


def test_the_same_edit_made_twice_is_no_conflict(desk: Desk) -> None:
    desk.saved(repaint(11))
    answer = desk.saved(repaint(11), repaint(12))
    assert answer["revision"] == 2


def test_heights_make_no_conflict(desk: Desk) -> None:
    bent = line((0.0, 0.0, 1.0), (10.0, -0.7, None), (20.0, 0.0, 1.5))
    lower = line((0.0, 0.0, 1.0), (10.0, -0.7, 0.3), (20.0, 0.0, 1.5))
    desk.saved(update(11, right_lane_boundary=bent))
    assert desk.saved(update(11, right_lane_boundary=lower), repaint(12))["revision"] == 2


def test_a_save_without_any_difference_says_so(desk: Desk, session: Session) -> None:
    counts = table_counts(session)
    for edits in ([], [repaint(11, "NONE")]):
        refused = desk.save(*edits)
        assert refused.status_code == 409
        assert refused.json()["code"] == "save.empty"
    assert table_counts(session) == counts


def test_what_stays_below_tolerance_goes_back_to_the_bases_coordinates(desk: Desk) -> None:
    nudged = line((0.0, 0.01, None), (10.0, 0.02, None), (20.0, 0.0, 1.5))
    alone = desk.save(update(11, right_lane_boundary=nudged))
    assert alone.json()["code"] == "save.empty"
    assert alone.json()["facts"]["restored"] == [{"kind": "lane_segment", "id": 11}]
    answer = desk.saved(update(11, right_lane_boundary=nudged), remove_crossing())
    assert answer["restored"] == [{"kind": "lane_segment", "id": 11}]
    assert answer["changed"]["lanes"] == []


def test_untouched_points_keep_their_digits_and_new_ones_get_a_height(desk: Desk) -> None:
    bent = line((0.0, 0.0, 1.0), (10.0, -0.7, None), (20.0, 0.0, 1.5))
    (lane,) = desk.saved(update(11, right_lane_boundary=bent))["changed"]["lanes"]
    stored = [tuple(point.values()) for point in lane["attributes"]["right_lane_boundary"]]
    assert stored[0] == (0.0, 0.0, 1.0)
    assert stored[2] == (20.0, 0.0, 1.5)
    assert stored[1][2] == pytest.approx(1.25, abs=0.05)


def test_an_error_stops_the_save_and_comes_with_its_fixes(desk: Desk, session: Session) -> None:
    counts = table_counts(session)
    block = desk.new_id()
    counts["id_block"] += 1
    replaced = insert_crossing(block, x=2.2)
    refused = desk.save(remove_crossing(), replaced)
    assert refused.status_code == 422
    assert refused.json()["code"] == "save.violations"
    (violation,) = refused.json()["facts"]["violations"]
    ViolationOut.model_validate(violation)
    assert violation["code"] == "replacement.unjustified"
    assert table_counts(session) == counts
    checked = desk.check(remove_crossing(), replaced).json()
    assert [found["id"] for found in checked["violations"]] == [violation["id"]]


def test_a_check_writes_nothing(desk: Desk, session: Session) -> None:
    counts = table_counts(session)
    answer = desk.check(repaint(11), remove_crossing())
    assert answer.status_code == 200
    assert len(answer.json()["changes"]) == 2
    assert desk.check().json() == {"changes": [], "updates": [], "violations": []}
    assert table_counts(session) == counts


def test_only_open_tasks_can_be_saved(desk: Desk, session: Session) -> None:
    session.execute(select(Task)).scalar_one().state = "submitted"
    session.flush()
    refused = desk.save(repaint(11))
    assert (refused.status_code, refused.json()["code"]) == (409, "task.state")


def test_a_save_removes_the_savers_draft_only(desk: Desk, desk_of: DeskOf, session: Session) -> None:
    boss = session.scalars(select(Account).where(Account.name == "boss")).one()
    desk.keep_draft(repaint(11))
    desk_of(boss).keep_draft(repaint(12))
    desk.saved(repaint(11))
    assert desk.open()["draft"] is None
    assert desk_of(boss).open()["draft"]["edits"] == [repaint(12)]


@pytest.mark.parametrize("forged", ["author", "author_id", "created_at", "categories", "answer"])
def test_author_time_and_categories_never_come_from_the_client(desk: Desk, session: Session, forged: str) -> None:
    counts = table_counts(session)
    refused = desk.save(repaint(11), **{forged: 1})
    assert refused.status_code == 422
    assert forged in refused.json()["message"]
    assert table_counts(session) == counts


def test_a_foreign_task_does_not_exist_for_an_annotator(desk_of: DeskOf, add_account: AddAccount) -> None:
    stranger = desk_of(add_account(Role.ANNOTATOR, "stranger"))
    answers = [
        stranger.save(repaint(11)),
        stranger.check(repaint(11)),
        stranger.keep_draft(repaint(11)),
        stranger.client.delete(f"{stranger.address}/draft"),
        stranger.client.post(f"{stranger.address}/id-blocks"),
        stranger.client.get(f"{stranger.address}/workspace"),
        stranger.client.get(f"{stranger.address}/drive"),
        stranger.client.get(f"{stranger.address}/revisions/0/findings"),
    ]
    assert {(answer.status_code, answer.json()["code"]) for answer in answers} == {(404, "task.not_found")}


def test_a_reviewer_reads_but_does_not_save(desk_of: DeskOf, add_account: AddAccount) -> None:
    reviewer = desk_of(add_account(Role.REVIEWER, "rita"))
    assert reviewer.open()["task"]["can_edit"] is False
    assert reviewer.check(repaint(11)).status_code == 200
    for answer in (
        reviewer.save(repaint(11)),
        reviewer.keep_draft(),
        reviewer.client.post(f"{reviewer.address}/id-blocks"),
    ):
        assert (answer.status_code, answer.json()["code"]) == (403, "task.not_assigned")


def test_history_has_one_live_version_of_each_element(desk: Desk, session: Session) -> None:
    for base, mark in enumerate(("DASHED_WHITE", "SOLID_WHITE", "DASHED_WHITE")):
        desk.saved(repaint(11, mark), base=base)
    task = session.execute(select(Task)).scalar_one()
    spans = session.execute(
        select(ElementVersion.rev_from, ElementVersion.rev_to)
        .where(ElementVersion.line_id == task.line_id, ElementVersion.element_id == 11)
        .order_by(ElementVersion.rev_from)
    ).all()
    assert [tuple(span) for span in spans] == [(0, 1), (1, 2), (2, 3), (3, 2**31 - 1)]


def test_an_edit_names_one_id(desk: Desk, session: Session) -> None:
    counts = table_counts(session)
    for operation in ("update", "insert"):
        refused = desk.save({"operation": operation, "kind": "lane_segment", "id": 11, "attributes": {"id": 12}})
        assert refused.status_code == 422
        assert "has another id in its attributes" in refused.json()["message"]
    assert table_counts(session) == counts
    same = repaint(11)
    assert desk.saved(same | {"attributes": {"id": 11, **same["attributes"]}})["revision"] == 1
