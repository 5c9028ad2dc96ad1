"""Writes the documentation page of every rule, with its picture: ``python scripts/rules_pages.py [--check]``.

The words come from the rules themselves, the pictures from the scenarios under tests/fixtures/bijective and the few
sketches below. ``--check`` writes nothing and fails if a page is not what it would be.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Iterable
from pathlib import Path
from xml.sax.saxutils import escape

from lanewright.core.attributes import parse_element
from lanewright.core.diff import diff
from lanewright.core.elements import ElementKind, LaneSegment, LaneType, MapState, Mark, PedestrianCrossing
from lanewright.core.rules import RULES
from lanewright.core.rules.rule import Rule

ROOT = Path(__file__).resolve().parents[1]
PAGES = ROOT / "docs" / "rules"
SCENARIOS = ROOT / "tests" / "fixtures" / "bijective"
COLOURS = {
    "insertion": "#2ecc40",
    "deletion": "#e0352b",
    "geometry": "#1b7a2f",
    "marking": "#8e44ad",
    "type": "#f1c40f",
}
UNCHANGED = "#b8bcc4"
SCALE = 5.0
MARGIN = 24.0

Sketch = tuple[MapState, MapState]


def lane(key: int, left: str, right: str, successors: tuple[int, ...] = ()) -> LaneSegment:
    """A lane of a sketch, from two lines as text."""

    def line(text: str) -> tuple[tuple[float, float, float], ...]:
        return tuple((float(x), float(y), 0.0) for x, y in (point.split(",") for point in text.split()))

    return LaneSegment(key, False, LaneType.VEHICLE, line(left), Mark.NONE, line(right), Mark.NONE, successors)


def sketches() -> dict[str, Sketch]:
    """Pictures for rules without a scenario."""
    one = lane(1, "0,3.5 40,3.5", "0,0 40,0")
    two = lane(2, "40,3.5 70,3.5", "40,0 70,0")
    apart = lane(2, "44,3.5 70,3.5", "44,0 70,0")
    left = lane(2, "0,7 40,7", "0,3.5 40,3.5")
    bent = lane(2, "0,7 40,7", "0,3.5 20,5 40,3.5")
    knot = lane(1, "0,3.5 26,3.5 26,7 14,7 14,2 40,2", "0,0 40,0")
    return {
        "identity.not_canonical": (
            MapState.of([one, lane(2, "0,9 40,9", "0,5.5 40,5.5")]),
            MapState.of([lane(2, "0,3.5 40,3.5", "0,0 40,0"), lane(9, "0,9 40,9", "0,5.5 40,5.5")]),
        ),
        "element.duplicate": (MapState.of([one]), MapState.of([one, lane(9, "0,3.6 40,3.6", "0,0.1 40,0.1")])),
        "change.exclusive": (MapState.of([one]), MapState.of([one, two])),
        "identity.reused": (MapState.of([one]), MapState.of([one, lane(9, "50,13 70,13", "50,9.5 70,9.5")])),
        "macro.mismatch": (MapState.of([one]), MapState.of([lane(1, "0,5 40,5", "0,0 40,0")])),
        "geometry.invalid": (MapState.of([one]), MapState.of([knot])),
        "link.dangling": (MapState.of([one, two]), MapState.of([one])),
        "link.one_sided": (MapState.of([one, two]), MapState.of([one, two])),
        "link.gap": (MapState.of([one, two]), MapState.of([one, apart])),
        "neighbor.inconsistent": (MapState.of([one, left]), MapState.of([one, bent])),
    }


def scenario(name: str) -> Sketch:
    """Base and edited map of a scenario."""
    document = json.loads((SCENARIOS / f"{name}.json").read_text())

    def state(part: str) -> MapState:
        lanes = (parse_element(ElementKind.LANE_SEGMENT, one) for one in document[part]["lane_segments"].values())
        crossings = (
            parse_element(ElementKind.PEDESTRIAN_CROSSING, one)
            for one in document[part]["pedestrian_crossings"].values()
        )
        return MapState.of([*lanes, *crossings])

    return state("base"), state("edited")


def ring(element: LaneSegment | PedestrianCrossing) -> list[tuple[float, float]]:
    """The outline of an element."""
    if isinstance(element, LaneSegment):
        points = [*element.left_boundary, *element.right_boundary[::-1]]
    else:
        points = [*element.edge1, *element.edge2[::-1]]
    return [(x, y) for x, y, _ in points]


def picture(sketch: Sketch) -> str:
    """Base above, edited below, changed elements in the colour of their first category."""
    base, edited = sketch
    colours = {change.key: COLOURS.get(change.categories[0].value, UNCHANGED) for change in diff(base, edited).changes}
    outlines = [ring(element) for state in sketch for element in state]
    xs, ys = zip(*(point for outline in outlines for point in outline), strict=True)
    low_x, high_x, low_y, high_y = min(xs), max(xs), min(ys), max(ys)
    height = (high_y - low_y) * SCALE + 2 * MARGIN
    width = max((high_x - low_x) * SCALE + 2 * MARGIN, 220)
    body: list[str] = []
    for row, (title, state) in enumerate((("base", base), ("edited", edited))):
        top = row * height
        body.append(f'<text x="4" y="{top + 14:.0f}" class="title">{title}</text>')
        for element in state:
            places = [((x - low_x) * SCALE + MARGIN, top + (high_y - y) * SCALE + MARGIN) for x, y in ring(element)]
            points = " ".join(f"{x:.1f},{y:.1f}" for x, y in places)
            colour = colours.get(element.key, UNCHANGED)
            body.append(f'<polygon points="{points}" fill="{colour}" fill-opacity="0.55" stroke="#30343b"/>')
        for element in state:
            places = [((x - low_x) * SCALE + MARGIN, top + (high_y - y) * SCALE + MARGIN) for x, y in ring(element)]
            x, y = (sum(values) / len(places) for values in zip(*places, strict=True))
            body.append(f'<text x="{x:.1f}" y="{y + 4:.1f}" text-anchor="middle">{element.id}</text>')
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:.0f} {2 * height:.0f}" width="{width:.0f}" '
        f'height="{2 * height:.0f}" font-family="sans-serif" font-size="12">\n'
        f'<rect width="100%" height="100%" fill="#ffffff"/>\n' + "\n".join(body) + "\n</svg>\n"
    )


def page(rule: Rule) -> str:
    """The page of a rule."""
    told = f" (scenario `{rule.example}`)" if rule.example else ""
    yields = ""
    if rule.gives_way_to:
        names = ", ".join(f"`{code}*`" if code.endswith(".") else f"`{code}`" for code in rule.gives_way_to)
        yields = f"\n## When it is silent\n\nOn the same elements it gives way to {names}: one defect is told once.\n"
    return (
        f"# `{rule.code}`\n\n<!-- Written by scripts/rules_pages.py from the rule itself. -->\n\n"
        f"## What\n\n{rule.what}\n\n## Why\n\n{rule.why}\n\n"
        f"## Example\n\n![{escape(rule.code)}: base above, edited map below]({rule.code}.svg){told}\n\n"
        f"## How to mend\n\n{rule.mend}\n{yields}"
    )


def index() -> str:
    """The list of all rules."""
    rows = "\n".join(f"| [`{rule.code}`]({rule.code}.md) | {rule.what} |" for rule in RULES)
    return (
        "# Rules of the change mapping\n\n<!-- Written by scripts/rules_pages.py. -->\n\n"
        "Letters in brackets name the desiderata: A1 each change has a unique, interpretable outcome; A2 no redundant\n"
        "categories; B relevant to driving; C coarse and fine levels; D composite changes stay unambiguous.\n\n"
        f"| rule | what must not be |\n| --- | --- |\n{rows}\n"
    )


def pages() -> Iterable[tuple[Path, str]]:
    """All files and what they hold."""
    drawn = sketches()
    yield PAGES / "README.md", index()
    for rule in RULES:
        yield PAGES / f"{rule.code}.md", page(rule)
        yield PAGES / f"{rule.code}.svg", picture(scenario(rule.example) if rule.example else drawn[rule.code])


def main(arguments: list[str]) -> int:
    """Write the pages; with ``--check``, name those that are not up to date."""
    stale = [path for path, text in pages() if not path.exists() or path.read_text() != text]
    if "--check" in arguments:
        for path in stale:
            print(f"{path.relative_to(ROOT)} is not what scripts/rules_pages.py would write; run it and commit.")
        return 1 if stale else 0
    PAGES.mkdir(parents=True, exist_ok=True)
    for path, text in pages():
        path.write_text(text)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
