"""The whole line, as people walk it: import, annotate, crash, save, review, send back, accept, export, load."""

from __future__ import annotations

import io
import json
import math
import re
import tarfile
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import httpx
import pytest
from playwright.sync_api import Page, Playwright, expect
from tests.e2e.conftest import CHROMIUM_FLAGS, LiveServer, chromium_path, sign_in, sign_in_again
from tests.e2e.profile import Profile
from tests.e2e.scene import Scene, choose
from tests.e2e.workspace import Workspace

GROUP = {"lane_segment": "lane_segments", "pedestrian_crossing": "pedestrian_crossings"}


@dataclass(frozen=True)
class Drive:
    """A log on disk, and how it is imported."""

    folder: Path
    split: str
    direction: str

    @property
    def log_id(self) -> str:
        return self.folder.name

    @property
    def map_file(self) -> Path:
        return next((self.folder / "map").glob("log_map_archive_*.json"))


@pytest.fixture(params=["demo", "real"])
def drive(request: pytest.FixtureRequest, server: LiveServer, tmp_path: Path) -> Drive:
    if request.param == "real":
        return Drive(request.getfixturevalue("real_logs")[0], "test", "prior_to_current")
    made = server.command("demo", str(tmp_path), "--seed", "21", "--logs", "2")
    assert made.returncode == 0, made.stderr
    listed = json.loads((tmp_path / "demo.json").read_text())["logs"]
    chosen = next(log for log in listed if log["direction"] == "current_to_prior")
    return Drive(tmp_path / chosen["log_id"], "train", "current_to_prior")


@pytest.fixture
def profile(playwright: Playwright, server: LiveServer, tmp_path: Path) -> Iterator[Profile]:
    profile = Profile(playwright, chromium_path(), CHROMIUM_FLAGS, tmp_path / "profile", server.address)
    yield profile
    profile.kill()


@pytest.mark.shared
def test_the_whole_line(
    drive: Drive, server: LiveServer, profile: Profile, page_for: Callable[[str], Page], tmp_path: Path
) -> None:
    archive = json.loads(drive.map_file.read_text())
    scene = choose(archive)
    imported = server.command("import", str(drive.folder), "--split", drive.split, "--direction", drive.direction)
    assert imported.returncode == 0, imported.stdout + imported.stderr

    admin = page_for("admin")
    task = create_task(admin, drive.log_id)

    page = profile.start()
    sign_in(page, "annotator")
    work = Workspace(page, task).open()
    annotate(work, archive, scene)
    mend_replacement(work, archive, scene)
    draft = work.wait_for_draft()

    profile.kill()
    page = profile.start()
    sign_in_again(page, "annotator")
    work = Workspace(page, task).open()
    expect(work.saving).to_contain_text(re.compile(r"\d+ changes since revision 0"))
    assert work.wait_for_draft()["edits"] == draft["edits"]
    work.save(1)
    work.submit()

    reviewer = page_for("reviewer")
    send_back(reviewer, task, scene)
    page.reload()
    work.settle()
    expect(page.get_by_text("The crossing is still there in reality.").first).to_be_visible()
    work.find("lane_segment", scene.painted)
    expect(work.inspector).to_contain_text("Solid, not dashed.")
    work.paint("Right", "Double solid white")
    work.wait_for_draft()
    work.save(2)
    work.submit()
    accept(reviewer, drive, task)

    files = export(admin, server, drive.split)
    compare(files, drive, archive, draft, scene)
    load_with_av2(files, drive, tmp_path)


def create_task(admin: Page, log_id: str) -> int:
    """Through the page of logs; assigned to the annotator."""
    admin.goto(f"/logs?q={log_id}")
    admin.get_by_role("checkbox", name=f"Log {log_id}").check()
    admin.get_by_role("button", name="Create tasks…").click()
    dialog = admin.get_by_role("dialog")
    dialog.get_by_label("Assignee").click()
    admin.get_by_role("option", name="annotator").click()
    dialog.get_by_role("button", name="Create").click()
    dialog.wait_for(state="hidden")
    admin.goto(f"/tasks?q={log_id}")
    link = admin.get_by_role("link", name=re.compile(r"^Task \d+$"))
    return int(link.inner_text().split()[1])


