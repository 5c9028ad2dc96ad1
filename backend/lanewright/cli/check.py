"""``lanewright check``: whether one map is a legal update of another."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from lanewright.cli.printing import print_json, print_lines
from lanewright.cli.two_maps import AsJson, BaseFile, EditedFile, read_two_maps, title_of

if TYPE_CHECKING:
    from lanewright.core.violations import Violation

app = typer.Typer()
EXIT_VIOLATIONS = 1


@app.command()
def check(
    base: BaseFile,
    edited: EditedFile = None,
    annotation: Annotated[
        Path | None,
        typer.Option(
            metavar="CHANGES.json",
            help="Changes and macros annotated elsewhere, told from the first map to the second as diff --json does; "
            "they are checked along with the maps.",
        ),
    ] = None,
    as_json: AsJson = False,
) -> None:
    """Check the edited map against the rules of change mapping, with a mend for every violation.

    Defects that the base has already are shown as inherited and never count. Needs no server and no database.
    Exit code: 0 without violations of severity error, 1 with any, 2 if a file cannot be read.
    """
    maps = read_two_maps(base, edited)

    from lanewright.core.claims import NO_CLAIMS
    from lanewright.core.report import check_document
    from lanewright.core.rules import check as check_maps
    from lanewright.formats.annotation import read_annotation

    claims = NO_CLAIMS if annotation is None else read_annotation(annotation, maps)
    violations = check_maps(maps.base.state, maps.edited.state, claims)
    if as_json:
        print_json(check_document(violations))
    else:
        title = title_of(base, edited)
        print_lines(_told(violations, title if annotation is None else f"{title}, annotated in {annotation}"))
    if any(violation.blocks for violation in violations):
        raise typer.Exit(EXIT_VIOLATIONS)


def _told(violations: Sequence[Violation], title: str) -> Iterator[tuple[str, str]]:
    """The violations as sentences with their mends: first what blocks, then notes, then what the base has already."""
    if not violations:
        yield f"{title}: no violations.", "bold green"
        return
    blocking = [violation for violation in violations if violation.blocks]
    inherited = [violation for violation in violations if violation.inherited]
    notes = [violation for violation in violations if not violation.blocks and not violation.inherited]
    counts = [
        f"{len(group)} {word if len(group) == 1 else words}"
        for group, word, words in (
            (blocking, "violation", "violations"),
            (notes, "note", "notes"),
            (inherited, "inherited from the base", "inherited from the base"),
        )
        if group
    ]
    yield f"{title}: {', '.join(counts)}.", "bold"
    for group, style, mark in ((blocking, "red", ""), (notes, "yellow", ", note"), (inherited, "dim", ", inherited")):
        for violation in group:
            yield "", ""
            yield f"{violation.code}{mark}", style
            yield f"  {violation.message}", ""
            yield f"  mend: {_mend(violation)}", "green" if violation.blocks else "dim"


def _mend(violation: Violation) -> str:
    """The title of the first fix, else what the rule says."""
    from lanewright.core.rules import RULES

    if violation.fixes:
        return f"{violation.fixes[0].title}."
    return next(rule.mend for rule in RULES if rule.code == violation.code)
