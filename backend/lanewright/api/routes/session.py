"""Signing in and out, and one's own password."""

from __future__ import annotations

from typing import Annotated

from fastapi import APIRouter, Depends, Request, Response

from lanewright.api.cross_site import require_own_origin
from lanewright.api.deps import (
    AnyActor,
    BrowserSessionDep,
    CookieDep,
    SessionDep,
    SessionRulesDep,
    SettingsDep,
    client_address,
    cookie_name,
)
from lanewright.api.errors import problem_of
from lanewright.api.schemas.accounts import AccountOut, PasswordChange, SessionOut, SignIn
from lanewright.api.strict_json import StrictRoute
from lanewright.core.errors import LanewrightError
from lanewright.db.models import AccountSession
from lanewright.services import sessions
from lanewright.settings import Settings

router = APIRouter(prefix="/api/v1/session", tags=["session"], route_class=StrictRoute)
AddressDep = Annotated[str, Depends(client_address)]


@router.post("", operation_id="sign_in", response_model=SessionOut)
def sign_in(
    body: SignIn,
    request: Request,
    response: Response,
    session: SessionDep,
    settings: SettingsDep,
    rules: SessionRulesDep,
    cookie: CookieDep,
    address: AddressDep,
) -> SessionOut | Response:
    """Begins a session and sets its cookie. Every failure gets one message; repeated ones have to wait."""
    require_own_origin(request, settings)
    outcome = sessions.sign_in(session, body.name, body.password, address=address, previous_token=cookie, rules=rules)
    if isinstance(outcome, LanewrightError):
        return problem_of(outcome)  # answered, not raised: the failure must be committed to count
    response.set_cookie(
        cookie_name(settings),
        outcome.token,
        max_age=settings.session_absolute_s,
        path="/",
        httponly=True,
        samesite="strict",
        secure=settings.secure_cookies,
    )
    return _session_out(outcome.session, settings)


@router.get("", operation_id="get_session")
def get_session(current: BrowserSessionDep, settings: SettingsDep) -> SessionOut:
    """Who is signed in, and the CSRF token of their session."""
    return _session_out(current, settings)


@router.delete("", operation_id="sign_out", status_code=204)
def sign_out(current: BrowserSessionDep, session: SessionDep, settings: SettingsDep, response: Response) -> None:
    """Ends this session."""
    sessions.end(session, current)
    response.delete_cookie(
        cookie_name(settings), path="/", httponly=True, samesite="strict", secure=settings.secure_cookies
    )


@router.put("/password", operation_id="change_password", status_code=204, response_model=None)
def change_password(
    body: PasswordChange, actor: AnyActor, current: BrowserSessionDep, session: SessionDep, address: AddressDep
) -> Response | None:
    """Sets one's own password and signs out one's other browsers."""
    refusal = sessions.change_password(
        session, actor, current=body.current, new=body.new, address=address, keep=current
    )
    return problem_of(refusal) if refusal else None


def _session_out(current: AccountSession, settings: Settings) -> SessionOut:
    return SessionOut(
        account=AccountOut.model_validate(current.account), csrf_token=current.csrf_token, demo=settings.demo_allowed
    )
