"""The canonical form: asked for while drawing, applied by the save where the ids are legal but not the simplest."""

from __future__ import annotations

import uuid

import pytest
from sqlalchemy.orm import Session
from tests.api.conftest import DeskOn
from tests.api.desk import Desk, insert_crossing, remove_crossing, repaint, table_counts
from tests.api.drawings import as_sent, composed, with_own_ids
from tests.core.worlds import scenario, scenario_names, straight, world

from lanewright.api.schemas.revisions import CanonicalOut, SavedRevision
from lanewright.core.elements import MapState
from lanewright.db.models import Task
from lanewright.db.repositories import elements
from lanewright.services.verify import subjects, verify

BASE = world(straight(1, 0, 60, 0, 3.5), straight(2, 0, 60, 5, 8.5))
#  ── 2 ──         ── 9 ──  (10 m up)
#  ── 1 ──   =>    ── 2 ──      legal, but "1 deleted, 9 moved" says it with fewer categories
MOVED_UP = world(straight(2, 0, 60, 0, 3.5), straight(9, 0, 60, 10, 13.5))


def stored(session: Session, desk: Desk, revision: int) -> MapState:
    return elements.load(session, session.get_one(Task, desk.task_id).line_id, revision).state


def test_a_save_tells_the_simplest_story_and_says_so(desk_on: DeskOn, session: Session) -> None:
    desk = desk_on(BASE)
    edits = as_sent(desk, BASE, MOVED_UP)
    (mine,) = (edit["id"] for edit in edits if edit["operation"] == "insert")
    checked = desk.check(*edits).json()
    assert [(found["code"], found["blocks"]) for found in checked["violations"]] == [("identity.not_canonical", False)]
    answer = desk.saved(*edits)
    SavedRevision.model_validate(answer)
    assert answer["canonical"] == [{"kind": "lane_segment", "from": 2, "to": 1}]
    told = {change["id"]: change["categories"] for change in answer["findings"]["changes"]}
    assert told == {2: ["deletion"], mine: ["insertion"]}
    assert answer["findings"]["violations"] == []
    after = stored(session, desk, 1)
    assert sorted(after.lanes) == [1, mine]
    assert after.lanes[1] == BASE.lanes[1], "what stayed in its place is the base's, bit for bit"
    assert desk.open()["changed"] == answer["changed"]
    assert [found for subject in subjects(session, desk.task_id) for found in verify(session, subject)] == []


def test_a_replay_of_such_a_save_is_byte_equal(desk_on: DeskOn, session: Session) -> None:
    desk = desk_on(BASE)
    edits = as_sent(desk, BASE, MOVED_UP)
    key = str(uuid.uuid4())
    first = desk.save(*edits, changeset_uuid=key)
    counts = table_counts(session)
    assert desk.save(*edits, changeset_uuid=key).content == first.content
    assert table_counts(session) == counts


def test_a_story_that_comes_to_nothing_is_not_saved(desk_on: DeskOn, session: Session) -> None:
    desk = desk_on(BASE)
    nothing = world(straight(2, 0, 60, 0, 3.5), straight(9, 0, 60, 5, 8.5))
    edits = as_sent(desk, BASE, nothing)
    refused = desk.save(*edits)
    assert (refused.status_code, refused.json()["code"]) == (409, "save.empty")


def test_an_id_of_an_earlier_revision_is_not_passed_on(desk_on: DeskOn, session: Session) -> None:
    #  ── 1000 ── (revision 1)
    #                                ── 1 ──       (2.5 m up: a new lane, really)
    #  ── 1 ──              =>       ── 1000 ──
    #  ── 2 ──
    base = world(straight(1, 0, 60, 0, 3.5), straight(2, 0, 60, -8.5, -5))
    desk = desk_on(base)
    (insert,) = as_sent(desk, base, world(*base, straight(9, 0, 60, 20, 23.5)))
    earlier = insert["id"]
    desk.saved(insert)
    after = world(straight(1, 0, 60, 6, 9.5), straight(earlier, 0, 60, 0, 3.5))
    answer = desk.saved(*as_sent(desk, stored(session, desk, 1), after), base=1)
    (fresh,) = (change["id"] for change in answer["findings"]["changes"] if change["categories"] == ["insertion"])
    assert answer["canonical"] == [
        {"kind": "lane_segment", "from": 1, "to": fresh},
        {"kind": "lane_segment", "from": earlier, "to": 1},
    ]
    assert fresh != earlier
    assert stored(session, desk, 2).lanes[1] == base.lanes[1]
    assert desk.saved(repaint(fresh), base=2)["revision"] == 3, "the id is the account's own"


