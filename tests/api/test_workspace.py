"""The task opened in the editor: workspace, drive, lidar image, findings, drafts and new ids."""

from __future__ import annotations

import pytest
from sqlalchemy import select, update
from sqlalchemy.orm import Session
from tests.api.conftest import AddAccount, ClientFor
from tests.api.desk import Desk, insert_crossing, remove_crossing, repaint, table_counts
from tests.api.desk import update as change
from tests.stored_logs import add_log, lane

from lanewright.api.schemas.findings import Findings
from lanewright.api.schemas.tasks import DraftOut, Drive, Workspace
from lanewright.core.workflow import Role
from lanewright.db.models import Account, IdBlock, Log
from lanewright.db.repositories.logs import insert_asset


def test_the_workspace_is_what_its_schema_says(desk: Desk) -> None:
    desk.saved(repaint(11), remove_crossing())
    desk.keep_draft(repaint(12), base=1)
    opened = Workspace.model_validate(desk.open())
    assert (opened.task.id, opened.revision, opened.task.head) == (desk.task_id, 1, 1)
    assert [lane.attributes.id for lane in opened.base.lanes] == [11, 12]
    assert opened.frame.epsg == 32618
    assert opened.drivable_areas == [[(0.0, 0.0), (20.0, 0.0), (20.0, 8.0), (0.0, 8.0)]]
    assert opened.draft
    assert opened.draft.edits[0].id == 12
    assert [(entry.number, entry.author and entry.author.name) for entry in opened.revisions] == [
        (0, None),
        (1, "anna"),
    ]


def test_imported_coordinates_arrive_bit_for_bit(desk: Desk) -> None:
    (first, _) = desk.open()["base"]["lanes"]
    assert first["attributes"]["right_lane_boundary"][1] == {"x": 10.0, "y": 0.0, "z": 1.2}
    assert first["attributes"]["successors"] == [99]


def test_the_drive_tells_places_headings_and_times_as_text(desk: Desk) -> None:
    answer = Drive.model_validate(desk.client.get(f"{desk.address}/drive").json())
    assert answer.trajectory == [(0.0, 2.0), (6.0, 2.0)]
    assert [(frame.x, frame.heading_rad) for frame in answer.frames] == [(0.0, 0.0), (6.0, 0.0)]
    assert answer.frames[1].timestamp_ns == "315966265259836001"


def test_findings_of_any_revision_can_be_read(desk: Desk) -> None:
    desk.saved(repaint(11))
    desk.saved(remove_crossing(), base=1)
    counts = []
    for revision in (0, 1, 2):
        answer = desk.client.get(f"{desk.address}/revisions/{revision}/findings")
        counts.append(len(Findings.model_validate(answer.json()).changes))
    assert counts == [0, 1, 2]
    for unknown in (3, -1, 2**70):
        assert desk.client.get(f"{desk.address}/revisions/{unknown}/findings").status_code in (404, 422)


def test_the_lidar_image_is_sent_once_and_then_known_by_its_hash(desk: Desk, session: Session) -> None:
    log = session.scalars(select(Log)).one()
    address = f"/api/v1/logs/{log.log_id}/lidar.png"
    assert desk.client.get(address).status_code == 404
    assert desk.open()["lidar"] is None
    details = {"bounds": [0.0, 0.0, 20.0, 8.0], "metres_per_pixel": 0.1, "sweeps": 1}
    insert_asset(session, log.id, "lidar.png", "image/png", b"\x89PNG", details)
    first = desk.client.get(address)
    assert (first.content, first.headers["content-type"]) == (b"\x89PNG", "image/png")
    assert "immutable" in first.headers["cache-control"]
    again = desk.client.get(address, headers={"If-None-Match": f'"x", {first.headers["etag"]}'})
    assert (again.status_code, again.content) == (304, b"")
    assert desk.open()["lidar"] == {"url": address, "bounds": [0.0, 0.0, 20.0, 8.0], "metres_per_pixel": 0.1}


def test_annotators_get_the_images_of_their_own_logs_only(
    desk: Desk, session: Session, client_for: ClientFor, add_account: AddAccount
) -> None:
    log = session.scalars(select(Log)).one()
    insert_asset(session, log.id, "lidar.png", "image/png", b"\x89PNG", {})
    address = f"/api/v1/logs/{log.log_id}/lidar.png"
    assert client_for(add_account(Role.ANNOTATOR, "stranger")).get(address).status_code == 404
    assert client_for(Role.REVIEWER).get(address).status_code == 200
    assert desk.client.get(address).status_code == 200
    assert desk.client.get("/api/v1/logs").status_code == 403


