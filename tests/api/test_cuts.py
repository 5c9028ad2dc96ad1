"""A lane cut where a property changes: drawn, mended by the fix, saved, opened again, verified and exported."""

from __future__ import annotations

import json
from typing import Any

import pytest
from sqlalchemy import select
from sqlalchemy.orm import Session
from tests.api.conftest import DeskOn
from tests.api.desk import Desk, repaint, update
from tests.api.drawings import as_sent, composed
from tests.core.worlds import lane, scenario, world
from tests.services.export_inside import archived

from lanewright.api.schemas.revisions import SavedRevision
from lanewright.core.elements import Mark
from lanewright.db.models import ElementVersion, Log, Task
from lanewright.db.repositories import elements
from lanewright.formats.av2_map import parse_map
from lanewright.formats.splits import Split
from lanewright.services.verify import subjects, verify

CASE = scenario("marks_mid_lane")


def mended(desk: Desk) -> list[dict[str, Any]]:
    """The drawn edits of the fixture with the fix of their one violation."""
    edits = as_sent(desk, CASE.base, CASE.edited)
    answer = desk.check(*edits)
    assert answer.status_code == 200, answer.text
    (violation,) = answer.json()["violations"]
    assert violation["code"] == "replacement.unjustified"
    return composed(edits, violation["fixes"][0]["edits"])


def edit_key(edit: dict[str, Any]) -> dict[str, Any]:
    return {"kind": edit["kind"], "id": edit["id"]}


def parts(lanes: list[dict[str, Any]]) -> dict[int, int]:
    """Lane -> the lane that it is a part of."""
    attributes = [lane["attributes"] for lane in lanes]
    return {lane["id"]: lane["part_of"] for lane in attributes if "part_of" in lane}


def test_the_fix_of_a_half_painted_lane_is_saved_as_it_stands(desk_on: DeskOn, session: Session) -> None:
    desk = desk_on(CASE.base)
    edits = mended(desk)
    first, second = (edit["id"] for edit in edits if edit["operation"] == "insert")
    assert desk.check(*edits).json()["violations"] == []
    answer = desk.saved(*edits)
    SavedRevision.model_validate(answer)
    assert [(change["id"], change["categories"]) for change in answer["findings"]["changes"]] == [(second, ["marking"])]
    assert answer["canonical"] == []
    opened = desk.open()
    assert parts(opened["changed"]["lanes"]) == {first: 1, second: 1}
    assert parts(opened["base"]["lanes"]) == {}
    assert [found for subject in subjects(session, desk.task_id) for found in verify(session, subject)] == []
    findings = desk.client.get(f"{desk.address}/revisions/1/findings").json()
    assert findings == answer["findings"]


def test_a_lane_that_is_whole_again_is_the_base(desk_on: DeskOn) -> None:
    desk = desk_on(CASE.base)
    edits = mended(desk)
    desk.saved(*edits)
    base = CASE.expected["base"]["lane_segments"]
    back = [{"operation": "delete", "kind": "lane_segment", "id": e["id"]} for e in edits if e["operation"] == "insert"]
    whole = {name: value for name, value in base["1"].items() if name != "id"}
    back.append({"operation": "insert", "kind": "lane_segment", "id": 1, "attributes": whole})
    back += [update(100, successors=[1]), update(200, predecessors=[1])]
    answer = desk.saved(*back, base=1)
    assert answer["findings"] == {"changes": [], "updates": [], "violations": []}
    assert {lane["attributes"]["id"] for lane in answer["changed"]["lanes"]} == {1, 100, 200}
    assert answer["removed"] == [edit_key(edit) for edit in edits if edit["operation"] == "insert"]


