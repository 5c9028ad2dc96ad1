"""Large answers that are built as JSON documents: sent as they are, without a detour through models.

Their models still describe them in OpenAPI, and tests hold the two together.
"""

from __future__ import annotations

from typing import Any

import orjson
from fastapi import Response


def document_response(document: Any, status_code: int = 200) -> Response:
    """The document as the body of an answer; parts that are JSON already come as ``orjson.Fragment``."""
    return json_response(orjson.dumps(document), status_code)


def json_response(body: bytes, status_code: int = 200) -> Response:
    """A body that is JSON already, byte for byte."""
    return Response(body, status_code=status_code, media_type="application/json")
