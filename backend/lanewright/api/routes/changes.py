"""The atomic changes of all tasks, for pipelines."""

from __future__ import annotations

from fastapi import APIRouter

from lanewright.api.deps import ChangesReader, SessionDep
from lanewright.api.schemas.path import Page, PageSize
from lanewright.api.schemas.revisions import ChangePage, ChangeRow
from lanewright.api.strict_json import StrictRoute
from lanewright.core.changes import Category
from lanewright.db.repositories.changes import find_changes

router = APIRouter(prefix="/api/v1/changes", tags=["dataset"], route_class=StrictRoute)


@router.get("", operation_id="query_changes")
def query_changes(
    _actor: ChangesReader,
    session: SessionDep,
    category: Category | None = None,
    city: str | None = None,
    split: str | None = None,
    accepted: bool = False,
    page: Page = 1,
    page_size: PageSize = 50,
) -> ChangePage:
    """Changes as the edits made, by category, city and split, at every task's head or, ``accepted``, as accepted.

    Needs a token with the scope changes:read, or a reviewer's or admin's session.
    """
    found, total = find_changes(
        session,
        category=category,
        city=city,
        split=split,
        accepted=accepted,
        offset=(page - 1) * page_size,
        limit=page_size,
    )
    items = [ChangeRow.model_validate(row) for row in found]
    return ChangePage(items=items, total=total, page=page, page_size=page_size)
