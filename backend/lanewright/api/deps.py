"""What routes depend on: the database session (committed here and only here), and who asks."""

from __future__ import annotations

import datetime
from collections.abc import Iterator
from typing import Annotated

from fastapi import Depends, Request
from fastapi.security import APIKeyCookie, HTTPAuthorizationCredentials, HTTPBearer
from sqlalchemy.orm import Session

from lanewright.api.cross_site import SAFE_METHODS, require_csrf_token, require_own_origin
from lanewright.core.errors import Forbidden, Unauthenticated
from lanewright.core.workflow import Role
from lanewright.db.engine import transaction
from lanewright.db.models import Account, AccountSession
from lanewright.services import sessions, tokens
from lanewright.services.actor import REVIEWING_ROLES, Actor
from lanewright.services.sessions import SessionRules
from lanewright.services.tokens import Scope
from lanewright.settings import Settings

COOKIE = "lanewright_session"


def get_session(request: Request) -> Iterator[Session]:
    """A transaction per request, committed before the answer is sent and rolled back when the route raises."""
    with transaction(database_url(request)) as session:
        yield session


# "function": in FastAPI a dependency's exit code otherwise runs after the response, and a failed commit would be a 2xx.
SessionDep = Annotated[Session, Depends(get_session, scope="function")]


def get_app_settings(request: Request) -> Settings:
    settings: Settings = request.app.state.settings
    return settings


SettingsDep = Annotated[Settings, Depends(get_app_settings)]


def database_url(request: Request) -> str:
    url: str = request.app.state.database_url
    return url


def session_rules(settings: SettingsDep) -> SessionRules:
    return SessionRules(
        idle=datetime.timedelta(seconds=settings.session_idle_s),
        absolute=datetime.timedelta(seconds=settings.session_absolute_s),
        demo_allowed=settings.demo_allowed,
    )


SessionRulesDep = Annotated[SessionRules, Depends(session_rules)]


def cookie_name(settings: Settings) -> str:
    """``__Host-`` makes browsers insist on TLS, this host and the whole path; it is not allowed without TLS."""
    return f"__Host-{COOKIE}" if settings.secure_cookies else COOKIE


_documented_cookie = APIKeyCookie(name=COOKIE, scheme_name="session", auto_error=False)


def session_cookie(
    request: Request, settings: SettingsDep, _documented: Annotated[str | None, Depends(_documented_cookie)]
) -> str | None:
    """The session's token, under the name that the cookie has here."""
    return request.cookies.get(cookie_name(settings))


_bearer = HTTPBearer(scheme_name="token", auto_error=False, description="An API token; only good for its scopes.")
CookieDep = Annotated[str | None, Depends(session_cookie)]
BearerDep = Annotated[HTTPAuthorizationCredentials | None, Depends(_bearer)]


def browser_session(
    request: Request, session: SessionDep, settings: SettingsDep, rules: SessionRulesDep, cookie: CookieDep
) -> AccountSession:
    """The browser's session; a request that changes something must also prove that our own page sent it.

    Raises:
        Unauthenticated: no cookie, or its session has ended.
        Forbidden: another site's page sent it, or the CSRF token is not the session's.
    """
    if cookie is None:
        # The sign-in page offers the demo's sign-ins where they are good.
        raise Unauthenticated("Nobody is signed in.", mend="Sign in.", code="session.none", demo=settings.demo_allowed)
    found = sessions.resume(session, cookie, rules)
    if request.method not in SAFE_METHODS:
        require_own_origin(request, settings)
        require_csrf_token(request, found.csrf_token)
    return found


BrowserSessionDep = Annotated[AccountSession, Depends(browser_session)]


class Admission:
    """Dependency: lets in who has one of ``roles``, by cookie, or by a bearer token where ``scope`` names one."""

    def __init__(self, roles: frozenset[Role] = frozenset(Role), scope: Scope | None = None) -> None:
        self.roles = roles
        self.scope = scope

    def __call__(
        self,
        request: Request,
        session: SessionDep,
        settings: SettingsDep,
        rules: SessionRulesDep,
        cookie: CookieDep,
        bearer: BearerDep,
    ) -> Actor:
        """Who asks. Raises Unauthenticated or Forbidden."""
        if bearer is not None:
            account = self._by_token(session, bearer.credentials)
        else:
            account = browser_session(request, session, settings, rules, cookie).account
        actor = sessions.actor_of(account)
        if actor.role not in self.roles:
            needed = " or ".join(sorted(role.value for role in self.roles))
            raise Forbidden(f"This is for the role {needed}.", mend="Ask an admin.", code="account.role")
        return actor

    def _by_token(self, session: Session, secret: str) -> Account:
        token = tokens.use(session, secret)
        if self.scope is None or self.scope.value not in token.scopes:
            needed = f"the scope {self.scope.value}" if self.scope else "a signed-in browser"
            raise Forbidden(
                f"This needs {needed}; the token has {', '.join(token.scopes)}.",
                mend="Create a token with the scope it needs, or sign in.",
                code="token.scope",
            )
        return token.account


AnyActor = Annotated[Actor, Depends(Admission())]
ReviewingActor = Annotated[Actor, Depends(Admission(REVIEWING_ROLES))]
AdminActor = Annotated[Actor, Depends(Admission(frozenset({Role.ADMIN})))]
ExportReader = Annotated[Actor, Depends(Admission(REVIEWING_ROLES, Scope.EXPORT_READ))]
ChangesReader = Annotated[Actor, Depends(Admission(REVIEWING_ROLES, Scope.CHANGES_READ))]


def client_address(request: Request) -> str:
    """Where the request comes from, as far as the server (or a trusted proxy) knows."""
    return request.client.host if request.client else "unknown"
