"""The API's documentation, from our own server: no other host is asked and no script stands in the page."""

from __future__ import annotations

from importlib.resources import as_file, files
from typing import Annotated, Literal

from fastapi import APIRouter, Path
from starlette.responses import FileResponse, HTMLResponse, Response

router = APIRouter(prefix="/docs", include_in_schema=False)

_PAGE = """<!doctype html><html lang="en"><head><meta charset="utf-8"><title>Lanewright API</title>
<meta name="viewport" content="width=device-width, initial-scale=1">
<link rel="stylesheet" href="/docs/swagger-ui.css"><link rel="icon" href="/docs/favicon.png"></head>
<body><div id="swagger-ui"></div>
<script src="/docs/swagger-ui-bundle.js"></script><script src="/docs/start.js"></script></body></html>"""
_START = """SwaggerUIBundle({
  url: "/openapi.json",
  dom_id: "#swagger-ui",
  deepLinking: true,
  presets: [SwaggerUIBundle.presets.apis, SwaggerUIBundle.SwaggerUIStandalonePreset],
  requestInterceptor: async (request) => {
    // A browser that is signed in proves with its session's token that our own page sent the request.
    if (!["GET", "HEAD"].includes((request.method || "GET").toUpperCase())) {
      const answer = await fetch("/api/v1/session");
      if (answer.ok) request.headers["X-CSRF-Token"] = (await answer.json()).csrf_token;
    }
    return request;
  },
});
"""
_CACHED = {"Cache-Control": "no-cache"}


@router.get("")
def docs() -> Response:
    """Swagger UI."""
    return HTMLResponse(_PAGE, headers=_CACHED)


@router.get("/start.js")
def start() -> Response:
    return Response(_START, media_type="text/javascript", headers=_CACHED)


@router.get("/{name}")
def asset(name: Annotated[Literal["swagger-ui.css", "swagger-ui-bundle.js", "favicon.png"], Path()]) -> Response:
    """Swagger UI's files, as the package fastapi-offline ships them."""
    with as_file(files("fastapi_offline") / "static" / name) as path:
        return FileResponse(path, headers=_CACHED)
