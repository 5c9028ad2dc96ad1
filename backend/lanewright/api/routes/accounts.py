"""People."""

from __future__ import annotations

from fastapi import APIRouter

from lanewright.api.deps import AdminActor, ReviewingActor, SessionDep
from lanewright.api.schemas.accounts import AccountCreate, AccountOut, AccountPatch, PersonOut
from lanewright.api.schemas.path import RowNumber
from lanewright.api.strict_json import StrictRoute
from lanewright.services import accounts

router = APIRouter(prefix="/api/v1", tags=["accounts"], route_class=StrictRoute)


@router.get("/accounts", operation_id="list_accounts")
def list_accounts(_actor: AdminActor, session: SessionDep) -> list[AccountOut]:
    """All accounts by name, disabled ones too."""
    return [AccountOut.model_validate(account) for account in accounts.everybody(session)]


@router.post("/accounts", operation_id="create_account", status_code=201)
def create_account(body: AccountCreate, _actor: AdminActor, session: SessionDep) -> AccountOut:
    """Adds a person."""
    return AccountOut.model_validate(accounts.add(session, name=body.name, role=body.role, password=body.password))


@router.patch("/accounts/{account_id}", operation_id="change_account")
def change_account(account_id: RowNumber, body: AccountPatch, actor: AdminActor, session: SessionDep) -> AccountOut:
    """Changes role, password or standing. A disabled account loses its sessions and tokens at once."""
    changed = accounts.change(
        session, actor, account_id, role=body.role, disabled=body.disabled, password=body.password
    )
    return AccountOut.model_validate(changed)


@router.get("/people", operation_id="list_people")
def list_people(_actor: ReviewingActor, session: SessionDep) -> list[PersonOut]:
    """Names for filters and assignment; disabled accounts are left out."""
    return [PersonOut.model_validate(account) for account in accounts.everybody(session) if account.disabled_at is None]
