"""Handlers as routes: values, complaints, refusals, and what nobody expected."""

from collections.abc import Callable
from typing import Any

import pytest
from starlette.applications import Starlette
from starlette.requests import Request
from starlette.testclient import TestClient

from arcless.errors import ModelError
from arcless.studio.answers.answers import Refused, json_body, route


def asked(act: Callable[[], Any], body: bytes = b"{}") -> tuple[int, Any]:
    async def handler(request: Request) -> Any:
        await json_body(request)
        return act()

    answer = TestClient(Starlette(routes=[route("x", handler, "POST")])).post(
        "/api/x", content=body
    )
    return answer.status_code, answer.json()


def raising(error: Exception) -> Callable[[], Any]:
    def act() -> Any:
        raise error

    return act


def test_a_value() -> None:
    assert asked(lambda: {"σ": [1, None, "\ud800"]}) == (200, {"σ": [1, None, "\ud800"]})


def test_a_complaint() -> None:
    error = ModelError("wire: wrong", where="a.yaml:3", got="1", expected="2", hint="3",
                       field=("wires", 0))  # fmt: skip
    status, answer = asked(raising(error))
    assert status == 400
    assert answer["error"] == {
        "text": "a.yaml:3: wire: wrong: got 1, expected 2; hint: 3", "what": "wire: wrong",
        "where": "a.yaml:3", "got": "1", "expected": "2", "hint": "3", "field": ["wires", 0],
    }  # fmt: skip


def test_a_refusal() -> None:
    refusal = Refused(409, "changed", current=None)
    assert asked(raising(refusal)) == (409, {"error": {"text": "changed"}, "current": None})


@pytest.mark.parametrize(
    ("error", "told"),
    [(ValueError("spam"), "internal fault: ValueError: spam"), (MemoryError(), "not enough memory"),
     (OSError(28, "No space left on device"), "No space left on device")],
)  # fmt: skip
def test_a_fault_is_a_sentence(error: Exception, told: str) -> None:
    status, answer = asked(raising(error))
    assert status == 500
    assert answer["error"]["text"].startswith(told)
    assert "Traceback" not in answer["error"]["text"]


def test_no_number_is_a_fault() -> None:
    assert asked(lambda: float("nan"))[0] == 500


@pytest.mark.parametrize(
    "body", [b"", b"[]", b"1", b"{", b"\xff", b"[" * 100_000, b'{"a": ' * 50_000, b"9" * 10_000]
)
def test_what_is_no_question(body: bytes) -> None:
    status, answer = asked(lambda: 1, body)
    assert (status, answer["error"]["text"]) == (400, "The question is not a JSON object")