def annotate(work: Workspace, archive: dict[str, Any], scene: Scene) -> None:
    """A shared boundary moves, a mark changes, a lane comes beside another, a crossing goes."""
    lanes = {lane["id"]: lane for lane in archive["lane_segments"].values()}

    work.find("lane_segment", scene.shared)
    shared = lanes[scene.shared]
    screen = work.screen("lane_segment", shared)
    index = len(shared["right_lane_boundary"]) // 2
    dx, dy = towards_left(shared, index, screen)
    work.drag(work.vertex("right", index), dx, dy)
    expect(work.saving).to_contain_text("2 changes since revision 0")
    drawn = {edit["id"]: edit["attributes"] for edit in work.wait_for_draft()["edits"]}
    here = drawn[scene.shared]["right_lane_boundary"][index]
    was = screen.pixel((shared["right_lane_boundary"][index]["x"], shared["right_lane_boundary"][index]["y"]))
    now = screen.pixel((here["x"], here["y"]))
    assert math.dist(now, (was[0] + dx, was[1] + dy)) < 1.5 + 0.01 / screen.metres_per_pixel()
    assert drawn[scene.sharer]["left_lane_boundary"] == drawn[scene.shared]["right_lane_boundary"]

    work.find("lane_segment", scene.painted)
    work.paint("Right", "Dashed yellow")

    work.find("lane_segment", scene.widened)
    widened = lanes[scene.widened]
    beside = near_right_side(widened, work.screen("lane_segment", widened))
    work.press("b")
    work.click(beside)
    expect(work.inspector).to_contain_text("inserted")

    work.find("pedestrian_crossing", scene.crossing)
    work.delete()
    work.tab("Changes").click()
    expect(work.page.get_by_text(f"Crossing {scene.crossing} deleted").first).to_be_visible(timeout=30_000)


def mend_replacement(work: Workspace, archive: dict[str, Any], scene: Scene) -> None:
    """A lane deleted and drawn anew between the same junctions: the rule says so, and its fix makes it an edit."""
    lane = archive["lane_segments"][str(scene.replaced)]
    work.find("lane_segment", scene.replaced)
    screen = work.screen("lane_segment", lane)
    ends = [
        screen.pixel(tuple((left[axis] + right[axis]) / 2 for axis in "xy"))  # type: ignore[arg-type]
        for left, right in ((lane["left_lane_boundary"][i], lane["right_lane_boundary"][i]) for i in (0, -1))
    ]
    work.delete()
    work.press("2")
    work.click(ends[0])
    work.click(ends[1])
    expect(work.inspector).to_contain_text("inserted")
    work.tab("Issues").click()
    issue = work.page.get_by_role("article").filter(has_text="Replacement unjustified")
    expect(issue).to_contain_text(f"Lane {scene.replaced}", timeout=30_000)
    stopped = work.page.get_by_role("button", name=re.compile("stops? the save"))
    expect(stopped).to_be_visible()
    issue.get_by_role("button", name=re.compile(f"lane {scene.replaced}")).click()
    expect(issue).to_have_count(0, timeout=30_000)
    expect(stopped).to_have_count(0)


def towards_left(lane: dict[str, Any], index: int, screen: Any) -> tuple[float, float]:
    """0.6 m from a vertex of the right boundary towards the left one, in pixels."""
    at = lane["right_lane_boundary"][index]
    goal = min(lane["left_lane_boundary"], key=lambda p: math.dist((p["x"], p["y"]), (at["x"], at["y"])))
    before, after = lane["right_lane_boundary"][index - 1], lane["right_lane_boundary"][index + 1]
    along = (after["x"] - before["x"], after["y"] - before["y"])
    normal = (-along[1] / math.hypot(*along), along[0] / math.hypot(*along))
    side = math.copysign(1, normal[0] * (goal["x"] - at["x"]) + normal[1] * (goal["y"] - at["y"]))
    start = screen.pixel((at["x"], at["y"]))
    end = screen.pixel((at["x"] + side * 0.6 * normal[0], at["y"] + side * 0.6 * normal[1]))
    return end[0] - start[0], end[1] - start[1]