def test_logs_are_listed_with_their_figures(desk: Desk, session: Session, client_for: ClientFor) -> None:
    add_log(session, "log-two", city="PIT", split="test", direction="prior_to_current")
    reviewer = client_for(Role.REVIEWER)
    page = reviewer.get("/api/v1/logs").json()
    assert [(log["log_id"], log["tasks"], log["lanes"]) for log in page["items"]] == [
        ("log-one", 1, 2),
        ("log-two", 0, 2),
    ]
    for query in ({"q": "TWO"}, {"city": "PIT"}, {"split": "test"}):
        assert [log["log_id"] for log in reviewer.get("/api/v1/logs", params=query).json()["items"]] == ["log-two"]


def test_drafts_of_two_devices_do_not_overwrite_each_other(desk: Desk) -> None:
    first = desk.keep_draft(repaint(11)).json()["version"]
    second = desk.keep_draft(repaint(11), repaint(12), version=first).json()["version"]
    assert second > first
    for stale in (0, first):
        refused = desk.keep_draft(remove_crossing(), version=stale)
        assert (refused.status_code, refused.json()["code"]) == (409, "draft.newer")
        newer = DraftOut.model_validate(refused.json()["facts"]["draft"])
        assert (newer.version, [kept.id for kept in newer.edits]) == (second, [11, 12])
    assert desk.open()["draft"]["version"] == second


def test_a_draft_that_was_dropped_in_between_is_not_mistaken_for_an_old_one(desk: Desk) -> None:
    old = desk.keep_draft(repaint(11)).json()["version"]
    assert desk.client.delete(f"{desk.address}/draft").status_code == 204
    assert desk.open()["draft"] is None
    desk.keep_draft(repaint(12))
    assert desk.keep_draft(repaint(11), version=old).status_code == 409


@pytest.mark.parametrize("kept_before", [True, False])
def test_a_draft_that_arrives_after_its_save_does_not_come_back(desk: Desk, kept_before: bool) -> None:
    seen = desk.keep_draft(repaint(11)).json()["version"] if kept_before else 0
    desk.saved(repaint(11))
    late = desk.keep_draft(repaint(11), version=seen)
    assert (late.status_code, late.json()["code"]) == (409, "draft.superseded")
    assert late.json()["facts"]["revision"] == 1
    assert desk.open()["draft"] is None
    assert desk.client.delete(f"{desk.address}/draft").status_code == 204
    assert desk.keep_draft(repaint(11), version=seen).status_code == 409, "dropping what is not there changes nothing"


def test_a_draft_begun_before_a_save_is_kept_where_its_writer_insists(desk: Desk) -> None:
    desk.saved(repaint(11))
    version = desk.keep_draft(repaint(12)).json()["facts"]["version"]
    assert desk.keep_draft(repaint(12), version=version).status_code == 200
    assert desk.open()["draft"]["edits"] == [repaint(12)]


def test_the_draft_after_a_save_is_kept(desk: Desk) -> None:
    desk.keep_draft(repaint(11))
    desk.saved(repaint(11))
    assert desk.keep_draft(repaint(12), base=1).status_code == 200
    assert desk.open()["draft"]["edits"] == [repaint(12)]


def test_a_draft_may_hold_what_the_rules_would_refuse(desk: Desk) -> None:
    heap = [{"x": 1.0, "y": 1.0, "z": None}] * 3
    assert desk.keep_draft(change(11, left_lane_boundary=heap)).status_code == 200
    (kept,) = desk.open()["draft"]["edits"]
    assert kept == change(11, left_lane_boundary=heap)


def test_each_person_has_a_draft_of_their_own(desk: Desk, client_for: ClientFor, session: Session) -> None:
    boss = session.scalars(select(Account).where(Account.name == "boss")).one()
    other = Desk(client_for(boss), desk.task_id)
    desk.keep_draft(repaint(11))
    other.keep_draft(repaint(12))
    assert [one.open()["draft"]["edits"][0]["id"] for one in (desk, other)] == [11, 12]


def test_new_ids_come_in_blocks_that_never_overlap(desk: Desk, client_for: ClientFor, session: Session) -> None:
    boss = session.scalars(select(Account).where(Account.name == "boss")).one()
    other = Desk(client_for(boss), desk.task_id)
    blocks = [one.client.post(f"{one.address}/id-blocks").json() for one in (desk, other, desk)]
    assert [(block["first_id"], block["last_id"]) for block in blocks] == [(1000, 1099), (1100, 1199), (1200, 1299)]


