"""People: admins add, change, disable and enable them."""

from __future__ import annotations

import datetime
import re
from collections.abc import Sequence

from sqlalchemy.exc import IntegrityError
from sqlalchemy.orm import Session

from lanewright.core.errors import Conflict, InvalidInput, NotFound, Place
from lanewright.core.workflow import Role
from lanewright.db.models import Account
from lanewright.db.repositories import accounts
from lanewright.services.actor import Actor
from lanewright.services.passwords import hash_password

SHORTEST_PASSWORD = 10
_NAME = re.compile(r"[\w.@+-]{1,64}")


def everybody(session: Session) -> Sequence[Account]:
    """All accounts by name, disabled ones too."""
    return accounts.all_accounts(session)


def add(session: Session, *, name: str, role: Role, password: str) -> Account:
    """A new account.

    Raises:
        InvalidInput: a name with other than letters, digits and ``. @ + - _``, or a password that is too short.
        Conflict: somebody has that name, in whatever case (``account.exists``).
    """
    if not _NAME.fullmatch(name):
        raise InvalidInput(
            f"is {name[:80]!r}", "Use up to 64 letters, digits and the signs . @ + - _ only.", Place(key="name")
        )
    _require_length(password)
    account = Account(name=name, role=role.value, password_hash=hash_password(password))
    try:
        with session.begin_nested():
            session.add(account)
    except IntegrityError:
        raise Conflict(
            f"An account named {name!r} exists.", mend="Choose another name.", code="account.exists", name=name
        ) from None
    return account


def by_name(session: Session, name: str) -> Account:
    """Raises NotFound unless somebody has that name, in whatever case."""
    account = accounts.by_name(session, name)
    if account is None:
        raise NotFound(
            f"There is no account named {name[:80]!r}.", mend="See lanewright user list.", code="account.not_found"
        )
    return account


def change(
    session: Session,
    actor: Actor | None,
    account_id: int,
    *,
    role: Role | None = None,
    disabled: bool | None = None,
    password: str | None = None,
) -> Account:
    """Changes what is given. A new role or password ends the sessions; disabling ends sessions and tokens, at once.

    ``actor`` is None on the command line, where whoever holds the database may do anything.

    Raises:
        NotFound: no such account.
        Conflict: an admin would disable or demote themself (``account.own``).
    """
    account = accounts.by_id(session, account_id, lock=True)
    if account is None:
        raise NotFound(f"There is no account {account_id}.", mend="Reload the list.", code="account.not_found")
    if actor is not None and actor.id == account.id and (disabled or (role is not None and role is not actor.role)):
        raise Conflict("You cannot disable or demote yourself.", mend="Ask another admin to do it.", code="account.own")
    if role is not None and role.value != account.role:
        account.role = role.value
        accounts.end_sessions(session, account.id)
    if password is not None:
        _require_length(password)
        account.password_hash = hash_password(password)
        accounts.end_sessions(session, account.id)
        accounts.forget_failures(session, name=account.name.lower())
    if disabled is True and account.disabled_at is None:
        now = datetime.datetime.now(datetime.UTC)
        account.disabled_at = now
        accounts.end_sessions(session, account.id)
        accounts.revoke_tokens(session, account.id, now)
    elif disabled is False:
        account.disabled_at = None
    session.flush()
    return account


def _require_length(password: str) -> None:
    if len(password) < SHORTEST_PASSWORD:
        raise InvalidInput(
            f"has {len(password)} characters", f"Take at least {SHORTEST_PASSWORD}.", Place(key="password")
        )
