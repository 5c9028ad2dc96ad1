"""The dataset for pipelines."""

from __future__ import annotations

from functools import partial
from typing import Annotated

from fastapi import APIRouter, Depends, Request, Response
from starlette.responses import StreamingResponse

from lanewright.api.deps import ExportReader, database_url
from lanewright.db.engine import snapshot
from lanewright.services import export
from lanewright.services.export import OpenSnapshot

router = APIRouter(prefix="/api/v1/export", tags=["dataset"])

_TAR = "application/x-tar"


def get_snapshots(request: Request) -> OpenSnapshot:
    """Opens the archive's own view of the database, which outlives the request's transaction."""
    return partial(snapshot, database_url(request))


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
    headers = {"Content-Disposition": f'attachment; filename="lanewright-{wanted.value}.tar"'}
    return StreamingResponse(export.archive(snapshots, wanted), media_type=_TAR, headers=headers)
