"""``lanewright demo``."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from lanewright.core.errors import InvalidInput, Place
from lanewright.demo import generate

app = typer.Typer()


@app.command()
def demo(
    folder: Annotated[Path, typer.Argument(metavar="OUT_DIR", help="Folder to write the logs into.")],
    seed: Annotated[int, typer.Option(min=0, help="The same seed gives the same bytes.")] = 7,
    logs: Annotated[int, typer.Option(min=1, max=30, help="How many logs; three places take turns.")] = 3,
) -> None:
    """Generate demo logs in the TbV directory layout, and beside each the map of the other state of its world."""
    try:
        written = generate(seed, folder, logs)
    except OSError as error:
        problem = f"cannot be written ({error.strerror or error})"
        raise InvalidInput(problem, "Name a folder that you may write to.", Place(file=str(folder))) from None
    for log in written:
        typer.echo(f"{log.log_id}  {log.city}  {log.split}  {log.direction.value}  {len(log.base.lanes)} lanes")
    typer.echo(f"{len(written)} demo logs are in {folder}; demo.json lists them.")
