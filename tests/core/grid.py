"""The procedural maps as a hypothesis strategy."""

from __future__ import annotations

from hypothesis import strategies as st
from tests.core.street_maps import random_map

from lanewright.core.elements import MapState


def maps() -> st.SearchStrategy[MapState]:
    """Random street maps; every choice is hypothesis' own, so failing ones shrink."""
    return st.randoms(use_true_random=False).map(random_map)
