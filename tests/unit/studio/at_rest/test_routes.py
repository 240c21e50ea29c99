"""The route of lines at rest, asked as the page asks it."""

import warnings
from collections.abc import AsyncIterator, Iterator
from contextlib import asynccontextmanager
from pathlib import Path
from typing import Any

import pytest
from starlette.applications import Starlette

import arcless
from arcless.studio.at_rest.routes import MOST_DESKS, Desks, routes
from arcless.studio.project.project import Project

with warnings.catch_warnings():
    # Starlette names another package for its client than the one that is there.
    warnings.simplefilter("ignore")
    from starlette.testclient import TestClient

LINE = Path(arcless.__file__).parent / "models" / "lines" / "conductor-rail-1.yaml"
QUESTION: dict[str, Any] = {
    "path": "line.yaml", "text": None, "changes": {}, "want": ["line"], "question": 3,
}  # fmt: skip


@pytest.fixture
def desks() -> Desks:
    return Desks()


@pytest.fixture
def client(desks: Desks, tmp_path: Path) -> Iterator[TestClient]:
    (tmp_path / "line.yaml").write_bytes(LINE.read_bytes())

    @asynccontextmanager
    async def over(_: Any) -> AsyncIterator[None]:
        async with desks.at_work():
            yield

    app = Starlette(routes=routes(Project.of(tmp_path), desks), lifespan=over)
    with TestClient(app) as client:
        yield client


def test_the_line_of_a_file_and_of_a_text(client: TestClient) -> None:
    found = client.post("/api/statics", json=QUESTION).json()
    assert (found["question"], found["errors"]) == (3, [])
    assert len(found["line"]["spans"]) > 1
    text = LINE.read_text("utf-8").replace("name: conductor-rail-1", "name: typed", 1)
    assert client.post("/api/statics", json=QUESTION | {"text": text}).json()["name"] == "typed"


def test_a_line_that_is_wrong_is_an_answer_and_a_question_that_is_none_is_refused(
    client: TestClient,
) -> None:
    wrong = client.post("/api/statics", json=QUESTION | {"text": "format: arcless-line/1\n"})
    assert wrong.status_code == 200
    assert wrong.json()["errors"][0]["text"]
    asked: Any
    for asked in ([], QUESTION | {"want": "all"}, QUESTION | {"path": "../line.yaml"}):
        refused = client.post("/api/statics", json=asked)
        assert refused.status_code == 400
        assert refused.json()["error"]["text"]


def test_a_reference_leads_nowhere_out_of_the_folder(client: TestClient, tmp_path: Path) -> None:
    (tmp_path.parent / "outside.yaml").write_bytes(LINE.read_bytes())
    text = "format: arcless-scenario/1\nname: a\nline: ../outside.yaml\nspeed: 100 km/h\n"
    text += "pantographs: [{model: dsa-380, static_force: 70 N}]\n"
    question = QUESTION | {"path": "scenario.yaml"}
    answer = client.post("/api/statics", json=question | {"text": text}).json()
    assert "outside of the folder" in answer["errors"][0]["text"]
    inside = text.replace("../outside.yaml", "line.yaml")
    assert "line" in client.post("/api/statics", json=question | {"text": inside}).json()


def test_pages_have_their_own_processes_up_to_a_number(client: TestClient, desks: Desks) -> None:
    names = [str(number) for number in range(MOST_DESKS + 1)]
    found = [desks.of(name) for name in names]
    assert desks.of(names[-1]) is found[-1]
    # The first one made room.
    assert desks.of(names[0]) is not found[0]
