"""Whether the process lives, and whether it can serve."""

from __future__ import annotations

from fastapi import APIRouter, Request

from lanewright.api.deps import SettingsDep, database_url
from lanewright.api.frontend import INDEX
from lanewright.core.errors import LanewrightError
from lanewright.db.migration import pending

router = APIRouter(tags=["operation"])


class NotReady(LanewrightError):
    """The process lives but cannot serve yet."""

    code = "server.not_ready"


@router.get("/healthz", operation_id="healthz")
def healthz() -> dict[str, str]:
    """The process answers."""
    return {"status": "alive"}


@router.get("/readyz", operation_id="readyz")
def readyz(request: Request, settings: SettingsDep) -> dict[str, str]:
    """The database answers and is migrated, and the frontend is built."""
    if pending(database_url(request)):
        raise NotReady("The database lacks migrations.", mend="Run: lanewright migrate")
    if not (settings.frontend / INDEX).is_file():
        raise NotReady("The frontend is not built.", mend="Run: make run, or npm run build in frontend/.")
    return {"status": "ready", "database": "migrated", "frontend": "built"}
