"""One's own API tokens."""

from __future__ import annotations

from fastapi import APIRouter

from lanewright.api.deps import AnyActor, SessionDep
from lanewright.api.schemas.accounts import TokenCreate, TokenCreated, TokenOut
from lanewright.api.schemas.path import RowNumber
from lanewright.api.strict_json import StrictRoute
from lanewright.services import tokens

router = APIRouter(prefix="/api/v1/tokens", tags=["tokens"], route_class=StrictRoute)


@router.get("", operation_id="list_tokens")
def list_tokens(actor: AnyActor, session: SessionDep) -> list[TokenOut]:
    """One's own tokens, expired and revoked ones too."""
    return [TokenOut.model_validate(token) for token in tokens.of_actor(session, actor)]


@router.post("", operation_id="create_token", status_code=201)
def create_token(body: TokenCreate, actor: AnyActor, session: SessionDep) -> TokenCreated:
    """A new token. It is shown in this answer and never again."""
    token, secret = tokens.create(session, actor, name=body.name, scopes=body.scopes, days=body.days)
    return TokenCreated(**TokenOut.model_validate(token).model_dump(), token=secret)


@router.delete("/{token_id}", operation_id="revoke_token", status_code=204)
def revoke_token(token_id: RowNumber, actor: AnyActor, session: SessionDep) -> None:
    """Ends a token at once."""
    tokens.revoke(session, actor, token_id)
