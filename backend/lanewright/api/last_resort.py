"""LastResort: what no handler caught still gets an answer that a person can use, and never a trace."""

from __future__ import annotations

import structlog
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from lanewright.api.errors import problem, too_large, unexpected, unknown_host

_log = structlog.get_logger("lanewright.api")
_WORDED = {413: too_large, 400: unknown_host}
"""Answers of Starlette's body limit and its check of the Host header, by status."""


class LastResort:
    """Answers unforeseen errors with a Problem, refuses NUL in addresses, and words what the framework says barely."""

    def __init__(self, app: ASGIApp) -> None:
        self._app = app

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        if scope["type"] != "http":
            await self._app(scope, receive, send)
            return
        if "\0" in scope["path"] or b"%00" in scope["query_string"]:
            refusal = problem(422, "request.invalid", "The address contains the NUL character (%00).", "Remove it.")
            await refusal(scope, receive, send)
            return
        started = replaced = False

        async def send_worded(message: Message) -> None:
            nonlocal started, replaced
            if message["type"] == "http.response.start" and not replaced:
                started = True
                bare = (b"content-type", b"text/plain; charset=utf-8") in message["headers"]
                if bare and message["status"] in _WORDED:
                    replaced = True
                    await _WORDED[message["status"]]()(scope, receive, send)
            if not replaced:
                await send(message)

        try:
            await self._app(scope, receive, send_worded)
        except Exception:
            _log.exception("unforeseen error", path=scope["path"])
            if started:
                raise  # the connection is cut, so that the client sees an incomplete answer as one
            await unexpected()(scope, receive, send)
