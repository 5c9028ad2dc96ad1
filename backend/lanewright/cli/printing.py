"""What the commands print: JSON for pipelines, or text that wraps in a terminal and has one line a fact in a pipe."""

from __future__ import annotations

import io
import json
import sys
from collections.abc import Iterable
from typing import Any


def print_json(document: Any) -> None:
    """One line of JSON; the same document gives the same bytes."""
    sys.stdout.write(json.dumps(document, allow_nan=False) + "\n")


def print_lines(lines: Iterable[tuple[str, str]]) -> None:
    """Lines of text, each with its rich style (empty: plain). Colours and wrapping only in a terminal."""
    from rich.console import Console
    from rich.padding import Padding
    from rich.text import Text

    if isinstance(sys.stdout, io.TextIOWrapper):
        sys.stdout.reconfigure(errors="replace")  # a terminal that has no arrows prints ? for them
    console = Console(highlight=False)
    for line, style in lines:
        content = line.lstrip(" ")
        if console.is_terminal:
            console.print(Padding(Text(content, style), (0, 0, 0, len(line) - len(content))))
        else:
            console.print(Text(line), soft_wrap=True)
