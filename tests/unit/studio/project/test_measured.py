"""Measured runs that are dropped onto the page."""

import asyncio
from collections.abc import AsyncIterator
from pathlib import Path

import pytest
from starlette.testclient import TestClient

from arcless.errors import OutputError
from arcless.studio.project import measured
from arcless.studio.project.project import Project

CONTENT = b"time;force\n0;100\n"
OK, BAD = 200, 400


def test_a_file_is_kept_and_seen(client: TestClient, folder: Path) -> None:
    with client:
        found = client.post("/api/measured", params={"name": "run 1.csv"}, content=CONTENT)
        assert found.json() == {"path": "measured/run 1.csv"}
        assert (folder / "measured" / "run 1.csv").read_bytes() == CONTENT
        seen = client.get("/api/project").json()["measured"]
    assert seen in ([], [{"path": "measured/run 1.csv", "bytes": len(CONTENT)}])


def test_a_name_that_is_taken_gets_a_number(client: TestClient, folder: Path) -> None:
    paths = [
        client.post("/api/measured", params={"name": "a.csv"}, content=bytes([48 + number]))
        .json()["path"]
        for number in range(3)
    ]  # fmt: skip
    assert paths == ["measured/a.csv", "measured/a (2).csv", "measured/a (3).csv"]
    assert (folder / paths[0]).read_bytes() == b"0"


@pytest.mark.parametrize("name", [
    "", "a", "a.txt", "a.csv.exe", "../a.csv", "b/a.csv", ".a.csv", "a\0.csv", "b\\a.csv", "é.csv",
    "a\n.csv", "x" * 200 + ".csv",
])  # fmt: skip
def test_names_that_are_none(client: TestClient, folder: Path, name: str) -> None:
    assert client.post("/api/measured", params={"name": name}, content=b"x").status_code == BAD
    assert list(folder.iterdir()) == []


def test_what_ends_early_leaves_nothing(folder: Path) -> None:
    async def pieces() -> AsyncIterator[bytes]:
        yield CONTENT
        raise ConnectionError

    with pytest.raises((ConnectionError, OutputError)):
        asyncio.run(measured.keep(Project.of(folder), "a.csv", pieces()))
    assert list((folder / "measured").iterdir()) == []
