"""People, sign-in and API tokens."""

from __future__ import annotations

import datetime
from typing import Annotated

from pydantic import Field, StringConstraints

from lanewright.api.schemas.base import Incoming, Outgoing, Text
from lanewright.core.workflow import Role

AccountName = Annotated[
    str, StringConstraints(strip_whitespace=True, min_length=1, max_length=64, pattern=r"^[\w.@+-]+$")
]
Password = Annotated[str, StringConstraints(min_length=10, max_length=256, pattern=r"^[^\u0000]*$")]


class AccountOut(Outgoing):
    id: int
    name: str
    role: Role
    created_at: datetime.datetime
    disabled_at: datetime.datetime | None


class PersonOut(Outgoing):
    """Somebody, as others see them."""

    id: int
    name: str


class SignIn(Incoming):
    name: Annotated[str, StringConstraints(max_length=256)]
    password: Annotated[str, StringConstraints(max_length=256)]


class SessionOut(Outgoing):
    """Who is signed in. Send ``csrf_token`` as X-CSRF-Token with every request that changes something."""

    account: AccountOut
    csrf_token: str
    demo: bool
    """Whether this server runs with the demo's sign-ins."""


class PasswordChange(Incoming):
    current: str = Field(max_length=256)
    new: Password


class AccountCreate(Incoming):
    name: AccountName
    role: Role = Field(strict=False)
    password: Password


class AccountPatch(Incoming):
    """What an admin changes; left out means unchanged."""

    role: Role | None = Field(None, strict=False)
    disabled: bool | None = None
    password: Password | None = None


class TokenCreate(Incoming):
    name: Text = Field(min_length=1, max_length=100)
    scopes: list[str] = Field(min_length=1, max_length=10, description="Known scopes: export:read, changes:read")
    days: int = Field(90, ge=1, le=366)


class TokenOut(Outgoing):
    id: int
    name: str
    scopes: list[str]
    created_at: datetime.datetime
    expires_at: datetime.datetime
    revoked_at: datetime.datetime | None
    last_used_at: datetime.datetime | None


class TokenCreated(TokenOut):
    """The one time that the token itself is shown."""

    token: str
