"""Types of parts of addresses."""

from __future__ import annotations

from typing import Annotated

from fastapi import Path, Query

RowNumber = Annotated[int, Path(ge=1, le=2**63 - 1)]
Page = Annotated[int, Query(ge=1, le=100_000)]
PageSize = Annotated[int, Query(ge=1, le=200)]
