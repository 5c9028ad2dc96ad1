"""``lanewright export``: the dataset as a file."""

from __future__ import annotations

import os
from functools import partial
from pathlib import Path
from typing import Annotated

import typer

from lanewright.cli.connection import database
from lanewright.core.errors import InvalidInput, Place
from lanewright.db.engine import snapshot
from lanewright.formats.splits import Split
from lanewright.services.export import archive

app = typer.Typer()


@app.command()
def export(
    split: Annotated[Split, typer.Argument(help="Which split of the release.")],
    file: Annotated[Path, typer.Argument(metavar="FILE.tar", help="The archive to write.")],
) -> None:
    """Write the accepted revisions of a split as a tar archive (docs: /docs, export_split)."""
    partial_file = file.with_name(f"{file.name}.partial")
    try:
        with database() as url, partial_file.open("wb") as out:
            for piece in archive(partial(snapshot, url), split):
                out.write(piece)
            out.flush()
            os.fsync(out.fileno())
        partial_file.rename(file)
    except OSError as error:
        problem = f"cannot be written ({error.strerror})"
        raise InvalidInput(problem, "Name a file in a folder of yours.", Place(file=str(file))) from None
    finally:
        partial_file.unlink(missing_ok=True)
    typer.echo(f"{split.value} is in {file}.")
