"""``lanewright import``."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

import typer
from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, SpinnerColumn, TaskID, TextColumn, TimeElapsedColumn
from rich.table import Table

from lanewright.cli.connection import database
from lanewright.cli.failure import kept_trace
from lanewright.core.changes import Direction
from lanewright.core.errors import LanewrightError
from lanewright.db.engine import transaction
from lanewright.formats.splits import SourceSplits, Split, read_splits
from lanewright.services.importing import Placing, find_logs, import_log

EXIT_SOME_FAILED = 1
FAILED = "failed"

app = typer.Typer()


@dataclass(frozen=True, slots=True)
class Line:
    """One line of the final report."""

    log: str
    outcome: str
    detail: str


@app.command("import")
def import_command(
    paths: Annotated[list[Path], typer.Argument(metavar="PATH…", help="Folders of logs, or of one log each.")],
    splits: Annotated[
        Path | None, typer.Option(help="splits.json: which source split each log comes from (train, val, test).")
    ] = None,
    split: Annotated[Split | None, typer.Option(help="Release split that the logs go to.")] = None,
    direction: Annotated[Direction | None, typer.Option(help="Which way the logs are edited.")] = None,
    source_split: Annotated[
        Split | None, typer.Option(help="Source split of logs that the splits file does not list.")
    ] = None,
) -> None:
    """Import Argoverse 2 Sensor and TbV logs; a log that is there already is left as it is.

    A log that fails does not stop the rest; the report at the end names each with the reason, and the exit code is 1.
    """
    known = read_splits(splits) if splits is not None else SourceSplits()
    placing = Placing(known, source=source_split, release=split, direction=direction)
    lines: list[Line] = []
    folders = list(_folders(paths, lines))
    with database() as url, _progress_bar(len(folders)) as (bar, whole):
        for folder in folders:
            lines.append(_import(url, folder, placing, bar))
            bar.advance(whole)
    _report(lines)
    if any(line.outcome == FAILED for line in lines):
        raise typer.Exit(EXIT_SOME_FAILED)


def _folders(paths: list[Path], lines: list[Line]) -> Iterator[Path]:
    for path in paths:
        try:
            yield from find_logs(path)
        except (LanewrightError, OSError) as error:
            lines.append(Line(str(path), FAILED, _reason(error)))


def _import(url: str, folder: Path, placing: Placing, bar: Progress) -> Line:
    part = bar.add_task(folder.name, total=None)

    def show(what: str, done: int, total: int) -> None:
        bar.update(part, description=f"{folder.name}  {what}", completed=done, total=total)

    try:
        with transaction(url) as session:
            imported = import_log(session, folder, placing, progress=show)
        detail = f"{imported.lanes} lane segments, {imported.crossings} crossings"
        return Line(folder.name, imported.outcome.value, detail)
    except Exception as error:  # whatever is wrong with one log, the others still get their turn
        return Line(folder.name, FAILED, _reason(error))
    finally:
        bar.remove_task(part)


def _reason(error: Exception) -> str:
    if isinstance(error, LanewrightError):
        return str(error)
    summary = (str(error).strip().splitlines() or ["no message"])[0]
    return f"Something unexpected went wrong ({type(error).__name__}: {summary}). {kept_trace(error)}"


@contextmanager
def _progress_bar(total: int) -> Iterator[tuple[Progress, TaskID]]:
    columns = (
        SpinnerColumn(),
        TextColumn("{task.description}", markup=False),
        BarColumn(),
        MofNCompleteColumn(),
        TimeElapsedColumn(),
    )
    with Progress(*columns, console=Console(stderr=True), transient=True) as bar:
        yield bar, bar.add_task("logs", total=total)


def _report(lines: list[Line]) -> None:
    if not sys.stdout.isatty():
        for line in lines:
            typer.echo(f"{line.log}: {line.outcome}. {line.detail}")
    else:
        table = Table("log", "outcome", "")
        for line in lines:
            table.add_row(line.log, line.outcome, line.detail, style="red" if line.outcome == FAILED else None)
        Console(markup=False).print(table)
    counts = {outcome: sum(line.outcome == outcome for line in lines) for outcome in ("imported", "unchanged", FAILED)}
    typer.echo(", ".join(f"{count} {outcome}" for outcome, count in counts.items()) + ".")
