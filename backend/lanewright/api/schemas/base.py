"""Rules that all wire types share."""

from __future__ import annotations

from typing import Annotated, Any

from pydantic import AllowInfNan, BaseModel, ConfigDict, Field, Strict, StringConstraints

Metres = Annotated[float, Strict(), AllowInfNan(False), Field(ge=-1e6, le=1e6)]
"""A coordinate in the city frame; booleans and strings are refused."""
Identifier = Annotated[int, Strict(), Field(ge=0, le=2**53 - 1)]
"""An element id; JavaScript counts exactly up to its limit."""
RowId = Annotated[int, Strict(), Field(ge=1, le=2**63 - 1)]
RevisionNumber = Annotated[int, Strict(), Field(ge=0, le=2**31 - 2)]
Text = Annotated[str, StringConstraints(strip_whitespace=True, max_length=4000, pattern=r"^[^\u0000]*$")]


class Incoming(BaseModel):
    """A request body: unknown keys are refused, types are not coerced."""

    model_config = ConfigDict(extra="forbid", strict=True, ser_json_inf_nan="null")


class Outgoing(BaseModel):
    """A response body."""

    model_config = ConfigDict(from_attributes=True)


class Problem(Outgoing):
    """Every error's body. ``message`` says what is wrong and where, ``mend`` what to do; show both to the user."""

    code: str
    message: str
    mend: str = ""
    facts: dict[str, Any] = Field(default_factory=dict)
    request_id: str = ""
