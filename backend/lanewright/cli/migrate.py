"""``lanewright migrate``."""

from __future__ import annotations

import typer

from lanewright.cli.connection import database

app = typer.Typer()


@app.command()
def migrate() -> None:
    """Bring the database to the tables of this version."""
    with database(migrated=True):
        typer.echo("The database has the tables of this version.")
