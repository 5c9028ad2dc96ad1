"""Password hashes (argon2id) and random secrets."""

from __future__ import annotations

import hashlib
import secrets
from functools import lru_cache
from threading import BoundedSemaphore

from pwdlib import PasswordHash

_SECRET_BYTES = 32
_AT_ONCE = BoundedSemaphore(4)
"""Each check takes 64 MiB: a flood of sign-ins must not take all memory."""


@lru_cache(maxsize=1)
def _hasher() -> PasswordHash:
    return PasswordHash.recommended()


@lru_cache(maxsize=1)
def _nobodys_hash() -> str:
    return hash_password(new_secret())


def hash_password(password: str) -> str:
    """The salted argon2id hash to store."""
    return _hasher().hash(password)


def password_holds(password: str, stored: str | None) -> bool:
    """Whether the password matches. Without a stored hash the same work is done: time tells nobody who exists."""
    expected = stored or _nobodys_hash()
    with _AT_ONCE:
        return _hasher().verify(password, expected) and stored is not None


def new_secret() -> str:
    """A random token for a cookie, a CSRF field or a pipeline."""
    return secrets.token_urlsafe(_SECRET_BYTES)


def digest(secret: str) -> bytes:
    """What is stored of a random secret. It has 256 bits of its own, so a plain SHA-256 is enough."""
    return hashlib.sha256(secret.encode()).digest()
