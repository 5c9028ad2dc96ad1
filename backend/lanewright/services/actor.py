"""Actor: the signed-in person, as services see them."""

from __future__ import annotations

from dataclasses import dataclass

from lanewright.core.workflow import Role

REVIEWING_ROLES = frozenset({Role.REVIEWER, Role.ADMIN})


@dataclass(frozen=True, slots=True)
class Actor:
    """Who asks. Services take it beside the session; it always comes from the server's own records."""

    id: int
    name: str
    role: Role

    @property
    def reviews(self) -> bool:
        """Whether they see all tasks and logs, not only tasks assigned to them."""
        return self.role in REVIEWING_ROLES
