"""Routes as plain functions: their values become JSON, their errors complaints."""

import json
from collections.abc import Awaitable, Callable
from dataclasses import asdict, is_dataclass
from typing import Any

from starlette.requests import Request
from starlette.responses import JSONResponse, Response
from starlette.routing import Route

from arcless.errors import ArclessError

Handler = Callable[[Request], Awaitable[Any]]


class Refused(Exception):  # noqa: N818 - an answer, not a failure
    """A refusal with a status of its own, and what else the answer holds."""

    def __init__(self, status: int, text: str, **more: Any) -> None:
        super().__init__(text)
        self.status, self.more = status, more


def route(path: str, handler: Handler, method: str = "GET") -> Route:
    """Return the route of a handler; it answers a value, which becomes JSON, or a response."""

    async def endpoint(request: Request) -> Response:
        try:
            value = await handler(request)
        except ArclessError as error:
            return JSONResponse({"error": complaint(error)}, status_code=400)
        except Refused as refusal:
            answer = {"error": {"text": str(refusal)}, **refusal.more}
            return JSONResponse(answer, status_code=refusal.status)
        return value if isinstance(value, Response) else JSONResponse(plain_value(value))

    return Route(f"/api/{path}", endpoint, methods=[method])


def complaint(error: ArclessError) -> dict[str, Any]:
    """Return an error as the page shows it: its whole sentence, and its parts where it has them."""
    parts = ("what", "where", "got", "expected", "hint", "field")
    found = {name: getattr(error, name, None) for name in parts}
    return {"text": str(error), **{name: value for name, value in found.items() if value}}


def plain_value(value: Any) -> Any:
    """Return plain values, ready for JSON."""
    return asdict(value) if is_dataclass(value) and not isinstance(value, type) else value


async def json_body(request: Request) -> dict[str, Any]:
    """Return the JSON object that was sent.

    Raises
    ------
    Refused
        It is none.
    """
    try:
        body = json.loads(await request.body())
    except (ValueError, RecursionError):
        body = None
    if not isinstance(body, dict):
        raise Refused(400, "The question is not a JSON object")
    return body
