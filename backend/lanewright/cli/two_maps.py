"""The arguments that name two maps, shared by the commands that compare them."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

if TYPE_CHECKING:
    from lanewright.formats.map_pair import MapPair

BaseFile = Annotated[
    Path,
    typer.Argument(metavar="BASE.json", help="AV2 map before; alone: a file that holds both, as {base, edited}."),
]
EditedFile = Annotated[Path | None, typer.Argument(metavar="EDITED.json", help="AV2 map after.")]
AsJson = Annotated[bool, typer.Option("--json", help="Print JSON, the same bytes for the same maps.")]


def read_two_maps(base: Path, edited: Path | None) -> MapPair:
    """The maps that the arguments name. Raises InvalidInput naming file, element, key and mend."""
    from lanewright.formats.map_pair import read_map_pair  # numpy: only when a command runs, so that --help is quick

    return read_map_pair(base, edited)


def title_of(base: Path, edited: Path | None) -> str:
    """The two maps by their paths, e.g. ``old.json → new.json``."""
    return str(base) if edited is None else f"{base} → {edited}"
