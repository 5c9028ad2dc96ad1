"""The ground under a log, from which new and moved points take their height."""

from __future__ import annotations

import math

import numpy as np
from sqlalchemy.orm import Session

from lanewright.core.elevation import Ground
from lanewright.db.repositories import logs
from lanewright.formats.ground import GroundHeight, parse_ground
from lanewright.services.recently_used import RecentlyUsed

RASTER = "ground.npy"
PLACEMENT = "sim2.json"
_RASTERS: RecentlyUsed[GroundHeight] = RecentlyUsed(most=32)


def ground_of(session: Session, log_row_id: int) -> Ground:
    """Height of the ground by place; NaN everywhere for a log without a ground raster."""
    hashes = logs.asset_hashes(session, log_row_id)
    if RASTER not in hashes or PLACEMENT not in hashes:
        return _nowhere
    sha256 = hashes[RASTER] + hashes[PLACEMENT]
    height = _RASTERS.get(sha256)
    if height is None:
        raster, placement = (logs.asset_body(session, log_row_id, name) for name in (RASTER, PLACEMENT))
        height = parse_ground(raster, RASTER, placement, PLACEMENT)
        _RASTERS.put(sha256, height)
    height_at = height.at

    def ground(x: float, y: float) -> float:
        return float(height_at(np.array([[x, y]]))[0])

    return ground


def _nowhere(_x: float, _y: float) -> float:
    return math.nan
