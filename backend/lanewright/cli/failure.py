"""What a person at the command line sees when something fails: one sentence, never a stack trace."""

from __future__ import annotations

import datetime
import os
import sys
import traceback
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import typer

from lanewright.core.errors import LanewrightError

EXIT_FAILURE = 2


@contextmanager
def failures_as_sentences() -> Iterator[None]:
    """Turns a failure into one sentence on standard error and exit code 2.

    Lanewright's own errors say what to do; of any other the trace goes to a log file, and the sentence names it.
    """
    try:
        yield
    except LanewrightError as error:
        _fail(str(error))
    except BrokenPipeError:  # `lanewright … | head`: nobody reads any more
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        raise typer.Exit(EXIT_FAILURE) from None
    except Exception as error:
        if type(error).__module__.startswith("typer."):  # usage errors and Exit: Typer words them itself
            raise
        summary = (str(error).strip().splitlines() or ["no message"])[0]
        _fail(f"Something unexpected went wrong ({type(error).__name__}: {summary}). {kept_trace(error)}")


def _fail(sentence: str) -> None:
    typer.echo(f"lanewright: {sentence}", err=True)
    raise typer.Exit(EXIT_FAILURE) from None


def kept_trace(error: Exception) -> str:
    """Appends the trace to the error log, and says where that is."""
    trace = "".join(traceback.format_exception(error))
    try:
        log = _error_log()
        with log.open("a") as file:
            file.write(
                f"{datetime.datetime.now(datetime.UTC).isoformat()} lanewright {' '.join(sys.argv[1:])}\n{trace}\n"
            )
    except (OSError, LanewrightError):
        return "Its trace could not be written to a log: LANEWRIGHT_HOME is not writable."
    return f"The trace is in {log}."


def _error_log() -> Path:
    from lanewright.settings import get_settings

    folder = get_settings().home / "logs"
    folder.mkdir(parents=True, exist_ok=True)
    return folder / "errors.log"
