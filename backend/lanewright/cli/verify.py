"""``lanewright verify``."""

from __future__ import annotations

from typing import Annotated

import typer

from lanewright.cli.connection import database
from lanewright.db.engine import transaction
from lanewright.services.verify import subjects, verify

EXIT_DIFFERENT = 1

app = typer.Typer()


@app.command("verify")
def verify_command(
    task: Annotated[int | None, typer.Option(help="Only this task; default: every log and task.", min=1)] = None,
) -> None:
    """Recompute content hashes, atomic changes and structural updates of every revision, and say where they differ."""
    differences = revisions = 0
    with database() as url, transaction(url) as session:
        for subject in subjects(session, task):
            for difference in verify(session, subject):
                differences += 1
                typer.echo(str(difference))
            revisions += subject.line.head + 1
    if differences:
        typer.echo(f"{differences} differences in {revisions} revisions.")
        raise typer.Exit(EXIT_DIFFERENT)
    typer.echo(f"{revisions} revisions verified: nothing differs.")
