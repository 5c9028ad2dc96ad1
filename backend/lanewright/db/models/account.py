"""People, their browser sessions and their API tokens. Secrets are stored as hashes only."""

from __future__ import annotations

from sqlalchemy import ARRAY, CheckConstraint, ForeignKey, Index, Text, func
from sqlalchemy.orm import Mapped, mapped_column, relationship

from lanewright.db.models.base import Base, created, identity, moment


class Account(Base):
    """A person. ``name`` is unique without regard to case; a disabled account keeps its history."""

    __tablename__ = "account"

    id: Mapped[identity]
    name: Mapped[str] = mapped_column(Text)
    role: Mapped[str] = mapped_column(Text)
    password_hash: Mapped[str] = mapped_column(Text)
    created_at: Mapped[created]
    disabled_at: Mapped[moment | None]

    __table_args__ = (
        Index("uq_account_name", func.lower(name), unique=True),
        CheckConstraint("role IN ('annotator', 'reviewer', 'admin')", name="role"),
    )


class AccountSession(Base):
    """A signed-in browser; the cookie's token is known here by its SHA-256."""

    __tablename__ = "account_session"

    token_sha256: Mapped[bytes] = mapped_column(primary_key=True)
    account_id: Mapped[int] = mapped_column(ForeignKey("account.id", ondelete="CASCADE"), index=True)
    csrf_token: Mapped[str] = mapped_column(Text)
    created_at: Mapped[created]
    last_seen_at: Mapped[moment]
    expires_at: Mapped[moment]

    account: Mapped[Account] = relationship(lazy="joined", innerjoin=True)


class ApiToken(Base):
    """A pipeline's credential; shown once, known by its SHA-256, limited to its scopes."""

    __tablename__ = "api_token"

    id: Mapped[identity]
    account_id: Mapped[int] = mapped_column(ForeignKey("account.id", ondelete="CASCADE"), index=True)
    name: Mapped[str] = mapped_column(Text)
    token_sha256: Mapped[bytes] = mapped_column(unique=True)
    scopes: Mapped[list[str]] = mapped_column(ARRAY(Text))
    created_at: Mapped[created]
    expires_at: Mapped[moment]
    revoked_at: Mapped[moment | None]
    last_used_at: Mapped[moment | None]

    account: Mapped[Account] = relationship(lazy="joined", innerjoin=True)


class LoginFailure(Base):
    """A sign-in that failed; the throttle counts them by name and by address."""

    __tablename__ = "login_failure"

    id: Mapped[identity]
    name: Mapped[str] = mapped_column(Text, index=True)
    address: Mapped[str] = mapped_column(Text, index=True)
    at: Mapped[created]
