"""The real server with its private cluster, as the command line starts it."""

from __future__ import annotations

from tests.cli.conftest import command

__all__ = ["command"]
