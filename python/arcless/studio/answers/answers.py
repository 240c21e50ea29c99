"""Routes as plain functions: their values become JSON, their errors complaints."""

import json
import os
from collections.abc import Awaitable, Callable
from dataclasses import asdict, is_dataclass
from typing import Any

from starlette.requests import ClientDisconnect, Request
from starlette.responses import JSONResponse, Response
from starlette.routing import Route

from arcless.errors import ArclessError
from arcless.studio.answers.page_words import in_page_words

_BAD_REQUEST, _FAULT = 400, 500
Handler = Callable[[Request], Awaitable[Any]]


class Json(JSONResponse):
    """An answer in JSON; half a character in a text from anywhere stays an escape."""

    def render(self, content: Any) -> bytes:
        """Return the bytes; a NaN is a fault of ours and raises."""
        return json.dumps(content, allow_nan=False, separators=(",", ":")).encode()


class Refused(Exception):  # noqa: N818 - an answer, not a failure
    """A refusal with a status of its own, and what else the answer holds."""

    def __init__(self, status: int, text: str, **more: Any) -> None:
        super().__init__(text)
        self.status, self.more = status, more


def route(path: str, handler: Handler, method: str = "GET") -> Route:
    """Return the route of a handler; it answers a value, which becomes JSON, or a response."""

    async def endpoint(request: Request) -> Response:
        try:
            return _answer(await handler(request))
        except ArclessError as error:
            return Json({"error": complaint(error)}, status_code=_BAD_REQUEST)
        except Refused as refusal:
            answer = {"error": {"text": str(refusal)}, **refusal.more}
            return Json(answer, status_code=refusal.status)
        except ClientDisconnect:  # nobody waits for the answer
            return Response(status_code=_BAD_REQUEST)
        except Exception as error:
            if os.environ.get("ARCLESS_TRACEBACK"):
                raise
            return Json({"error": {"text": _fault(error)}}, status_code=_FAULT)

    return Route(f"/api/{path}", endpoint, methods=[method])


def _answer(value: Any) -> Response:
    return value if isinstance(value, Response) else Json(plain_value(value))


def _fault(error: Exception) -> str:
    """Say what went wrong where nobody expected it, as the command line does."""
    match error:
        case MemoryError():
            return "not enough memory"
        case OSError():
            return error.strerror or str(error)
    hint = "set ARCLESS_TRACEBACK=1 to see where, and please report it"
    return f"internal fault: {type(error).__name__}: {error}; hint: {hint}"


def complaint(error: ArclessError | Refused) -> dict[str, Any]:
    """Return an error as the page shows it: its whole sentence, and its parts where it has them.

    Of a step also the time in s and the positions of the pantographs in m, by name.
    """
    parts = ("what", "where", "got", "expected", "hint", "field", "time_s")
    found = {name: getattr(error, name, None) for name in parts}
    found["positions_m"] = dict(getattr(error, "positions_m", {}))
    if found["hint"]:
        hint = in_page_words(f"; hint: {found['hint']}").removeprefix("; hint: ")
        found["hint"] = hint or None
    if found["expected"]:
        found["expected"] = in_page_words(found["expected"])
    text = in_page_words(str(error))
    return {"text": text, **{name: value for name, value in found.items() if value}}


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
        raise Refused(_BAD_REQUEST, "The question is not a JSON object")
    return body
