"""The dataset for pipelines."""

from __future__ import annotations

from collections.abc import Generator
from functools import partial
from typing import Annotated

from fastapi import APIRouter, Depends, Request, Response
from starlette.concurrency import run_in_threadpool
from starlette.responses import StreamingResponse
from starlette.types import Receive, Scope, Send

from lanewright.api.deps import ExportReader, database_url
from lanewright.db.engine import snapshot
from lanewright.services import export
from lanewright.services.export import OpenSnapshot

router = APIRouter(prefix="/api/v1/export", tags=["dataset"])

_TAR = "application/x-tar"


def get_snapshots(request: Request) -> OpenSnapshot:
    """Opens the archive's own view of the database, which outlives the request's transaction."""
    return partial(snapshot, database_url(request))


class _Archive(StreamingResponse):
    """Streams the archive, and lets go of its snapshot at once when the client goes away."""

    def __init__(self, pieces: Generator[bytes], file_name: str) -> None:
        headers = {"Content-Disposition": f'attachment; filename="{file_name}"'}
        super().__init__(pieces, media_type=_TAR, headers=headers)
        self._pieces = pieces

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        try:
            await super().__call__(scope, receive, send)
        finally:
            await run_in_threadpool(self._pieces.close)


@router.get(
    "/{split}.tar",
    operation_id="export_split",
    response_class=Response,
    responses={200: {"description": "The archive.", "content": {_TAR: {"schema": {"format": "binary"}}}}},
)
def export_split(
    split: str, _actor: ExportReader, snapshots: Annotated[OpenSnapshot, Depends(get_snapshots)]
) -> Response:
    """The accepted revisions of a split (train, val or test) as a tar archive, streamed.

    Needs a token with the scope export:read (``Authorization: Bearer …``), or a reviewer's or admin's session:

        curl --fail -H "Authorization: Bearer $TOKEN" $LANEWRIGHT/api/v1/export/train.tar | tar -x

    For every log that has an accepted task: `prior/<log_id>/map/` and `current/<log_id>/map/`, each loaded by
    `av2.map.map_api.ArgoverseStaticMap.from_map_dir` (with the ground raster where the log has one);
    `changes/<log_id>.json`, the atomic changes and structural updates from prior to current; `sensors/<log_id>.json`,
    the frames with timestamps as text, poses and the sensor files of each. Of several accepted tasks on one log the
    one accepted last is exported. `manifest.json` is the last member: per log the task, revision, direction, and size
    and SHA-256 of each file. An archive without it is incomplete.
    """
    wanted = export.split_named(split)
    return _Archive(export.archive(snapshots, wanted), f"lanewright-{wanted.value}.tar")
