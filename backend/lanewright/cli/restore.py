"""``lanewright restore``."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from lanewright.cli.connection import database
from lanewright.services.backup import restore as read_backup

app = typer.Typer()


@app.command()
def restore(
    file: Annotated[Path, typer.Argument(metavar="FILE", help="A file that lanewright backup wrote.")],
    force: Annotated[bool, typer.Option("--force", help="Replace what the database holds now.")] = False,
) -> None:
    """Bring back what backup wrote, all or nothing; stop the server first."""
    with database(migrated=False) as url:
        read_backup(url, file, force=force)
    typer.echo(f"The database holds what {file} holds. lanewright verify checks it.")
