"""``lanewright diff``: the one explanation of what differs between two maps."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Annotated

import typer

from lanewright.cli.printing import print_json, print_lines
from lanewright.cli.two_maps import AsJson, BaseFile, EditedFile, read_two_maps, title_of
from lanewright.core.changes import Direction

if TYPE_CHECKING:
    from lanewright.core.changes import MapDiff
    from lanewright.core.elements import MapState

app = typer.Typer()


@app.command()
def diff(
    base: BaseFile,
    edited: EditedFile = None,
    direction: Annotated[
        Direction,
        typer.Option(help="Which of the two is the prior. Changes are told from the prior to the current map."),
    ] = Direction.PRIOR_TO_CURRENT,
    as_json: AsJson = False,
) -> None:
    """Derive the atomic changes between two maps, and the structural updates they form.

    Needs no server and no database. Exit code: 0, or 2 if a map cannot be read.
    """
    maps = read_two_maps(base, edited)

    from lanewright.core.comparison import Comparison
    from lanewright.core.diff import diff_of, invert
    from lanewright.core.report import diff_document

    comparison = Comparison(maps.base.state, maps.edited.state)
    changes = diff_of(comparison)
    before, after = comparison.base, comparison.edited
    if direction is Direction.CURRENT_TO_PRIOR:
        changes, before, after = invert(changes), after, before
    if as_json:
        print_json(diff_document(changes))
        return
    turned = "" if direction is Direction.PRIOR_TO_CURRENT else ", told from the second map to the first"
    print_lines(_told(changes, before, after, f"{title_of(base, edited)}{turned}"))


def _told(changes: MapDiff, before: MapState, after: MapState, title: str) -> Iterator[tuple[str, str]]:
    """The changes as sentences, grouped by structural update with its macros."""
    from lanewright.core.sentences import describe_update, sentence

    if not changes.changes:
        yield f"{title}: no changes.", "bold"
        return
    yield f"{title}: {_counted(changes)}.", "bold"
    by_key = {change.key: change for change in changes.changes}
    for number, update in enumerate(changes.updates, start=1):
        mine = [by_key[key] for key in update.elements]
        heading = describe_update(update, mine, before, after)
        yield "", ""
        yield f"{number}. {heading.headline}", "bold"
        yield f"   macros: {heading.detail or 'none'}", "dim"
        for change in mine:
            yield f"   - {sentence(change, before, after)}", ""


def _counted(changes: MapDiff) -> str:
    changed, updates = len(changes.changes), len(changes.updates)
    elements = "1 element changed" if changed == 1 else f"{changed} elements changed"
    return f"{elements} in {'1 structural update' if updates == 1 else f'{updates} structural updates'}"
