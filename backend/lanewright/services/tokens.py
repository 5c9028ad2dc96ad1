"""API tokens: credentials of pipelines, limited to scopes, shown once."""

from __future__ import annotations

import datetime
from collections.abc import Iterable, Sequence
from enum import StrEnum

from sqlalchemy.orm import Session

from lanewright.core.errors import Forbidden, InvalidInput, NotFound, Place, Unauthenticated
from lanewright.db.models import ApiToken
from lanewright.db.repositories import accounts
from lanewright.services.actor import Actor
from lanewright.services.passwords import digest, new_secret

PREFIX = "lanewright_"
"""Every token begins with it, so that scanners for leaked secrets can know one."""
_TOUCH_EVERY = datetime.timedelta(minutes=1)


class Scope(StrEnum):
    """What a token may be used for."""

    EXPORT_READ = "export:read"
    CHANGES_READ = "changes:read"


def create(session: Session, actor: Actor, *, name: str, scopes: Iterable[str], days: int) -> tuple[ApiToken, str]:
    """A new token and the secret itself, which nobody can read again.

    Raises:
        InvalidInput: an unknown scope.
        Forbidden: the actor's role could not use any of the scopes.
    """
    known = {scope.value for scope in Scope}
    wanted = sorted(set(scopes))
    for position, scope in enumerate(wanted):
        if scope not in known:
            raise InvalidInput(
                f"is {scope[:80]!r}", f"Known scopes: {', '.join(sorted(known))}.", Place(key=f"scopes[{position}]")
            )
    if not actor.reviews:
        raise Forbidden(
            "Tokens read the whole dataset, which annotators may not.", mend="Ask an admin.", code="token.role"
        )
    secret = PREFIX + new_secret()
    now = datetime.datetime.now(datetime.UTC)
    token = ApiToken(
        account_id=actor.id,
        name=name,
        token_sha256=digest(secret),
        scopes=wanted,
        created_at=now,
        expires_at=now + datetime.timedelta(days=days),
    )
    session.add(token)
    session.flush()
    return token, secret


def of_actor(session: Session, actor: Actor) -> Sequence[ApiToken]:
    """The actor's own tokens, revoked and expired ones too."""
    return accounts.tokens_of(session, actor.id)


def revoke(session: Session, actor: Actor, token_id: int) -> None:
    """Ends one of the actor's own tokens; again is no error.

    Raises:
        NotFound: no such token, or another's.
    """
    token = session.get(ApiToken, token_id)
    if token is None or token.account_id != actor.id:
        raise NotFound(f"You have no token {token_id}.", mend="Reload the list.", code="token.not_found")
    if token.revoked_at is None:
        token.revoked_at = datetime.datetime.now(datetime.UTC)
        session.flush()


def use(session: Session, secret: str) -> ApiToken:
    """The token that a request carries.

    Raises:
        Unauthenticated: unknown, revoked, expired, or of a disabled account.
    """
    now = datetime.datetime.now(datetime.UTC)
    token = accounts.token_by_digest(session, digest(secret))
    if token is None or token.revoked_at is not None or token.expires_at <= now or token.account.disabled_at:
        raise Unauthenticated(
            "The token is unknown, expired or revoked.", mend="Create a new one in Lanewright.", code="token.refused"
        )
    if token.last_used_at is None or now - token.last_used_at > _TOUCH_EVERY:
        token.last_used_at = now
        session.flush()
    return token
