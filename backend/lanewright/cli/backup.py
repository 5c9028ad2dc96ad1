"""``lanewright backup``."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from lanewright.cli.connection import database
from lanewright.services.backup import backup as write_backup

app = typer.Typer()


@app.command()
def backup(
    file: Annotated[Path, typer.Argument(metavar="FILE", help="The file to write; an existing one is replaced.")],
) -> None:
    """Write everything that is stored into one file. Others may go on working meanwhile."""
    with database() as url:
        size = write_backup(url, file)
    typer.echo(f"{file} holds everything, {size / 2**20:.1f} MiB. Bring it back with: lanewright restore {file}")
