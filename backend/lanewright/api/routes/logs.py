"""Imported logs."""

from __future__ import annotations

from fastapi import APIRouter, Request, Response

from lanewright.api.deps import AnyActor, ReviewingActor, SessionDep
from lanewright.api.schemas.logs import LogOut, LogPage
from lanewright.api.schemas.path import Page, PageSize
from lanewright.api.strict_json import StrictRoute
from lanewright.services import logs

router = APIRouter(prefix="/api/v1/logs", tags=["logs"], route_class=StrictRoute)

_FOR_GOOD = "private, max-age=31536000, immutable"


@router.get("", operation_id="list_logs")
def list_logs(
    _actor: ReviewingActor,
    session: SessionDep,
    q: str = "",
    city: str | None = None,
    split: str | None = None,
    page: Page = 1,
    page_size: PageSize = 50,
) -> LogPage:
    """Imported logs by id; ``q``: part of the id."""
    found, total = logs.listing(session, text=q.strip(), city=city, split=split, page=page, page_size=page_size)
    items = [LogOut.model_validate(log) for log in found]
    return LogPage(items=items, total=total, page=page, page_size=page_size)


@router.get(
    "/{log_id}/lidar.png",
    operation_id="lidar_image",
    response_class=Response,
    responses={
        200: {"description": "Intensity image, north up.", "content": {"image/png": {}}},
        304: {"description": "The image that the browser has is still the one."},
    },
)
def lidar_image(log_id: str, request: Request, actor: AnyActor, session: SessionDep) -> Response:
    """The lidar intensity image under the map; reviewers see all, annotators those of their tasks' logs."""
    image = logs.lidar_image(session, actor, log_id)
    etag = f'"{image.sha256.hex()}"'
    headers = {"ETag": etag, "Cache-Control": _FOR_GOOD}
    seen = {tag.strip().removeprefix("W/") for tag in request.headers.get("If-None-Match", "").split(",")}
    if etag in seen or "*" in seen:
        return Response(status_code=304, headers=headers)
    return Response(image.load(session), media_type="image/png", headers=headers)