def test_a_save_says_that_it_joined_what_was_drawn_in_two(desk_on: DeskOn, session: Session) -> None:
    #  ── 8 ── 9 ──  drawn in series, nothing between them differs
    desk = desk_on(BASE)
    row = (straight(8, 0, 30, 20, 23.5, successors=(9,)), straight(9, 30, 60, 20, 23.5, predecessors=(8,)))
    edits = as_sent(desk, BASE, world(*BASE, *row))
    drawn = {edit["id"] for edit in edits}
    answer = desk.saved(*edits)
    (joined,) = answer["joined"]
    assert drawn - {joined} == stored(session, desk, 1).lanes.keys() - stored(session, desk, 0).lanes.keys()
    assert (answer["canonical"], answer["cut"]) == ([], [])


def test_a_save_joins_what_only_makes_a_lane_longer(desk_on: DeskOn, session: Session) -> None:
    #  ── 1 ── 9 ──  where nothing joined 1: drawn in one piece it would be lane 1, longer
    desk = desk_on(BASE)
    longer = (straight(1, 0, 60, successors=(9,)), straight(9, 60, 90, predecessors=(1,)))
    edits = as_sent(desk, BASE, world(*longer, BASE.lanes[2]))
    (mine,) = (edit["id"] for edit in edits if edit["operation"] == "insert")
    assert desk.check(*edits).json()["violations"] == []
    answer = desk.saved(*edits)
    assert (answer["canonical"], answer["joined"], answer["cut"]) == ([], [mine], [])
    assert {change["id"]: change["categories"] for change in answer["findings"]["changes"]} == {1: ["geometry"]}
    assert sorted(stored(session, desk, 1).lanes) == [1, 2]


def test_the_canonical_form_is_proposed_as_edits_of_the_draft(desk_on: DeskOn, session: Session) -> None:
    desk = desk_on(BASE)
    edits = as_sent(desk, BASE, MOVED_UP)
    counts = table_counts(session)
    answer = desk.canonical(*edits)
    assert answer.status_code == 200, answer.text
    proposed = answer.json()
    CanonicalOut.model_validate(proposed)
    assert proposed["renamed"] == [{"kind": "lane_segment", "from": 2, "to": 1}]
    assert (proposed["joined"], proposed["cut"]) == ([], [])
    assert table_counts(session) == counts
    net = composed(edits, proposed["edits"])
    assert desk.check(*net).json()["violations"] == []
    assert desk.canonical(*net).json() == {"edits": [], "renamed": [], "joined": [], "cut": []}


def test_what_is_canonical_stays(desk: Desk) -> None:
    nothing = {"edits": [], "renamed": [], "joined": [], "cut": []}
    assert desk.canonical().json() == nothing
    assert desk.canonical(repaint(11), remove_crossing()).json() == nothing
    desk.saved(repaint(11))
    assert desk.canonical(repaint(12), base=1).json() == nothing


def test_a_replaced_crossing_is_made_an_edit_again(desk: Desk) -> None:
    drawn = [remove_crossing(), insert_crossing(desk.new_id(), x=2.2)]
    proposed = desk.canonical(*drawn).json()
    net = composed(drawn, proposed["edits"])
    assert [(edit["operation"], edit["id"]) for edit in net] == [("update", 21)]
    assert desk.saved(*net)["findings"]["violations"] == []


@pytest.mark.parametrize("name", scenario_names())
def test_every_fixture_is_made_canonical_in_one_step(desk_on: DeskOn, name: str) -> None:
    case = scenario(name)
    desk = desk_on(case.base)
    edits = as_sent(desk, case.base, case.edited)
    proposed = desk.canonical(*edits).json()
    net = composed(edits, with_own_ids(desk, proposed["edits"], case.base))
    checked = desk.check(*net).json()
    blocking = [found["code"] for found in checked["violations"] if found["blocks"]]
    assert not [code for code in blocking if not code.startswith(("link.", "geometry.", "neighbor."))], blocking
    assert desk.canonical(*net).json()["edits"] == []


def test_a_stale_draft_is_told_so(desk: Desk) -> None:
    desk.saved(repaint(11))
    refused = desk.canonical(repaint(11, "SOLID_WHITE"))
    assert (refused.status_code, refused.json()["code"]) == (409, "save.stale")
