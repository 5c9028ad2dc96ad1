"""Browser sessions: signing in and out, and who a cookie belongs to."""

from __future__ import annotations

import datetime
from dataclasses import dataclass

from sqlalchemy.orm import Session

from lanewright.core.errors import InvalidInput, LanewrightError, Place, Throttled, Unauthenticated
from lanewright.core.workflow import Role
from lanewright.db.models import Account, AccountSession
from lanewright.db.repositories import accounts
from lanewright.services import throttle
from lanewright.services.actor import Actor
from lanewright.services.demo_accounts import is_demo_sign_in
from lanewright.services.passwords import digest, hash_password, new_secret, password_holds

_TOUCH_EVERY = datetime.timedelta(minutes=1)


@dataclass(frozen=True, slots=True)
class SessionRules:
    """How long a sign-in lasts, and whether the demo's well-known passwords are good here."""

    idle: datetime.timedelta
    absolute: datetime.timedelta
    demo_allowed: bool


@dataclass(frozen=True, slots=True)
class SignedIn:
    """A session that has begun; ``token`` goes into the cookie and is stored nowhere."""

    token: str
    session: AccountSession


def sign_in(
    session: Session, name: str, password: str, *, address: str, previous_token: str | None, rules: SessionRules
) -> SignedIn | LanewrightError:
    """Begins a session under a fresh token and ends the one that the browser had.

    A refusal is returned, not raised: the failed attempt must be committed to be counted. Unknown name, wrong
    password, disabled account and demo password out of place get one message after the same work.
    """
    name = name.strip().lower()
    account = accounts.by_name(session, name)
    closed = account is None or account.disabled_at is not None
    closed = closed or (not rules.demo_allowed and is_demo_sign_in(name, password))
    stored = account.password_hash if account else None
    verdict = throttle.judged(session, name, address, lambda: password_holds(password, stored) and not closed)
    if isinstance(verdict, Throttled):
        return verdict
    if account is None or not verdict:
        return Unauthenticated(
            "Name or password is not right.",
            mend="Try again, or ask an admin for a new password.",
            code="session.refused",
        )
    if previous_token is not None:
        accounts.end_session(session, digest(previous_token))
    accounts.end_stale_sessions(session, _now(), rules.idle)
    return begin(session, account, rules)


def begin(session: Session, account: Account, rules: SessionRules) -> SignedIn:
    """A session of an account whose identity is proven."""
    now = _now()
    token = new_secret()
    begun = AccountSession(
        token_sha256=digest(token),
        account=account,
        csrf_token=new_secret(),
        created_at=now,
        last_seen_at=now,
        expires_at=now + rules.absolute,
    )
    session.add(begun)
    session.flush()
    return SignedIn(token, begun)


def resume(session: Session, token: str, rules: SessionRules) -> AccountSession:
    """The session that a cookie belongs to.

    Raises:
        Unauthenticated: unknown, ended, too long idle, too old, or of a disabled account.
    """
    now = _now()
    found = accounts.session_by_digest(session, digest(token))
    if found is None or found.account.disabled_at is not None:
        raise _signed_out("You are signed out.", rules)
    if found.expires_at <= now or found.last_seen_at + rules.idle <= now:
        raise _signed_out("Your sign-in has expired.", rules)
    if now - found.last_seen_at > _TOUCH_EVERY:
        accounts.touch_session(session, found.token_sha256, now)
    return found


def end(session: Session, ended: AccountSession) -> None:
    """Signs this browser out."""
    accounts.end_session(session, ended.token_sha256)


def change_password(
    session: Session, actor: Actor, *, current: str, new: str, address: str, keep: AccountSession
) -> LanewrightError | None:
    """Sets the actor's own password and ends their other sessions.

    Args:
        keep: the session that stays.

    Returns:
        The refusal, as in ``sign_in``; None when it is done.
    """
    account = keep.account
    verdict = throttle.judged(
        session, actor.name.lower(), address, lambda: password_holds(current, account.password_hash)
    )
    if isinstance(verdict, Throttled):
        return verdict
    if not verdict:
        return InvalidInput("is not your current password", "Type the one you signed in with.", Place(key="current"))
    account.password_hash = hash_password(new)
    accounts.end_sessions(session, actor.id, but=keep.token_sha256)
    return None


def actor_of(account: Account) -> Actor:
    return Actor(id=account.id, name=account.name, role=Role(account.role))


def _signed_out(message: str, rules: SessionRules) -> Unauthenticated:
    return Unauthenticated(
        message, mend="Sign in; nothing of your draft is lost.", code="session.none", demo=rules.demo_allowed
    )


def _now() -> datetime.datetime:
    return datetime.datetime.now(datetime.UTC)