def near_right_side(lane: dict[str, Any], screen: Any) -> tuple[float, float]:
    """A pixel inside the lane, nearer to the middle of its right boundary."""
    right, left = lane["right_lane_boundary"], lane["left_lane_boundary"]
    i = max(1, len(right) // 2)
    middle = [(right[i][axis] + right[i - 1][axis]) / 2 for axis in "xy"]
    j = max(1, len(left) // 2)
    across = [(left[j][axis] + left[j - 1][axis]) / 2 for axis in "xy"]
    pixel: tuple[float, float] = screen.pixel(tuple(m + 0.2 * (a - m) for m, a in zip(middle, across, strict=True)))
    return pixel


def send_back(reviewer: Page, task: int, scene: Scene) -> None:
    look = Workspace(reviewer, task).open()
    look.find("lane_segment", scene.painted)
    reviewer.get_by_label("Remark for the annotator").fill("Solid, not dashed.")
    look.header.get_by_role("button", name=re.compile("Send back")).click()
    dialog = reviewer.get_by_role("dialog")
    dialog.get_by_label("Reason").fill("The crossing is still there in reality.")
    dialog.get_by_role("button", name="Send back").click()
    expect(look.header).to_contain_text("changes requested", timeout=30_000)


def accept(reviewer: Page, drive: Drive, task: int) -> None:
    """From the queue, by keyboard."""
    reviewer.goto(f"/review?q={drive.log_id}")
    expect(reviewer.get_by_label(f"Task {task}", exact=True)).to_be_visible(timeout=30_000)
    reviewer.keyboard.press("g")
    expect(reviewer.get_by_text(f"Press G again to accept task {task}")).to_be_visible()
    reviewer.keyboard.press("g")
    expect(reviewer.get_by_text(re.compile(rf"Task {task} .*accepted"))).to_be_visible(timeout=30_000)


def export(admin: Page, server: LiveServer, split: str) -> dict[str, bytes]:
    """With a token made on the account page, as a pipeline would."""
    admin.goto("/account")
    form = admin.get_by_role("form", name="New token")
    form.get_by_label("Name").fill(f"pipeline {split}")
    form.get_by_role("button", name="Create").click()
    token = admin.get_by_role("alert").locator("code").first.inner_text()
    answer = httpx.get(
        f"{server.address}/api/v1/export/{split}.tar", headers={"Authorization": f"Bearer {token}"}, timeout=120
    )
    answer.raise_for_status()
    with tarfile.open(fileobj=io.BytesIO(answer.content)) as tar:
        return {member.name: tar.extractfile(member).read() for member in tar if member.isfile()}  # type: ignore[union-attr]


def compare(
    files: dict[str, bytes], drive: Drive, archive: dict[str, Any], draft: dict[str, Any], scene: Scene
) -> None:
    """What was drawn to 0.01 m, and bit for bit elsewhere."""
    base_side, edited_side = ("prior", "current") if drive.direction == "prior_to_current" else ("current", "prior")
    base_text = files[f"{base_side}/{drive.log_id}/map/{drive.map_file.name}"]
    assert base_text == drive.map_file.read_bytes()
    edited = json.loads(files[f"{edited_side}/{drive.log_id}/map/{drive.map_file.name}"])
    assert edited["drivable_areas"] == archive["drivable_areas"]
    touched = {(edit["kind"], edit["id"]): edit for edit in draft["edits"]}
    for kind, group in GROUP.items():
        for number in archive[group].keys() | edited[group].keys():
            edit = touched.get((kind, int(number)))
            if edit is None:
                assert edited[group][number] == archive[group][number]
            elif edit["operation"] == "delete":
                assert number not in edited[group]
            else:
                assert_drawn(edit, edited[group][number], archive[group].get(number, {}), scene)
    changes = json.loads(files[f"changes/{drive.log_id}.json"])["changes"]
    said = {change["id"]: change["categories"] for change in changes}
    gone = "deletion" if drive.direction == "prior_to_current" else "insertion"
    assert said[scene.crossing] == [gone]
    assert said[scene.painted] == ["marking"]
    assert said[scene.shared] == said[scene.sharer] == ["geometry"]
    assert scene.replaced not in said or gone not in said[scene.replaced]


def assert_drawn(edit: dict[str, Any], now: dict[str, Any], was: dict[str, Any], scene: Scene) -> None:
    expected = {**was, **edit["attributes"]}
    if edit["id"] == scene.painted:
        expected["right_lane_mark_type"] = "DOUBLE_SOLID_WHITE"
    for name, value in expected.items():
        if isinstance(value, list) and value and isinstance(value[0], dict):
            assert [point["z"] for point in now[name]]
            for drawn, stored in zip(value, now[name], strict=True):
                assert math.dist((drawn["x"], drawn["y"]), (stored["x"], stored["y"])) <= 0.01
                assert drawn["z"] is None or drawn["z"] == stored["z"]
        else:
            assert now[name] == value, name


def load_with_av2(files: dict[str, bytes], drive: Drive, tmp_path: Path) -> None:
    from av2.map.map_api import ArgoverseStaticMap

    for name, body in files.items():
        target = tmp_path / "export" / name
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_bytes(body)
    for side in ("prior", "current"):
        folder = tmp_path / "export" / side / drive.log_id / "map"
        loaded = ArgoverseStaticMap.from_map_dir(folder, build_raster=True)
        document = json.loads(files[f"{side}/{drive.log_id}/map/{drive.map_file.name}"])
        assert set(loaded.vector_lane_segments) == {int(number) for number in document["lane_segments"]}
