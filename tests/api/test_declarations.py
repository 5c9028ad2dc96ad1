"""Macros that an annotator declares: kept with the draft, stored with every save, and never other than derived."""

from __future__ import annotations

import uuid
from typing import Any

import pytest
from sqlalchemy.orm import Session
from tests.api.conftest import DeskOn
from tests.api.desk import Desk, insert_crossing, remove_crossing, repaint, table_counts
from tests.api.drawings import as_sent, composed
from tests.core.worlds import straight, world

from lanewright.api.schemas.declarations import DeclarationIn
from lanewright.api.schemas.findings import ViolationOut
from lanewright.api.schemas.revisions import SavedRevision
from lanewright.api.schemas.tasks import DraftOut, Workspace

LANE_11 = ("lane_segment", 11)


def declared(*elements: tuple[str, int], lane_number: int = 0, **macros: bool) -> dict[str, Any]:
    """A declaration; macros that are not named are false."""
    flags = {name: macros.get(name, False) for name in ("shape", "appearance", "function", "lane_graph")}
    return {
        "elements": [{"kind": kind, "id": identity} for kind, identity in elements],
        "macros": {**flags, "lane_number": lane_number},
    }


PAINTED = declared(LANE_11, appearance=True)


def test_what_is_declared_is_stored_with_every_revision(desk: Desk) -> None:
    answer = desk.save(repaint(11), declarations=[PAINTED])
    assert answer.status_code == 201, answer.text
    assert SavedRevision.model_validate(answer.json()).declarations
    assert answer.json()["declarations"] == [PAINTED]
    opened = desk.open()
    Workspace.model_validate(opened)
    assert opened["declarations"] == [PAINTED]
    assert desk.open(revision=0)["declarations"] == []
    assert desk.save(remove_crossing(), base=1, declarations=[]).status_code == 201
    assert desk.open()["declarations"] == []
    assert desk.open(revision=1)["declarations"] == [PAINTED]
    DeclarationIn.model_validate(PAINTED)


def test_a_declaration_that_is_not_derived_stops_the_save_and_its_fix_lifts_that(desk: Desk, session: Session) -> None:
    counts = table_counts(session)
    wrong = declared(LANE_11, shape=True)
    refused = desk.save(repaint(11), declarations=[wrong])
    assert (refused.status_code, refused.json()["code"]) == (422, "save.violations")
    (violation,) = refused.json()["facts"]["violations"]
    ViolationOut.model_validate(violation)
    assert violation["code"] == "macro.mismatch"
    assert "appearance is missing; shape is extra" in violation["message"]
    (fix,) = violation["fixes"]
    assert (fix["edits"], fix["declarations"]) == ([], [PAINTED])
    checked = desk.check(repaint(11), declarations=[wrong]).json()
    assert [found["id"] for found in checked["violations"]] == [violation["id"]]
    assert table_counts(session) == counts
    assert desk.check(repaint(11), declarations=fix["declarations"]).json()["violations"] == []
    assert desk.save(repaint(11), declarations=fix["declarations"]).status_code == 201


def test_other_fixes_say_nothing_of_declarations(desk: Desk) -> None:
    drawn = [remove_crossing(), insert_crossing(desk.new_id(), x=2.2)]
    (violation,) = desk.check(*drawn).json()["violations"]
    assert [sorted(fix) for fix in violation["fixes"]] == [["edits", "title"]]


def test_a_declaration_alone_can_be_saved(desk: Desk) -> None:
    desk.saved(repaint(11))
    answer = desk.save(base=1, declarations=[PAINTED])
    assert answer.status_code == 201, answer.text
    assert (answer.json()["revision"], answer.json()["changed"]) == (2, {"lanes": [], "crossings": []})
    again = desk.save(base=2, declarations=[PAINTED])
    assert (again.status_code, again.json()["code"]) == (409, "save.empty")


def test_a_stored_declaration_stops_a_later_save_that_makes_it_wrong(desk: Desk) -> None:
    desk.save(repaint(11), declarations=[PAINTED])
    back = desk.save(repaint(11, "NONE"), base=1, declarations=[PAINTED])
    (violation,) = back.json()["facts"]["violations"]
    assert violation["fixes"][0]["declarations"] == []
    assert desk.save(repaint(11, "NONE"), base=1, declarations=[]).status_code == 201


def test_the_same_uuid_with_other_declarations_is_refused(desk: Desk) -> None:
    key = str(uuid.uuid4())
    first = desk.save(repaint(11), changeset_uuid=key, declarations=[PAINTED])
    assert desk.save(repaint(11), changeset_uuid=key, declarations=[PAINTED]).content == first.content
    assert desk.save(repaint(11), changeset_uuid=key).json()["code"] == "save.replayed_differently"


def test_declarations_on_an_older_base_merge(desk_on: DeskOn) -> None:
    desk = desk_on(world(straight(1, 0, 60), straight(2, 0, 60, 100, 103.5)))
    one, other = (declared(("lane_segment", lane), appearance=True) for lane in (1, 2))
    assert desk.save(repaint(1), declarations=[one]).status_code == 201
    second = desk.save(repaint(2), declarations=[other])
    assert second.json()["declarations"] == [one, other]
    assert desk.save(base=1, declarations=[]).json()["declarations"] == [other], "one was seen, and withdrawn"
    assert desk.open()["declarations"] == [other]


