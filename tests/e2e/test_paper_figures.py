"""The paper's three figures (change mapping §9), drawn as an annotator draws them: what the workspace says of each is
what its fixture says."""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Browser, Page, expect
from tests.e2e.conftest import LiveServer, sign_in
from tests.e2e.drawing import Drawing
from tests.e2e.small_tasks import tasks_on

FIXTURES = Path(__file__).parents[1] / "fixtures" / "bijective"


def bike_to_vehicle_in_place(draw: Drawing) -> None:
    draw.select(2)
    draw.drag("right", 0, (0, 0))
    draw.drag("right", 1, (50, 0))
    draw.paint("Left", "Solid white")
    draw.choose_type("Vehicle")


def bike_to_vehicle_replaced(draw: Drawing) -> None:
    draw.select(2)
    draw.delete()
    draw.select(1)
    draw.insert_beside((25, 3.8))
    draw.paint("Left", "Solid white")
    draw.paint("Right", "Solid white")


def lane_added_right(draw: Drawing) -> None:
    draw.select(1)
    for index, x in enumerate((0, 60)):
        draw.drag("left", index, (x, 7))
        draw.drag("right", index, (x, 3.5))
    draw.paint("Right", "Dashed white")
    draw.insert_beside((30, 3.8))
    draw.paint("Right", "Solid white")


def lane_added_left(draw: Drawing) -> None:
    draw.select(1)
    for index, x in enumerate((0, 60)):
        draw.drag("left", index, (x, 3.5))
    draw.paint("Left", "Dashed white")
    draw.insert_beside((30, 3.2))
    draw.paint("Left", "Solid yellow")


def lane_added_all_replaced(draw: Drawing) -> None:
    draw.select(1)
    draw.delete()
    draw.lane((0, 1.75), (60, 1.75))
    draw.paint("Left", "Dashed white")
    draw.paint("Right", "Solid white")
    draw.insert_beside((30, 3.2))
    draw.paint("Left", "Solid yellow")


def right_turn_inserted(draw: Drawing) -> None:
    draw.lane((0, 1.75), (8.25, -10))


def right_turn_rerouted_in_place(draw: Drawing) -> None:
    draw.select(51)
    draw.unlink("from", 12)
    draw.drag("left", 0, (0, 7))
    draw.drag("right", 0, (0, 3.5))
    draw.drag("left", 1, (7, 4.5))
    draw.drag("right", 1, (4, 1.5))


def right_turn_rerouted_replaced(draw: Drawing) -> None:
    draw.select(51)
    draw.delete()
    draw.lane((0, 5.25), (8.25, -10))


def outer_lane_removed_turn_in_place(draw: Drawing) -> None:
    for lane in (12, 22, 42):
        draw.select(lane)
        draw.delete()
    draw.select(51)
    draw.drag("left", 0, (0, 7))
    draw.drag("right", 0, (0, 3.5))
    draw.drag("left", 1, (7, 4.5))
    draw.drag("right", 1, (4, 1.5))


def outer_lane_removed_turn_replaced(draw: Drawing) -> None:
    for lane in (12, 22, 42, 51):
        draw.select(lane)
        draw.delete()
    draw.lane((0, 5.25), (8.25, -10))


FIGURES: list[Callable[[Drawing], None]] = [
    bike_to_vehicle_in_place,
    bike_to_vehicle_replaced,
    lane_added_right,
    lane_added_left,
    lane_added_all_replaced,
    right_turn_inserted,
    right_turn_rerouted_in_place,
    right_turn_rerouted_replaced,
    outer_lane_removed_turn_in_place,
    outer_lane_removed_turn_replaced,
]


def fixture(name: str) -> dict[str, Any]:
    document: dict[str, Any] = json.loads((FIXTURES / f"{name}.json").read_text())
    return document


@pytest.fixture(scope="module")
def tasks(server: LiveServer, chromium: Browser, tmp_path_factory: pytest.TempPathFactory) -> dict[str, int]:
    """A task per figure, on a log whose map is the fixture's base."""
    maps = {figure.__name__: fixture(figure.__name__)["base"] for figure in FIGURES}
    return tasks_on(server, chromium, tmp_path_factory.mktemp("figures"), "PaperFigure", maps)


@pytest.fixture(scope="module")
def annotator(server: LiveServer, chromium: Browser) -> Iterator[Page]:
    with chromium.new_context(base_url=server.address, viewport={"width": 1440, "height": 900}) as context:
        page = context.new_page()
        sign_in(page, "annotator")
        yield page


@pytest.mark.parametrize("figure", FIGURES, ids=lambda figure: figure.__name__)
def test_a_figure_drawn_is_told_as_its_fixture_says(
    figure: Callable[[Drawing], None], tasks: dict[str, int], annotator: Page
) -> None:
    expected = fixture(figure.__name__)
    draw = Drawing(annotator, tasks[figure.__name__], expected["base"])
    figure(draw)

    changes = {named(int(key), expected): value for key, value in expected["changes"].items()}
    inserted = [key for key in expected["changes"] if named(int(key), expected) == "new"]
    draw.work.tab("Changes").click()
    draw.wait_for_check()
    rows = annotator.get_by_role("complementary", name="Lists").get_by_role("button", name=re.compile("Lane "))
    expect(rows).to_have_count(len(expected["changes"]), timeout=30_000)
    told = [(named(int(key), expected), tuple(words)) for key, words in draw.told_changes()]
    assert dict(told) == {key: tuple(value) for key, value in changes.items()}
    assert len([key for key, _ in told if key == "new"]) == len(inserted)

    draw.work.tab("Issues").click()
    violations = [(one["code"], {named(key, expected) for key in one["elements"]}) for one in expected["violations"]]
    issues = annotator.get_by_role("article")
    expect(issues).to_have_count(len(violations), timeout=30_000)
    told_violations = [(code, {named(key, expected) for key in lanes}) for code, lanes in draw.told_issues()]
    assert sorted(told_violations, key=repr) == sorted(violations, key=repr)

    stopped = annotator.get_by_role("button", name=re.compile("stops? the save"))
    if violations:
        expect(stopped).to_be_visible()
        return
    expect(stopped).to_have_count(0)
    draw.work.save(1)
    stored = {named(one["id"], expected): one["categories"] for one in draw.stored_changes()}
    assert stored == changes


def named(key: int, expected: dict[str, Any]) -> int | str:
    """An id of the base; whatever is inserted has another id in each map."""
    return key if str(key) in expected["base"]["lane_segments"] else "new"