def test_what_a_cut_leaves_unchanged_is_the_bases_to_the_last_digit(desk_on: DeskOn, session: Session) -> None:
    base = world(lane(1, "0,3.5 57,16.7", "0,0 57,13.2"))
    #  cut where the cursor was, so beside the line by some millimetres
    parts_drawn = (
        lane(8, "0,3.5 28.41,10.08", "0,0 28.41,6.58", part_of=1, successors=(9,)),
        lane(9, "28.41,10.08 57,16.7", "28.41,6.58 57,13.2", part_of=1, predecessors=(8,), right_mark=Mark.SOLID_BLUE),
    )
    desk = desk_on(base)
    answer = desk.saved(*as_sent(desk, base, world(*parts_drawn)))
    first, second = (part["attributes"]["id"] for part in answer["changed"]["lanes"])
    assert [(change["id"], change["categories"]) for change in answer["findings"]["changes"]] == [(second, ["marking"])]
    desk.saved(repaint(second, "SOLID_WHITE"), base=1)
    assert [part["version"] for part in desk.open()["changed"]["lanes"]] == [1, 2]
    task = session.get_one(Task, desk.task_id)
    task.state, task.accepted_revision = "accepted", 2
    log = session.get_one(Log, task.log_id)
    files = archived(session, Split.TRAIN)
    prior, current = (
        parse_map(files[f"{side}/{log.log_id}/map/{log.map_file_name}"], side).state for side in ("prior", "current")
    )
    assert prior.lanes[first] == current.lanes[first]
    assert prior.lanes[second].left_boundary == current.lanes[second].left_boundary
    assert prior.lanes[second].right_boundary == current.lanes[second].right_boundary


def test_a_part_can_be_edited_and_its_record_taken_off(desk_on: DeskOn) -> None:
    desk = desk_on(CASE.base)
    edits = mended(desk)
    desk.saved(*edits)
    first, second = (edit["id"] for edit in edits if edit["operation"] == "insert")
    desk.saved(repaint(first, "DASHED_YELLOW"), base=1)
    assert parts(desk.open()["changed"]["lanes"]) == {first: 1, second: 1}
    off = desk.check(update(first, part_of=None), update(second, part_of=None), base=2)
    assert [found["code"] for found in off.json()["violations"]] == ["replacement.unjustified"]


def test_a_part_of_nothing_is_refused(desk: Desk) -> None:
    refused = desk.check(update(11, part_of=4711))
    assert refused.status_code == 422
    assert "lane_segment 11" in refused.json()["message"]
    assert "the base has no such lane" in refused.json()["message"]


def test_a_lane_of_the_base_is_no_part(desk: Desk) -> None:
    refused = desk.save(update(11, part_of=12))
    assert (refused.status_code, refused.json()["code"]) == (409, "save.empty")
    (saved,) = desk.saved(update(11, part_of=12, right_lane_mark_type="DASHED_WHITE"))["changed"]["lanes"]
    assert "part_of" not in saved["attributes"]


@pytest.mark.parametrize("wrong", [True, "1", -1, 1.5, 2**53])
def test_a_record_that_is_no_id_is_refused(desk: Desk, wrong: object) -> None:
    refused = desk.save(update(11, part_of=wrong))
    assert refused.status_code == 422
    assert "edits[0].attributes.part_of" in refused.json()["message"]


def test_lanes_without_a_record_have_the_hash_they_had(desk: Desk, session: Session) -> None:
    """Hashes of revisions from before there were cuts still hold."""
    known = "dac7814d23e7a72b"
    row = session.scalars(
        select(ElementVersion).where(ElementVersion.element_id == 11, ElementVersion.rev_from == 0)
    ).first()
    assert row is not None
    assert row.sha256.hex()[:16] == known
    assert "part_of" not in row.attributes


@pytest.mark.parametrize("direction", ["prior_to_current", "current_to_prior"])
def test_prior_and_current_are_exported_cut_at_the_same_places(
    desk_on: DeskOn, session: Session, direction: str
) -> None:
    desk = desk_on(CASE.base)
    edits = mended(desk)
    desk.saved(*edits)
    first, second = (edit["id"] for edit in edits if edit["operation"] == "insert")
    task = session.get_one(Task, desk.task_id)
    task.state, task.accepted_revision, task.direction = "accepted", 1, direction
    log = session.get_one(Log, task.log_id)
    files = archived(session, Split.TRAIN)
    prior, current = (
        parse_map(files[f"{side}/{log.log_id}/map/{log.map_file_name}"], side).state for side in ("prior", "current")
    )
    base, edited = (prior, current) if direction == "prior_to_current" else (current, prior)
    assert edited == elements.load(session, task.line_id, 1).state
    assert sorted(base.lanes) == sorted(edited.lanes) == [100, 200, first, second]
    assert {key: lane.part_of for key, lane in base.lanes.items() if lane.part_of} == {first: 1, second: 1}
    for part in (first, second):
        assert base.lanes[part].left_boundary == edited.lanes[part].left_boundary
    (change,) = json.loads(files[f"changes/{log.log_id}.json"])["changes"]
    assert (change["id"], change["categories"]) == (second, ["marking"])
    assert base.lanes[second].left_mark != edited.lanes[second].left_mark
