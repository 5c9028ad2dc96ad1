"""Every way to fail becomes one body, Problem; HTTP status codes are decided here and nowhere else."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import structlog
from fastapi import FastAPI, Request
from fastapi.exceptions import RequestValidationError
from sqlalchemy.exc import DataError, DBAPIError, OperationalError
from sqlalchemy.exc import TimeoutError as PoolTimeout
from starlette.exceptions import HTTPException
from starlette.responses import JSONResponse, Response

from lanewright.api.request_id import current_request_id
from lanewright.api.schemas.base import Problem
from lanewright.core.errors import (
    Conflict,
    Forbidden,
    InvalidInput,
    LanewrightError,
    NotFound,
    Throttled,
    Unauthenticated,
)

STATUS: Mapping[type[LanewrightError], int] = {
    InvalidInput: 422,
    Unauthenticated: 401,
    Forbidden: 403,
    NotFound: 404,
    Conflict: 409,
    Throttled: 429,
}
STATUS_BY_CODE: Mapping[str, int] = {"save.violations": 422, "server.not_ready": 503}
"""Codes whose class says too little."""

RESPONSES: dict[int | str, dict[str, Any]] = {
    status: {"model": Problem, "description": description}
    for status, description in {
        400: "The request is not well-formed.",
        401: "Nobody is signed in, or the credentials do not hold.",
        403: "The asker may not do this.",
        404: "It does not exist, or the asker may not know that it does.",
        409: "It contradicts the present state.",
        413: "The body is too large.",
        422: "Something in the request cannot be used; the message says what, where and how to mend it.",
        429: "Too many attempts.",
        500: "An error of the server; the request id finds it in the log.",
        503: "The database cannot be reached at the moment.",
    }.items()
}
"""What every route may answer besides its success."""

_MENDS = {
    400: "Send a well-formed request.",
    404: "Check the address.",
    405: "See /docs for what this address accepts.",
    413: "Send less at once, or ask an admin to raise LANEWRIGHT_BODY_LIMIT_BYTES.",
}
_HTTP_CODES = {
    400: "request.malformed",
    404: "not_found",
    405: "request.method",
    413: "request.too_large",
    415: "request.media_type",
}
_log = structlog.get_logger("lanewright.api")


def problem(
    status: int,
    code: str,
    message: str,
    mend: str = "",
    facts: dict[str, Any] | None = None,
    headers: Mapping[str, str] | None = None,
) -> Response:
    """An error's response."""
    body = Problem(code=code, message=message, mend=mend, facts=facts or {}, request_id=current_request_id())
    return JSONResponse(body.model_dump(mode="json"), status, headers=headers)


def problem_of(error: LanewrightError) -> Response:
    """The response that tells a domain error."""
    status = STATUS_BY_CODE.get(error.code) or next((s for kind, s in STATUS.items() if isinstance(error, kind)), 500)
    headers = {}
    if status == 401:
        headers["WWW-Authenticate"] = "Bearer"
    if "retry_after_s" in error.facts:
        headers["Retry-After"] = str(error.facts["retry_after_s"])
    return problem(status, error.code, error.message, error.mend, error.facts, headers)


def too_large() -> Response:
    return problem(413, _HTTP_CODES[413], "The body of the request is too large.", _MENDS[413])


def unknown_host() -> Response:
    return problem(
        400,
        "request.host",
        "This server does not answer to that host name.",
        "Open it as 127.0.0.1 or localhost; for other names set LANEWRIGHT_PUBLIC_URL.",
    )


def unexpected() -> Response:
    """The response to an error that nobody foresaw; the log has its trace under the same request id."""
    return problem(
        500,
        "server.error",
        "Something went wrong in the server; nothing was changed.",
        f"Try again. If it stays, tell an admin the request id {current_request_id()}.",
    )


def register(app: FastAPI) -> None:
    """Makes the app answer every error with a Problem."""
    app.exception_handler(LanewrightError)(_domain)
    app.exception_handler(RequestValidationError)(_validation)
    app.exception_handler(HTTPException)(_http)
    app.exception_handler(DataError)(_out_of_range)
    app.exception_handler(OperationalError)(_database)
    app.exception_handler(PoolTimeout)(_database)
    app.exception_handler(DBAPIError)(_driver)


def _domain(_request: Request, error: LanewrightError) -> Response:
    return problem_of(error)


def _validation(_request: Request, error: RequestValidationError) -> Response:
    details = error.errors()
    first = details[0]
    where = place_of(first["loc"])
    more = f" ({len(details) - 1} more)" if len(details) > 1 else ""
    return problem(
        422,
        "request.invalid",
        f"{where}: {_sentence(first)}{more}" if where else f"{_sentence(first)}{more}",
        "Correct it there; /docs shows what is expected.",
        {"errors": [{"where": place_of(d["loc"]), "message": _sentence(d)} for d in details[:20]]},
    )


def place_of(location: Sequence[str | int]) -> str:
    """``edits[3].attributes.left_lane_boundary[2].x`` for pydantic's location of an error."""
    parts = list(location)
    if parts and parts[0] in ("body", "path", "query", "header", "cookie"):
        parts = parts[1:]
    return "".join(f"[{part}]" if isinstance(part, int) else f".{part:.80}" for part in parts).removeprefix(".")


def _sentence(detail: Mapping[str, Any]) -> str:
    message = str(detail["msg"])
    return message[:1].lower() + message[1:]


def _http(_request: Request, error: HTTPException) -> Response:
    status = error.status_code
    if status == 413:
        return too_large()
    message = "There is nothing at this address." if status == 404 else f"{error.detail}."
    return problem(
        status, _HTTP_CODES.get(status, "request.refused"), message, _MENDS.get(status, ""), headers=error.headers
    )


def _out_of_range(_request: Request, error: DataError) -> Response:
    _log.warning("value refused by the database", error=str(error.orig))
    return problem(422, "request.invalid", "A value is outside the range that can be stored.", "Use a smaller value.")


def _driver(request: Request, error: DBAPIError) -> Response:
    if error.connection_invalidated:
        return _database(request, error)
    raise error


def _database(_request: Request, error: Exception) -> Response:
    # The driver's words only: SQLAlchemy's would add the statement's values.
    _log.error("database not usable", error=str(error.orig if isinstance(error, DBAPIError) else error))
    return problem(
        503,
        "server.database",
        "The database cannot be reached at the moment; nothing was changed.",
        "Your draft is kept on this computer. Try again in a few seconds.",
        headers={"Retry-After": "2"},
    )
