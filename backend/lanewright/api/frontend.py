"""Serves the built frontend: its files, and index.html for every address that the page itself routes."""

from __future__ import annotations

from pathlib import Path

from fastapi import APIRouter, Request
from starlette.convertors import StringConvertor, register_url_convertor
from starlette.exceptions import HTTPException
from starlette.responses import FileResponse, HTMLResponse, Response
from starlette.staticfiles import StaticFiles

from lanewright.settings import Settings

INDEX = "index.html"
ASSETS = "assets"
_FOREVER = "public, max-age=31536000, immutable"
_ASK_AGAIN = "no-cache"
_NOT_BUILT = """<!doctype html><html lang="en"><meta charset="utf-8"><title>Lanewright</title>
<h1>The frontend is not built</h1>
<p>The server runs, but its pages were not made yet. Run <code>make run</code>, or
<code>npm ci &amp;&amp; npm run build</code> in <code>frontend/</code>, then reload this page.</p></html>"""


class _PageConvertor(StringConvertor):
    """Matches what the API does not own, so that a wrong method under /api is a 405 and a wrong path a JSON 404."""

    regex = r"(?!api(?:/|$)|docs(?:/|$)|openapi\.json$|healthz$|readyz$).*"


register_url_convertor("page", _PageConvertor())
router = APIRouter(include_in_schema=False)


@router.api_route("/{path:page}", methods=["GET", "HEAD"])
def page(path: str, request: Request) -> Response:
    """A file of the build; else the page, which finds the rest of the address by itself."""
    settings: Settings = request.app.state.settings
    index = settings.frontend / INDEX
    if not index.is_file():
        return HTMLResponse(_NOT_BUILT, 503, headers={"Cache-Control": "no-store"})
    found = _file(settings.frontend, path)
    if found is not None:
        hashed = path.startswith(f"{ASSETS}/")
        return FileResponse(found, headers={"Cache-Control": _FOREVER if hashed else _ASK_AGAIN})
    if path.startswith(f"{ASSETS}/"):
        raise HTTPException(404)  # an old page asks for a script of an earlier build: HTML would only confuse it
    return FileResponse(index, headers={"Cache-Control": _ASK_AGAIN})


def _file(folder: Path, path: str) -> Path | None:
    """The file in the folder, never outside of it."""
    full_path, stat = StaticFiles(directory=folder).lookup_path(path)
    return Path(full_path) if path and stat is not None and Path(full_path).is_file() else None
