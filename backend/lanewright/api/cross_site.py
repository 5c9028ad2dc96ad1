"""Whether a request that changes something comes from our own pages."""

from __future__ import annotations

import hmac
from urllib.parse import urlsplit

from starlette.requests import Request

from lanewright.core.errors import Forbidden
from lanewright.settings import Settings

CSRF_HEADER = "X-CSRF-Token"
SAFE_METHODS = frozenset({"GET", "HEAD", "OPTIONS"})


def require_own_origin(request: Request, settings: Settings) -> None:
    """Refuses what a browser says was sent by another site's page; programs that say nothing pass.

    Raises:
        Forbidden: ``session.cross_site``.
    """
    site = request.headers.get("sec-fetch-site")
    origin = request.headers.get("origin")
    own = {request.headers.get("host", ""), urlsplit(settings.public_url or "").netloc}
    if (site is not None and site not in ("same-origin", "none")) or (
        origin is not None and urlsplit(origin).netloc not in own - {""}
    ):
        raise Forbidden(
            "This request was sent by a page of another site.",
            mend="Use Lanewright's own pages; behind a proxy, set LANEWRIGHT_PUBLIC_URL to the address people use.",
            code="session.cross_site",
        )


def require_csrf_token(request: Request, expected: str) -> None:
    """Refuses an unsafe request whose header does not hold the session's own token.

    Raises:
        Forbidden: ``session.csrf``.
    """
    given = request.headers.get(CSRF_HEADER, "")
    if not hmac.compare_digest(given.encode("latin-1", "replace"), expected.encode()):
        raise Forbidden(
            f"The header {CSRF_HEADER} is missing or not this session's.",
            mend="Reload the page, or take csrf_token from GET /api/v1/session.",
            code="session.csrf",
        )
