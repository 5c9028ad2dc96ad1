"""The workspace as an annotator's hands know it: find, drag, paint, draw, save."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from playwright.sync_api import Locator, Page, expect
from playwright.sync_api import TimeoutError as PlaywrightTimeout

Place = tuple[float, float]
EDGES = {"lane_segment": ("left", "right"), "pedestrian_crossing": ("edge1", "edge2")}
ATTRIBUTE = {
    "left": "left_lane_boundary",
    "right": "right_lane_boundary",
    "edge1": "edge1",
    "edge2": "edge2",
}


@dataclass(frozen=True)
class Screen:
    """How city metres and page pixels belong together at the present view (an affine map, fitted to handles)."""

    matrix: np.ndarray

    def pixel(self, place: Place) -> Place:
        x, y = np.array([place[0], place[1], 1.0]) @ self.matrix
        return float(x), float(y)

    def metres_per_pixel(self) -> float:
        return float(1 / np.sqrt(abs(np.linalg.det(self.matrix[:2]))))


class Workspace:
    """One open task in one page."""

    def __init__(self, page: Page, task: int) -> None:
        self.page = page
        self.task = task

    def open(self) -> Workspace:
        self.page.goto(f"/tasks/{self.task}")
        self.settle()
        return self

    def settle(self) -> None:
        """Waits until the map has drawn everything."""
        try:
            self.page.locator('[data-map-state="idle"]').wait_for(timeout=120_000)
        except PlaywrightTimeout as error:
            said = self.page.locator("body").inner_text()
            raise AssertionError(f"The map of task {self.task} does not come to rest; the page says: {said}") from error

    def read(self) -> dict[str, Any]:
        """The workspace as the server tells it, with the asker's own draft."""
        answer = self.page.request.get(f"/api/v1/tasks/{self.task}/workspace")
        expect(answer).to_be_ok()
        document: dict[str, Any] = answer.json()
        return document

    def find(self, kind: str, number: int) -> None:
        """Selects by id and zooms to it."""
        self.tab("Find").click()
        field = self.page.get_by_label("Id of a lane or crossing")
        field.fill(str(number))
        words = {"lane_segment": "Lane", "pedestrian_crossing": "Crossing"}[kind]
        self.page.get_by_role("button", name=f"{words} {number}", exact=True).click()
        expect(self.inspector).to_contain_text(str(number))
        self.press("z")
        self.settle()

    def tab(self, name: str) -> Locator:
        return self.page.get_by_role("tab", name=name)

    @property
    def inspector(self) -> Locator:
        return self.page.get_by_role("complementary", name="Inspector")

    @property
    def saving(self) -> Locator:
        """Where the work is, in words."""
        return self.header.get_by_role("status")

    @property
    def header(self) -> Locator:
        return self.page.get_by_role("banner").first

    @property
    def map(self) -> Locator:
        return self.page.get_by_test_id("map")

    def press(self, key: str) -> None:
        self.map.focus()
        self.page.keyboard.press(key)

    def vertex(self, line: str, index: int) -> Locator:
        return self.page.get_by_test_id(f"vertex-{line}-{index}")

    def centre(self, handle: Locator) -> Place:
        box = handle.bounding_box()
        assert box is not None, f"{handle} is not on the screen"
        return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2

    def screen(self, kind: str, attributes: dict[str, Any]) -> Screen:
        """Fitted to the handles of the selected element, which has these attributes."""
        places, pixels = [], []
        for line in EDGES[kind]:
            for index, point in enumerate(attributes[ATTRIBUTE[line]]):
                handle = self.vertex(line, index)
                if handle.count():
                    places.append((point["x"], point["y"], 1.0))
                    pixels.append(self.centre(handle))
        matrix, *_ = np.linalg.lstsq(np.array(places) - self._shift(places), np.array(pixels), rcond=None)
        shifted = np.eye(3)
        shifted[2, :2] = -self._shift(places)[:2]
        return Screen(shifted @ matrix)

    @staticmethod
    def _shift(places: Sequence[tuple[float, float, float]]) -> np.ndarray:
        """Coordinates of kilometres would cost the fit its digits."""
        return np.array([*np.mean(np.array(places)[:, :2], axis=0), 0.0])

    def drag(self, handle: Locator, dx: float, dy: float) -> None:
        """By so many pixels."""
        x, y = self.centre(handle)
        mouse = self.page.mouse
        mouse.move(x, y)
        mouse.down()
        mouse.move(x + dx, y + dy, steps=4)
        mouse.up()
        self.settle()

    def click(self, pixel: Place) -> None:
        self.page.mouse.click(*pixel)
        self.settle()

    def paint(self, side: str, words: str) -> None:
        """Picks a mark for a side of the selected lane."""
        self.inspector.get_by_label(f"{side} mark").click()
        self.page.get_by_role("option", name=words, exact=True).click()

    def delete(self) -> None:
        self.inspector.get_by_role("button", name="Delete").click()

    def wait_for_draft(self) -> dict[str, Any]:
        """The draft, once the server keeps what the page shows."""
        expect(self.saving).to_contain_text("draft kept", timeout=30_000)
        draft: dict[str, Any] = self.read()["draft"]
        return draft

    def save(self, revision: int) -> None:
        self.press("Control+s")
        expect(self.saving).to_contain_text(f"all saved · revision {revision}", timeout=60_000)

    def submit(self) -> None:
        self.page.get_by_role("button", name="Submit", exact=True).click()
        expect(self.header).to_contain_text("submitted", timeout=30_000)
