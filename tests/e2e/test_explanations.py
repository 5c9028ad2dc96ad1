"""Cuts, the canonical form, declared macros and the rules' pages, as an annotator meets them in the workspace."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Browser, Page, expect
from tests.e2e.conftest import LiveServer
from tests.e2e.drawing import Drawing
from tests.e2e.small_tasks import tasks_on

FIXTURES = Path(__file__).parents[1] / "fixtures" / "bijective"
SERIES: dict[str, Any] = json.loads((FIXTURES / "marks_mid_lane.json").read_text())["base"]


def lane(key: int, top: float, bottom: float) -> dict[str, Any]:
    """A free lane of 40 m, eastwards."""
    (_, like), *_ = SERIES["lane_segments"].items()
    lines = {
        f"{side}_lane_boundary": [{"x": x, "y": y, "z": 0.0} for x in (0.0, 40.0)]
        for side, y in (("left", top), ("right", bottom))
    }
    return {**like, **lines, "id": key, "successors": [], "predecessors": []}


APART: dict[str, Any] = {
    "lane_segments": {"1": lane(1, 3.5, 0.0), "2": lane(2, 9.0, 5.5)},
    "pedestrian_crossings": {},
    "drivable_areas": {},
}


@pytest.fixture(scope="module")
def tasks(server: LiveServer, chromium: Browser, tmp_path_factory: pytest.TempPathFactory) -> dict[str, int]:
    maps = {"cut": SERIES, "canonical": APART}
    return tasks_on(server, chromium, tmp_path_factory.mktemp("logs"), "Explanation", maps)


def test_a_lane_is_cut_where_its_mark_changes_and_its_macros_are_declared(
    tasks: dict[str, int], page_for: Callable[[str], Page]
) -> None:
    page = page_for("annotator")
    draw = Drawing(page, tasks["cut"], SERIES)
    work = draw.work
    lists = page.get_by_role("complementary", name="Lists")
    changes = lists.get_by_role("button", name=re.compile("Lane "))
    issues = page.get_by_role("article")

    draw.cut(1, (40, 1.75))
    work.tab("Issues").click()
    expect(issues.get_by_role("link", name="replacement.unjustified")).to_be_visible(timeout=30_000)
    draw.paint("Left", "Dashed white")
    expect(issues).to_have_count(0, timeout=30_000)
    work.tab("Changes").click()
    expect(changes).to_have_text([re.compile(r"marking.*left mark solid white → dashed white")])

    lists.get_by_role("button", name="Declare…").click()
    form = page.get_by_role("form", name="Declare macros")
    expect(form.get_by_label("Appearance")).to_be_checked()
    form.get_by_label("Lane graph").check()
    form.get_by_role("button", name="Declare").click()
    expect(lists.get_by_role("button", name="declared otherwise")).to_be_visible()
    work.tab("Issues").click()
    issues.get_by_role("link", name="macro.mismatch").click()
    rule = page.get_by_role("dialog", name="Macro mismatch")
    expect(rule.get_by_role("heading", name="How to mend")).to_be_visible()
    page.keyboard.press("Escape")
    expect(rule).to_be_hidden()
    issues.get_by_role("button", name="Declare the derived macros").click()
    expect(issues).to_have_count(0, timeout=30_000)

    work.save(1)
    page.reload()
    work.settle()
    expect(work.inspector).to_contain_text("part of lane 1")
    expect(lists.get_by_role("button", name="declared")).to_be_visible()
    expect(changes).to_have_count(1)
    work.tab("Changes").click()
    page.keyboard.press("c")  # with the focus in the lists, not on the map
    expect(page.get_by_text(re.compile("differ in the left mark"))).to_be_visible()
    work.inspector.get_by_role("button", name="Revert").click()
    expect(changes).to_have_count(0, timeout=30_000)
    expect(page.get_by_test_id("selected")).to_have_attribute("data-element", "lane_segment:1")


def test_a_save_tells_the_simpler_story_and_says_so(tasks: dict[str, int], page_for: Callable[[str], Page]) -> None:
    page = page_for("annotator")
    page.set_viewport_size({"width": 1440, "height": 900})  # the inspector stands beside the map, not over it
    draw = Drawing(page, tasks["canonical"], APART)
    work = draw.work
    rows = page.get_by_role("complementary", name="Lists").get_by_role("button", name=re.compile("Lane "))

    draw.select(1)
    draw.delete()
    draw.select(2)
    for index, x in enumerate((0, 40)):
        draw.drag("right", index, (x, 0))
        draw.drag("left", index, (x, 3.5))
    draw.lane((0, 7.5), (40, 7.5))
    draw.click_lane((20, 1.2))
    work.tab("Changes").click()
    expect(rows).to_have_count(3, timeout=30_000)

    work.press("m")
    expect(page.get_by_text(re.compile(r"Made canonical\. 2 ids exchanged: lane 2 is now lane 1"))).to_be_visible()
    expect(rows).to_have_text([re.compile("geometry.*Lane 2")], timeout=30_000)
    expect(page.get_by_test_id("selected")).to_have_attribute("data-element", "lane_segment:1")
    work.press("Control+z")
    expect(rows).to_have_count(3, timeout=30_000)

    work.save(1)
    expect(page.get_by_text(re.compile("Told as the simpler story: lane 2 is now lane 1"))).to_be_visible()
    expect(rows).to_have_text([re.compile("geometry.*Lane 2")])