def test_elements_are_named_as_in_the_canonical_form(desk_on: DeskOn) -> None:
    base = world(straight(1, 0, 60, 0, 3.5), straight(2, 0, 60, 5, 8.5), straight(3, 0, 60, 15, 18.5))
    edited = world(straight(2, 0, 60, 0, 3.5), straight(9, 0, 60, 10, 13.5), straight(3, 0, 60, 15, 19))
    desk = desk_on(base)
    edits = as_sent(desk, base, edited)
    (update,) = desk.check(*edits).json()["updates"]
    (mine,) = (edit["id"] for edit in edits if edit["operation"] == "insert")
    as_drawn = {"elements": [{"kind": "lane_segment", "id": 2}, {"kind": "lane_segment", "id": mine}]}
    answer = desk.save(*edits, declarations=[as_drawn | {"macros": update["macros"]}])
    assert answer.status_code == 201, answer.text
    assert answer.json()["canonical"] == [{"kind": "lane_segment", "from": 2, "to": 1}]
    assert [one["id"] for one in answer.json()["declarations"][0]["elements"]] == [1, mine]


def test_a_declaration_that_fits_only_the_ids_as_drawn_stops_the_save(desk_on: DeskOn) -> None:
    base = world(straight(1, 0, 60, 0, 3.5), straight(2, 0, 60, 5, 8.5))
    desk = desk_on(base)
    edits = as_sent(desk, base, world(straight(2, 0, 60, 0, 3.5), straight(9, 0, 60, 10, 13.5)))
    (update,) = desk.check(*edits).json()["updates"]
    assert update["macros"]["shape"], "2 was moved, as it is drawn; in the canonical form nothing moves"
    stated = declared(("lane_segment", 2)) | {"macros": update["macros"]}
    refused = desk.save(*edits, declarations=[stated])
    assert (refused.status_code, refused.json()["code"]) == (422, "save.violations")
    assert "canonical form" in refused.json()["message"]
    (note,) = refused.json()["facts"]["violations"]
    assert note["code"] == "identity.not_canonical"
    mended = composed(edits, note["fixes"][0]["edits"])
    (mismatch,) = desk.check(*mended, declarations=[stated]).json()["violations"]
    assert desk.save(*mended, declarations=mismatch["fixes"][0]["declarations"]).status_code == 201


@pytest.mark.parametrize(
    ("wrong", "where"),
    [
        ({"elements": []}, "declarations[0].elements"),
        ({"elements": [{"kind": "lane_segment", "id": -1}]}, "declarations[0].elements[0].id"),
        ({"elements": [{"kind": "road", "id": 1}]}, "declarations[0].elements[0].kind"),
        ({"macros": {**PAINTED["macros"], "shape": 1}}, "declarations[0].macros.shape"),
        ({"macros": {**PAINTED["macros"], "lane_number": True}}, "declarations[0].macros.lane_number"),
        ({"macros": {**PAINTED["macros"], "lane_number": 2**40}}, "declarations[0].macros.lane_number"),
        ({"macros": {"shape": True}}, "declarations[0].macros.appearance"),
        ({"author": "me"}, "declarations[0].author"),
    ],
)
def test_a_malformed_declaration_is_refused_where_it_stands(
    desk: Desk, session: Session, wrong: dict[str, Any], where: str
) -> None:
    counts = table_counts(session)
    for refused in (
        desk.save(repaint(11), declarations=[PAINTED | wrong]),
        desk.check(repaint(11), declarations=[PAINTED | wrong]),
        desk.keep_draft(repaint(11), declarations=[PAINTED | wrong]),
    ):
        assert refused.status_code == 422
        assert refused.json()["message"].startswith(f"{where}: ")
    assert table_counts(session) == counts


def test_too_many_are_refused(desk: Desk) -> None:
    assert desk.check(repaint(11), declarations=[PAINTED] * 201).status_code == 422


def test_a_draft_keeps_them(desk: Desk) -> None:
    assert desk.keep_draft(declarations=[PAINTED]).status_code == 200
    kept = desk.open()["draft"]
    DraftOut.model_validate(kept)
    assert (kept["edits"], kept["declarations"]) == ([], [PAINTED])


def test_a_declaration_that_is_only_in_the_draft_stops_the_submit(desk: Desk) -> None:
    desk.save(repaint(11), declarations=[PAINTED])
    desk.keep_draft(base=1, declarations=[])
    submit = {"action": "submit", "revision": 1}
    refused = desk.client.post(f"{desk.address}/steps", json=submit)
    assert (refused.status_code, refused.json()["code"]) == (409, "task.unsaved_draft")
    version = desk.open()["draft"]["version"]
    desk.keep_draft(base=1, version=version, declarations=[PAINTED])
    assert desk.client.post(f"{desk.address}/steps", json=submit).status_code == 200


def test_declarations_that_are_left_out_stay_as_they_are(desk: Desk) -> None:
    assert desk.save(repaint(11), declarations=[PAINTED]).status_code == 201
    assert desk.save(remove_crossing(), base=1).status_code == 201
    assert desk.open()["declarations"] == [PAINTED]
    assert desk.keep_draft(repaint(12), base=2).status_code == 200
    assert desk.open()["draft"]["declarations"] == [PAINTED]


def test_a_lane_of_which_macros_are_declared_is_not_joined_by_the_save(desk_on: DeskOn) -> None:
    #  ── 1 ── 9 ──  the lane number is declared of 9, so 9 stays a lane
    base = world(straight(1, 0, 60))
    desk = desk_on(base)
    longer = world(straight(1, 0, 60, successors=(9,)), straight(9, 60, 90, predecessors=(1,)))
    edits = as_sent(desk, base, longer)
    (mine,) = (edit["id"] for edit in edits if edit["operation"] == "insert")
    statement = declared(("lane_segment", mine), lane_graph=True, lane_number=1)
    answer = desk.save(*edits, declarations=[statement]).json()
    assert (answer["joined"], answer["declarations"]) == ([], [statement])
