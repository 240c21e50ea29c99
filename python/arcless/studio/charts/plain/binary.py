"""Numbers as bytes, with what they are as JSON in a header."""

import json
from typing import Any

from starlette.responses import Response

HEADER = "X-About"


def binary(content: bytes, about: dict[str, Any]) -> Response:
    """Return an answer of bytes; `about` stands in the header `X-About`, as ASCII."""
    headers = {HEADER: json.dumps(about, ensure_ascii=True, allow_nan=False)}
    return Response(content, media_type="application/octet-stream", headers=headers)
