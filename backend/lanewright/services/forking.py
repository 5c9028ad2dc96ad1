"""Lines of revisions: a log's base line, and the line that every task forks from it."""

from __future__ import annotations

from collections.abc import Iterable

from sqlalchemy.orm import Session

from lanewright.core.elements import Element
from lanewright.core.errors import NotFound
from lanewright.db.mapping import map_sha256, to_rows
from lanewright.db.models import Line, Log
from lanewright.db.repositories import elements, revisions
from lanewright.sensors.city import city_frame


def write_base(session: Session, line: Line, city: str, base: Iterable[Element]) -> None:
    """Revision 0 of a new line: the elements as imported."""
    ordered = sorted(base, key=lambda element: element.key)
    rows = to_rows(ordered, city_frame(city).to_mercator)
    hashes = [(element.key, row.sha256) for element, row in zip(ordered, rows, strict=True)]
    revisions.insert_revision(session, line_id=line.id, number=0, content_sha256=map_sha256(hashes), updates=[])
    elements.insert_versions(session, line.id, 0, rows)


def fork(session: Session, log: Log) -> Line:
    """A new line whose revision 0 is the log's base map; nothing passes through Python."""
    sha256 = revisions.content_sha256(session, log.line_id, 0)
    if sha256 is None:
        raise NotFound(f"Log {log.log_id} has no base map.", mend="Import it again.", code="log.incomplete")
    line = revisions.new_line(session, log.id)
    revisions.insert_revision(session, line_id=line.id, number=0, content_sha256=sha256, updates=[])
    elements.copy_live(session, log.line_id, line.id)
    return line
