"""Drawing on a map whose coordinates are known, by an annotator's gestures."""

from __future__ import annotations

import re
from typing import Any

from playwright.sync_api import Page, expect
from tests.e2e.workspace import Place, Workspace


def middle(points: list[dict[str, float]]) -> Place:
    """Of a line: its middle vertex, or the middle of its middle piece."""
    one, other = points[(len(points) - 1) // 2], points[len(points) // 2]
    return (one["x"] + other["x"]) / 2, (one["y"] + other["y"]) / 2


class Drawing:
    """One open task; places are city metres."""

    def __init__(self, page: Page, task: int, base: dict[str, Any]) -> None:
        self.page = page
        self.work = Workspace(page, task).open()
        self._lanes = {lane["id"]: lane for lane in base["lane_segments"].values()}

    def select(self, lane: int) -> None:
        """By a click on an imported lane that was not reshaped before, a little off its middle."""
        left, right = (self._lanes[lane][f"{side}_lane_boundary"] for side in ("left", "right"))
        x, y = (0.35 * middle(left)[axis] + 0.65 * middle(right)[axis] for axis in (0, 1))
        self.click_lane((x, y))
        expect(self.page.get_by_test_id("selected")).to_have_attribute("data-element", f"lane_segment:{lane}")

    def click_lane(self, place: Place) -> None:
        self.work.click(self.pixel(place))

    def pixel(self, place: Place) -> Place:
        """Where a place is on the page; the map says how it lies."""
        a, b, c, d, e, f = (
            float(number) for number in (self.work.map.get_attribute("data-city-to-screen") or "").split()
        )
        box = self.work.map.bounding_box()
        assert box is not None, "the map is not on the screen"
        return box["x"] + a * place[0] + c * place[1] + e, box["y"] + b * place[0] + d * place[1] + f

    def drag(self, side: str, index: int, to: Place) -> None:
        """A vertex of the selected lane."""
        handle = self.work.vertex(side, index)
        x, y = self.work.centre(handle)
        goal = self.pixel(to)
        self.work.drag(handle, goal[0] - x, goal[1] - y)

    def delete(self) -> None:
        """The selected lane."""
        self.work.delete()
        expect(self.page.get_by_test_id("selected")).to_have_count(0)

    def paint(self, side: str, words: str) -> None:
        self.work.paint(side, words)

    def choose_type(self, words: str) -> None:
        self.work.inspector.get_by_label("Type").click()
        self.page.get_by_role("option", name=words, exact=True).click()

    def unlink(self, words: str, lane: int) -> None:
        self.work.inspector.get_by_role("button", name=f"Unlink {words} lane {lane}").click()

    def cut(self, lane: int, place: Place) -> None:
        """Whatever lane lies there; its second part is selected then."""
        self.work.press("x")
        self.work.click(self.pixel(place))
        expect(self.work.inspector).to_contain_text(f"part of lane {lane}")

    def insert_beside(self, place: Place) -> None:
        """A lane on that side of the lane under the place to which the place is nearer."""
        self.work.press("b")
        self.work.click(self.pixel(place))
        expect(self.work.inspector).to_contain_text("inserted")

    def lane(self, *places: Place) -> None:
        """Along clicks, finished by Enter unless the last one caught a lane's start."""
        self.work.press("2")
        for place in places:
            self.work.click(self.pixel(place))
        if self.page.get_by_role("button", name="Draw a lane").get_attribute("aria-pressed") == "true":
            self.work.press("Enter")
        expect(self.work.inspector).to_contain_text("inserted")

    def wait_for_check(self) -> None:
        """Until the list of changes, which is open, tells what the server says of the last edit."""
        changes = self.page.get_by_role("tabpanel", name="Changes")
        expect(changes.locator('[aria-busy="false"]')).to_have_count(1, timeout=30_000)

    def told_changes(self) -> list[tuple[str, list[str]]]:
        """Rows of the list of changes: lane id, and categories in words."""
        rows = self.page.get_by_role("complementary", name="Lists").get_by_role("button", name=re.compile("Lane "))
        told = []
        for words in rows.all_inner_texts():
            categories, headline = words.splitlines()[:2]
            match = re.search(r"Lane (\d+)", headline)
            assert match, words
            told.append((match.group(1), categories.split(", ")))
        return told

    def told_issues(self) -> list[tuple[str, list[int]]]:
        """Issues: rule, and the lanes that they name."""
        told = []
        for issue in self.page.get_by_role("article").all():
            rule = issue.get_by_role("link").get_attribute("href") or ""
            lanes = issue.get_by_role("button", name=re.compile(r"^Lane \d+$")).all_inner_texts()
            told.append((rule.removeprefix("/rules/"), [int(words.split()[1]) for words in lanes]))
        return told

    def stored_changes(self) -> list[dict[str, Any]]:
        """The atomic changes of revision 1, as the server stored them."""
        answer = self.page.request.get(f"/api/v1/tasks/{self.work.task}/revisions/1/findings")
        expect(answer).to_be_ok()
        changes: list[dict[str, Any]] = answer.json()["changes"]
        return changes