def test_when_the_ids_run_out_it_is_said(desk: Desk, session: Session) -> None:
    session.execute(update(Log).values(next_new_id=9950))
    refused = desk.client.post(f"{desk.address}/id-blocks")
    assert (refused.status_code, refused.json()["code"]) == (409, "ids.exhausted")
    assert session.scalars(select(IdBlock)).all() == []


def test_only_ids_from_ones_own_blocks_can_be_inserted(desk: Desk, client_for: ClientFor, session: Session) -> None:
    boss = session.scalars(select(Account).where(Account.name == "boss")).one()
    others = Desk(client_for(boss), desk.task_id).new_id()
    mine = desk.new_id()
    counts = table_counts(session)
    for identity in (others, 5, mine + 100, 2**31):
        refused = desk.save(insert_crossing(identity))
        assert (refused.status_code, refused.json()["code"]) == (422, "ids.not_reserved")
        assert f"pedestrian_crossing {identity}" in refused.json()["message"]
        assert desk.check(insert_crossing(identity)).json()["code"] == "ids.not_reserved"
    assert table_counts(session) == counts
    assert desk.saved(insert_crossing(mine))["revision"] == 1


def test_an_id_is_never_used_for_something_else_but_a_deletion_can_be_taken_back(desk: Desk) -> None:
    mine = desk.new_id()
    desk.saved(insert_crossing(mine))
    desk.saved({"operation": "delete", "kind": "pedestrian_crossing", "id": mine, "attributes": {}}, base=1)
    elsewhere = insert_crossing(mine, x=14.0)
    refused = desk.save(elsewhere, base=2)
    assert (refused.status_code, refused.json()["code"]) == (422, "save.violations")
    (violation,) = refused.json()["facts"]["violations"]
    assert (violation["code"], violation["elements"]) == ("identity.reused", [mine])
    (found,) = desk.check(elsewhere, base=2).json()["violations"]
    (fix,) = found["fixes"]
    assert [(one["operation"], one["id"] == mine) for one in fix["edits"]] == [("delete", True), ("insert", False)]
    assert desk.saved(insert_crossing(mine, x=10.5), base=2)["revision"] == 3


def test_a_lane_cannot_have_the_id_of_a_crossing(desk: Desk) -> None:
    mine = desk.new_id()
    attributes = {name: value for name, value in lane(mine, left_neighbor_id=None).items() if name != "id"}
    drawn = {"operation": "insert", "kind": "lane_segment", "id": mine, "attributes": attributes}
    together = desk.check(insert_crossing(mine), drawn)
    desk.saved(insert_crossing(mine))
    for refused in (together, desk.save(drawn, base=1)):
        assert (refused.status_code, refused.json()["code"]) == (422, "ids.taken")
        assert str(mine) in refused.json()["message"]


def test_a_deleted_element_of_the_base_can_be_brought_back(desk: Desk) -> None:
    (crossing,) = desk.open()["base"]["crossings"]
    desk.saved(remove_crossing())
    attributes = {name: value for name, value in crossing["attributes"].items() if name != "id"}
    back = {"operation": "insert", "kind": "pedestrian_crossing", "id": 21, "attributes": attributes}
    answer = desk.saved(back, base=1)
    assert answer["findings"]["changes"] == []


@pytest.mark.parametrize(
    ("query", "found"),
    [
        ({}, ["marking", "deletion"]),
        ({"category": "deletion"}, ["deletion"]),
        ({"city": "PIT"}, []),
        ({"city": "WDC", "split": "train"}, ["marking", "deletion"]),
        ({"accepted": "true"}, []),
    ],
)
def test_changes_are_queried_by_category_city_and_split(
    desk: Desk, client_for: ClientFor, query: dict[str, str], found: list[str]
) -> None:
    desk.saved(repaint(11), repaint(12, "SOLID_WHITE"))
    desk.saved(repaint(12, "NONE"), remove_crossing(), base=1)
    page = client_for(Role.REVIEWER).get("/api/v1/changes", params=query)
    assert page.status_code == 200, page.text
    assert [row["category"] for row in page.json()["items"]] == found
    assert page.json()["total"] == len(found)
    assert {row["revision"] for row in page.json()["items"]} <= {2}
    assert desk.client.get("/api/v1/changes").status_code == 403
