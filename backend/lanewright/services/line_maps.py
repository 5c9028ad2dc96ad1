"""The map of a line at a revision, with the part that never changes kept in memory."""

from __future__ import annotations

from sqlalchemy.orm import Session

from lanewright.core.errors import NotFound
from lanewright.db.repositories import elements, revisions
from lanewright.db.repositories.elements import Departure, StoredMap
from lanewright.services.recently_used import RecentlyUsed

BASE_MAPS: RecentlyUsed[StoredMap] = RecentlyUsed(most=64)
"""By content hash; some 2 MB each for the largest real maps."""


def base_map(session: Session, line_id: int) -> StoredMap:
    """The map of a line at revision 0, as imported."""
    return base_map_with_hash(session, line_id)[1]


def base_map_with_hash(session: Session, line_id: int) -> tuple[bytes, StoredMap]:
    """The same, with its content hash."""
    sha256 = revisions.content_sha256(session, line_id, 0)
    if sha256 is None:
        raise NotFound("This task has no base map.", mend="Import its log again.", code="revision.not_found")
    known = BASE_MAPS.get(sha256)
    if known is None:
        known = elements.load(session, line_id, 0)
        BASE_MAPS.put(sha256, known)
    return sha256, known


def departure(session: Session, line_id: int, revision: int, head: int) -> Departure:
    """How a revision departs from revision 0.

    Raises:
        NotFound: the line has no such revision.
    """
    if not 0 <= revision <= head:
        raise NotFound(
            f"There is no revision {revision}: the newest is {head}.",
            mend="Name one of the revisions in the history.",
            code="revision.not_found",
            provided=revision,
            latest=head,
        )
    return elements.load_departure(session, line_id, revision)


def map_at(session: Session, line_id: int, revision: int, head: int) -> StoredMap:
    """The whole map at a revision. Raises NotFound when the line has no such revision."""
    return departure(session, line_id, revision, head).applied_to(base_map(session, line_id))
