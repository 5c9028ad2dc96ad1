"""The web application: routers, middleware and errors put together."""

from __future__ import annotations

from fastapi import APIRouter, FastAPI
from starlette.middleware.body_limit import RequestBodyLimitMiddleware
from starlette.middleware.gzip import DEFAULT_EXCLUDED_CONTENT_TYPES, GZipMiddleware
from starlette.middleware.trustedhost import TrustedHostMiddleware

from lanewright import __version__
from lanewright.api import errors, frontend
from lanewright.api.last_resort import LastResort
from lanewright.api.request_id import RequestId
from lanewright.api.routes import (
    accounts,
    changes,
    docs,
    export,
    logs,
    operation,
    revisions,
    session,
    steps,
    tasks,
    tokens,
    workspace,
)
from lanewright.api.security_headers import SecurityHeaders
from lanewright.cluster import PrivateCluster
from lanewright.settings import LOOPBACK_HOSTS, InvalidSettings, Settings, get_settings

SMALL_BODY_BYTES = 64 * 1024
"""Limit of every body but drafts, saves and reviews."""


def create_app(settings: Settings | None = None, database_url: str | None = None) -> FastAPI:
    """The application.

    Args:
        settings: default: from the environment.
        database_url: default: the one in the settings, else the private cluster's, which must run.

    Raises:
        InvalidSettings: there is no database to use.
    """
    settings = settings or get_settings()
    app = FastAPI(
        title="Lanewright",
        version=__version__,
        description="Annotate how HD maps change: one map update, one explanation.",
        responses=errors.RESPONSES,
        docs_url=None,
        redoc_url=None,
    )
    app.state.settings = settings
    app.state.database_url = database_url or settings.database_url or _cluster_url(settings)
    for module in (session, accounts, tokens, tasks, logs, changes, export, operation, docs):
        app.include_router(module.router)
    drawn = APIRouter(max_body_size=settings.body_limit_bytes)  # what people draw and remark on may be large
    for module in (workspace, revisions, steps):
        drawn.include_router(module.router)
    app.include_router(drawn)
    app.include_router(frontend.router)
    errors.register(app)
    # The last one added is the outermost. Routers may raise the limit that this one sets.
    app.add_middleware(RequestBodyLimitMiddleware, max_body_size=SMALL_BODY_BYTES)
    # Level 9, the default, takes ten times as long on a map for a twentieth less.
    app.add_middleware(
        GZipMiddleware, compresslevel=6, exclude_content_types=(*DEFAULT_EXCLUDED_CONTENT_TYPES, "application/x-tar")
    )
    if settings.demo_allowed:
        # The demo's passwords are known: no page that tricks a browser by DNS may use them.
        app.add_middleware(TrustedHostMiddleware, allowed_hosts=[*LOOPBACK_HOSTS, "[::1]"], www_redirect=False)
    app.add_middleware(LastResort)
    app.add_middleware(SecurityHeaders, secure=settings.secure_cookies)
    app.add_middleware(RequestId)
    return app


def _cluster_url(settings: Settings) -> str:
    url = PrivateCluster(settings.home).status().url
    if url is None:
        raise InvalidSettings(
            "There is no database: DATABASE_URL is not set and the private cluster does not run.",
            mend="Start Lanewright with: lanewright serve",
        )
    return url
