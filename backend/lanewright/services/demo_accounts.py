"""The demo's sign-ins: known to everybody, so they work only where nobody else can reach the server."""

from __future__ import annotations

from sqlalchemy.orm import Session

from lanewright.core.workflow import Role
from lanewright.db.models import Account
from lanewright.db.repositories import accounts
from lanewright.services.passwords import hash_password

DEMO_PASSWORD = "lanewright-demo"  # noqa: S105 (no secret: it is refused where others reach the server)
"""Of all demo accounts, which are named by their roles."""


def is_demo_sign_in(name: str, password: str) -> bool:
    """Whether these are credentials that everybody knows."""
    return password == DEMO_PASSWORD and name.strip().lower() in {role.value for role in Role}


def ensure_demo_accounts(session: Session) -> dict[Role, Account]:
    """The demo's people by role, made where they are missing; one who exists stays as they are."""
    people: dict[Role, Account] = {}
    for role in Role:
        account = accounts.by_name(session, role.value)
        if account is None:
            account = Account(name=role.value, role=role.value, password_hash=hash_password(DEMO_PASSWORD))
            session.add(account)
        people[role] = account
    session.flush()
    return people
