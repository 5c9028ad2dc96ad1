"""Where log lines go: for people to the console and a file, for collectors as JSON lines to standard error."""

from __future__ import annotations

import logging
import logging.handlers
import sys
from pathlib import Path
from typing import Any

import structlog

from lanewright.settings import Settings

FILE_LIMIT_BYTES = 10 * 1024 * 1024
OLD_FILES = 3


def log_file(settings: Settings, process: str) -> Path:
    """The log of ``serve`` or ``worker``, when logs are for people."""
    return settings.home / "logs" / f"{process}.log"


def configure_logging(settings: Settings, process: str) -> None:
    """Sets up structlog and the standard library's logging alike; call once per process.

    ``log_format`` "console": warnings to the console and everything, as JSON lines, to ``log_file``. "json":
    everything to standard error, one JSON object a line.
    """
    shared: list[Any] = [
        structlog.contextvars.merge_contextvars,
        structlog.stdlib.add_logger_name,
        structlog.stdlib.add_log_level,
        structlog.processors.TimeStamper(fmt="iso", utc=True),
    ]
    structlog.configure(
        processors=[*shared, structlog.stdlib.ProcessorFormatter.wrap_for_formatter],
        logger_factory=structlog.stdlib.LoggerFactory(),
        wrapper_class=structlog.stdlib.BoundLogger,
        cache_logger_on_first_use=True,
    )
    as_json = structlog.stdlib.ProcessorFormatter(
        foreign_pre_chain=shared,
        processors=[
            structlog.stdlib.ProcessorFormatter.remove_processors_meta,
            structlog.processors.format_exc_info,
            structlog.processors.JSONRenderer(),
        ],
    )
    handlers: list[logging.Handler] = [logging.StreamHandler(sys.stderr)]
    handlers[0].setFormatter(as_json)
    if settings.log_format == "console":
        handlers[0].setFormatter(
            structlog.stdlib.ProcessorFormatter(
                foreign_pre_chain=shared,
                processors=[
                    structlog.stdlib.ProcessorFormatter.remove_processors_meta,
                    # Not the default, Rich's: it prints local variables (secrets), and takes half a minute at times.
                    structlog.dev.ConsoleRenderer(
                        colors=sys.stderr.isatty(), exception_formatter=structlog.dev.plain_traceback
                    ),
                ],
            )
        )
        handlers[0].setLevel(logging.WARNING)
        file = log_file(settings, process)
        file.parent.mkdir(parents=True, exist_ok=True)
        rotating = logging.handlers.RotatingFileHandler(file, maxBytes=FILE_LIMIT_BYTES, backupCount=OLD_FILES)
        rotating.setFormatter(as_json)
        handlers.append(rotating)
    logging.basicConfig(handlers=handlers, level=logging.INFO, force=True)
    logging.getLogger("alembic").setLevel(logging.WARNING)
