"""Bodies of questions: how long, how slow."""

import asyncio
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from starlette.testclient import TestClient

from arcless.studio.answers.answers import Refused
from arcless.studio.project import measured
from arcless.studio.server import app as app_module
from arcless.studio.server import bodies
from arcless.studio.server.bodies import LONGEST, limited

TOO_LONG, TOO_SLOW, BAD, OK = 413, 408, 400, 200


def test_a_text_of_the_limit_is_read_and_one_byte_more_is_not(client: TestClient) -> None:
    start, end = b'{"path": "a.yaml", "text": "', b'"}'
    room = LONGEST - len(start) - len(end)
    assert client.post("/api/form", content=start + b" " * room + end).status_code == OK
    longer = client.post("/api/form", content=start + b" " * (room + 1) + end)
    assert longer.status_code == TOO_LONG
    assert "4 MiB" in longer.json()["error"]["text"]


def test_a_length_that_is_not_announced_is_counted(client: TestClient) -> None:
    pieces = 0

    def endless() -> Iterator[bytes]:
        nonlocal pieces
        while pieces < 100:
            pieces += 1
            yield b" " * 2**20

    assert client.post("/api/check", content=endless()).status_code == TOO_LONG


def test_only_a_measured_run_may_be_longer(
    client: TestClient, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert app_module.LONGEST == {"/api/measured": measured.LONGEST}
    assert measured.LONGEST == 512 * 2**20
    content = b"x" * (LONGEST + 1)
    found = client.post("/api/measured", params={"name": "a.csv"}, content=content)
    assert found.status_code == OK
    assert (folder / "measured" / "a.csv").read_bytes() == content
    monkeypatch.setitem(app_module.LONGEST, "/api/measured", LONGEST)
    found = client.post("/api/measured", params={"name": "b.csv"}, content=content)
    assert found.status_code == TOO_LONG
    assert [one.name for one in (folder / "measured").iterdir()] == ["a.csv"]


def test_a_body_that_stops_is_not_waited_for(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(bodies, "NEXT_PIECE_S", 0.02)

    async def never() -> Any:
        await asyncio.sleep(60)

    async def read() -> None:
        await limited({"type": "http", "headers": []}, never, 100)()

    with pytest.raises(Refused) as refused:
        asyncio.run(read())
    assert refused.value.status == TOO_SLOW


@pytest.mark.parametrize("body", [
    b"", b"[]", b"1", b"null", b"{", b"\xff\xfe", b"[" * 200_000, b'{"a":' * 100_000,
    b"NaN", b'"\\ud800"', b"{}" * 2,
])  # fmt: skip
@pytest.mark.parametrize("path", ["check", "form", "patch", "new", "variant", "runs", "compare"])
def test_a_body_that_is_no_object(client: TestClient, path: str, body: bytes) -> None:
    found = client.post(f"/api/{path}", content=body)
    assert found.status_code == BAD
    assert found.json()["error"]["text"]
