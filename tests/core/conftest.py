"""What the core's tests share; its folder is on the path, so that ``worlds`` and ``findings`` can be imported."""

from __future__ import annotations

import pytest
from tests.core.worlds import REAL_MAPS, REAL_MAPS_MISSING, real_map

from lanewright.core.elements import MapState


@pytest.fixture(scope="session")
def real_maps() -> list[MapState]:
    """The real logs' maps."""
    if not REAL_MAPS:
        pytest.skip(REAL_MAPS_MISSING)
    return [real_map(path) for path in REAL_MAPS]
