"""``lanewright canonicalise``: the edited map under the ids that tell its update in the simplest way."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from lanewright.cli.two_maps import BaseFile, EditedFile, read_two_maps
from lanewright.core.elements import ElementKind
from lanewright.core.errors import InvalidInput, Place

if TYPE_CHECKING:
    from lanewright.core.canonical import Canonical

app = typer.Typer()


@app.command()
def canonicalise(
    base: BaseFile,
    out: Annotated[Path, typer.Option("-o", "--out", metavar="OUT.json", help="The map file to write.")],
    edited: EditedFile = None,
) -> None:
    """Write the edited map with canonical ids: what stayed in its place keeps the base's id, what is new has a new one.

    Elements that the canonical form does not touch are written as in the edited file, digit for digit. Needs no server
    and no database. Exit code: 0, or 2 if a map cannot be read or the file not be written.
    """
    maps = read_two_maps(base, edited)

    from lanewright.core.canonical import canonical_map
    from lanewright.core.comparison import Comparison

    canonical = canonical_map(Comparison(maps.base.state, maps.edited.state))
    _write(out, maps.edited.render(canonical.edited))
    if canonical.edited == maps.edited.state:
        typer.echo(f"{out}: canonical already, written as it was.")
    else:
        typer.echo("\n".join([f"{out}:", *_told(canonical)]))


def _told(canonical: Canonical) -> Iterator[str]:
    """What became of which element, a line each."""
    for (kind, before), after in sorted(canonical.renamed.items()):
        noun = "lane" if kind is ElementKind.LANE_SEGMENT else "crossing"
        yield f"  {noun} {before} becomes {noun} {after}"
    for lane in canonical.joined:
        yield f"  lane {lane} is joined to the lane before or after it"
    for lane in canonical.cut:
        yield f"  lane {lane} is cut"


def _write(path: Path, data: bytes) -> None:
    """The file as a whole or not at all; what is no regular file (a pipe, /dev/stdout) is written to."""
    try:
        if path.exists() and not path.is_file():
            path.write_bytes(data)
            return
        target = path.resolve()
        partial = target.with_name(f"{target.name}.partial")
        try:
            partial.write_bytes(data)
            partial.replace(target)
        finally:
            partial.unlink(missing_ok=True)
    except OSError as error:
        problem = f"cannot be written ({error.strerror or error})"
        raise InvalidInput(problem, "Name a file in a folder of yours.", Place(file=str(path))) from None
