"""SQL of people, browser sessions, API tokens and failed sign-ins."""

from __future__ import annotations

import datetime
from collections.abc import Sequence

from sqlalchemy import delete, func, select, text, update
from sqlalchemy.orm import Session

from lanewright.db.models import Account, AccountSession, ApiToken, LoginFailure

_SIGN_IN_PATIENCE_S = 10


def by_name(session: Session, name: str) -> Account | None:
    """The account with that name, whatever its case."""
    return session.scalar(select(Account).where(func.lower(Account.name) == name.strip().lower()))


def by_id(session: Session, account_id: int, *, lock: bool = False) -> Account | None:
    query = select(Account).where(Account.id == account_id)
    return session.scalar(query.with_for_update() if lock else query)


def all_accounts(session: Session) -> Sequence[Account]:
    return session.scalars(select(Account).order_by(func.lower(Account.name))).all()


def session_by_digest(session: Session, token_sha256: bytes) -> AccountSession | None:
    return session.scalar(select(AccountSession).where(AccountSession.token_sha256 == token_sha256))


def touch_session(session: Session, token_sha256: bytes, seen_at: datetime.datetime) -> None:
    session.execute(
        update(AccountSession).where(AccountSession.token_sha256 == token_sha256).values(last_seen_at=seen_at)
    )


def end_session(session: Session, token_sha256: bytes) -> None:
    session.execute(delete(AccountSession).where(AccountSession.token_sha256 == token_sha256))


def end_sessions(session: Session, account_id: int, *, but: bytes | None = None) -> None:
    """Signs the account out everywhere; ``but`` names the one session that stays."""
    ended = delete(AccountSession).where(AccountSession.account_id == account_id)
    session.execute(ended if but is None else ended.where(AccountSession.token_sha256 != but))


def end_stale_sessions(session: Session, now: datetime.datetime, idle: datetime.timedelta) -> None:
    session.execute(
        delete(AccountSession).where((AccountSession.expires_at <= now) | (AccountSession.last_seen_at <= now - idle))
    )


def token_by_digest(session: Session, token_sha256: bytes) -> ApiToken | None:
    return session.scalar(select(ApiToken).where(ApiToken.token_sha256 == token_sha256))


def tokens_of(session: Session, account_id: int) -> Sequence[ApiToken]:
    return session.scalars(select(ApiToken).where(ApiToken.account_id == account_id).order_by(ApiToken.id)).all()


def revoke_tokens(session: Session, account_id: int, now: datetime.datetime) -> None:
    session.execute(
        update(ApiToken).where(ApiToken.account_id == account_id, ApiToken.revoked_at.is_(None)).values(revoked_at=now)
    )


def lock_sign_in(session: Session, *keys: str) -> None:
    """Lets one sign-in at a time pass per key, until the transaction ends: no failure is counted beside another."""
    session.execute(text(f"SET LOCAL lock_timeout = '{_SIGN_IN_PATIENCE_S}s'"))
    for key in sorted(keys):
        session.execute(
            text("SELECT pg_advisory_xact_lock(hashtextextended(:key, 0))"), {"key": f"lanewright sign-in {key}"}
        )


def failures_of(
    session: Session, *, name: str | None = None, address: str | None = None, since: datetime.datetime
) -> tuple[int, datetime.datetime | None]:
    """How many sign-ins failed since then, and when the last of them did."""
    query = select(func.count(), func.max(LoginFailure.at)).where(LoginFailure.at > since)
    if name is not None:
        query = query.where(LoginFailure.name == name)
    if address is not None:
        query = query.where(LoginFailure.address == address)
    count, last = session.execute(query).one()
    return count, last


def add_failure(session: Session, name: str, address: str, at: datetime.datetime) -> None:
    session.add(LoginFailure(name=name, address=address, at=at))
    session.flush()


def forget_failures(session: Session, *, name: str | None = None, before: datetime.datetime | None = None) -> None:
    gone = delete(LoginFailure)
    if name is not None:
        gone = gone.where(LoginFailure.name == name)
    if before is not None:
        gone = gone.where(LoginFailure.at <= before)
    session.execute(gone)
