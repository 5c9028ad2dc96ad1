"""Request bodies are untrusted JSON, as files are: no duplicate keys, NaN, NUL, lone surrogates or depth bombs."""

from __future__ import annotations

from collections.abc import Callable, Coroutine
from typing import Any

from fastapi.routing import APIRoute
from starlette.concurrency import run_in_threadpool
from starlette.exceptions import HTTPException
from starlette.requests import Request
from starlette.responses import Response

from lanewright.api.errors import problem_of
from lanewright.core.errors import InvalidInput
from lanewright.formats.json_document import Limits, parse_json

_LIMITS = Limits(depth=20, nodes=1_000_000)


class _Refused(HTTPException):
    """Passes through the framework's body reader, which would blur any other exception."""

    def __init__(self, error: InvalidInput) -> None:
        super().__init__(422)
        self.error = error


class _StrictRequest(Request):
    async def json(self) -> Any:
        body = await self.body()
        try:
            return (await run_in_threadpool(parse_json, body, "request body", _LIMITS)).value
        except InvalidInput as error:
            raise _Refused(error) from None


class StrictRoute(APIRoute):
    """A route whose JSON body is parsed strictly, off the event loop. Routers of the API use it (``route_class``)."""

    def get_route_handler(self) -> Callable[[Request], Coroutine[Any, Any, Response]]:
        handle = super().get_route_handler()

        async def handle_strictly(request: Request) -> Response:
            try:
                return await handle(_StrictRequest(request.scope, request.receive))
            except _Refused as refused:
                return problem_of(refused.error)

        return handle_strictly
