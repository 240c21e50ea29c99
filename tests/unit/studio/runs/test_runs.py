"""Runs from the page: the same files as `arcless run`, refusals, reports, motion."""

import json
import shutil
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import httpx
import numpy as np
import pytest

import arcless
from arcless.model import load, parse_override
from arcless.studio.jobs.jobs import Jobs
from arcless.studio.project.project import Project
from arcless.studio.runs import routes as runs_routes
from arcless.studio.runs.motions import Motions
from arcless.studio.stream import routes as stream_routes
from arcless.studio.stream.hub import Hub
from tests.drills.conftest import QUICK, SHORT
from tests.support.served import PATIENCE_S, page, served

# As the page sends them: typed values, not texts of the command line.
CHANGES = dict(parse_override(f"{field}={text}") for field, text in QUICK.items())
# A wire so slack that it finds no rest.
FAILS, WHY = {"line.contact_wire.tension": "100 N"}, "no static equilibrium was found"


class Studio:
    def __init__(self, folder: Path, port: int) -> None:
        self.folder, self.port = folder, port
        self.client = httpx.Client(base_url=f"http://127.0.0.1:{port}/api", timeout=PATIENCE_S)

    def run(self, **asked: Any) -> httpx.Response:
        return self.client.post(
            "/runs", json={"scenario": "short.yaml", "changes": CHANGES, **asked}
        )

    def ended(self, answer: httpx.Response) -> dict[str, Any]:
        """Return a job that was begun when it has ended."""
        assert answer.status_code == 200, answer.text
        name = answer.json()["job"]["id"]
        deadline = time.monotonic() + PATIENCE_S
        while time.monotonic() < deadline:
            [job] = [one for one in self.client.get("/jobs").json() if one["id"] == name]
            if job["state"] in ("done", "failed", "cancelled"):
                found: dict[str, Any] = job
                return found
            time.sleep(0.05)
        raise AssertionError("it does not end")


@pytest.fixture(scope="module")
def studio(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Studio]:
    folder = tmp_path_factory.mktemp("project")
    shutil.copy(SHORT, folder / "short.yaml")
    with studio_of(folder) as found:
        yield found


def studio_of(folder: Path) -> Any:
    from contextlib import contextmanager

    @contextmanager
    def whole() -> Iterator[Studio]:
        project, hub = Project.of(folder), Hub()
        jobs = Jobs(hub.tell)
        motions = Motions(project, jobs)
        routes = [
            *runs_routes.routes(project, jobs),
            *stream_routes.routes(hub, motions.open, motions.compute),
        ]
        with served(routes, [hub.at_work(), jobs.at_work()]) as port:
            yield Studio(folder, port)

    return whole()


@pytest.fixture(scope="module")
def done(studio: Studio) -> dict[str, Any]:
    """Return the job of a run that is done."""
    return studio.ended(studio.run())


def test_a_run_is_that_of_the_command(studio: Studio, done: dict[str, Any]) -> None:
    assert done["state"] == "done", done
    folder = studio.folder / done["path"]
    assert sorted(one.name for one in folder.iterdir()) == [
        "assessment.json", "report.html", "result.nc",
    ]  # fmt: skip
    scenario = load(studio.folder / "short.yaml").with_(**CHANGES)
    own, other = arcless.open(folder), arcless.run(scenario)
    for name, values in other.dataset.data_vars.items():
        np.testing.assert_array_equal(own.dataset[name].values, values.values, err_msg=str(name))
    assert own.scenario.changes == scenario.changes
    assert own.metadata["command"].startswith("arcless run short.yaml --set")
    expected = other.assessment.to_dict()["pantographs"]
    assert json.loads((folder / "assessment.json").read_text())["pantographs"] == expected


def test_the_job_tells_the_verdict_and_warnings(studio: Studio, done: dict[str, Any]) -> None:
    assert done["outcome"]["verdict"] in ("met", "not met", "not judged")
    result = arcless.open(studio.folder / done["path"])
    assert done["notes"] == result.metadata["warnings"]
    assert done["outcome"]["name"] == "short"


def test_a_run_that_is_there_is_kept_unless_it_may_go(studio: Studio, done: dict[str, Any]) -> None:
    file = studio.folder / done["path"] / "result.nc"
    before = file.stat()
    refused = studio.run()
    assert refused.status_code == 409
    assert refused.json()["path"] == done["path"]
    assert file.stat() == before
    assert studio.ended(studio.run(replace=True))["state"] == "done"
    assert file.stat().st_ino != before.st_ino


@pytest.mark.parametrize(
    ("asked", "status", "words"),
    [
        ({"scenario": "none.yaml"}, 400, "none.yaml"),
        ({"scenario": "../short.yaml"}, 400, "no file of this folder"),
        ({"scenario": "/etc/passwd"}, 400, "no file of this folder"),
        ({"scenario": 5}, 400, "no order"),
        ({"scenario": "shipped:line/ac-simple-55"}, 400, "no scenario"),
        ({"changes": ["speed"]}, 400, "no order"),
        ({"changes": {"speed": "fast"}}, 400, "speed"),
        ({"changes": {"no.such": 1}}, 400, "no"),
    ],
)
def test_orders_that_are_refused(
    studio: Studio, asked: dict[str, Any], status: int, words: str
) -> None:
    answer = studio.run(**asked)
    assert answer.status_code == status, answer.text
    assert words in answer.json()["error"]["text"]


def test_a_run_that_fails_says_why_and_leaves_nothing(studio: Studio) -> None:
    answer = studio.run(changes={**CHANGES, **FAILS})
    job = studio.ended(answer)
    assert (job["state"], job["path"]) == ("failed", None)
    assert WHY in job["error"]["text"]
    assert not (studio.folder / answer.json()["job"]["path"]).exists()


def test_all_of_a_run(studio: Studio, done: dict[str, Any]) -> None:
    found = studio.client.get("/run", params={"path": done["path"]}).json()
    assert (found["path"], found["name"], found["report"]) == (done["path"], "short", True)
    assert found["changes"]["solver.time_step"] == "4 ms"
    assert found["assessment"]["pantographs"]
    assert "travel:" in found["scenario"]
    line = studio.client.get("/run/line", params={"path": done["path"]}).json()
    assert [wire["kind"] for wire in line["wires"]] == ["contact", "messenger"]


@pytest.mark.parametrize("path", ["../x", "runs", "none", "short.yaml", "", "runs/\0"])
def test_what_is_no_run(studio: Studio, done: dict[str, Any], path: str) -> None:
    for route in ("/run", "/run/line", "/run/report"):
        answer = studio.client.get(route, params={"path": path})
        assert answer.status_code in (400, 404), path
        assert answer.json()["error"]["text"]


def test_a_link_that_leads_out_is_no_run(
    studio: Studio, done: dict[str, Any], tmp_path: Path
) -> None:
    shutil.copytree(studio.folder / done["path"], tmp_path / "secret")
    inside = studio.folder / "runs" / "linked"
    inside.mkdir()
    (inside / "result.nc").symlink_to(tmp_path / "secret" / "result.nc")
    answer = studio.client.get("/run", params={"path": "runs/linked"})
    assert answer.status_code == 400
    assert "no file of this folder" in answer.json()["error"]["text"]


def test_a_report_runs_in_a_place_of_its_own(studio: Studio, done: dict[str, Any]) -> None:
    answer = studio.client.get("/run/report", params={"path": done["path"]})
    assert answer.text.rstrip().endswith("</html>")
    policy = answer.headers["content-security-policy"]
    assert "sandbox allow-scripts" in policy
    assert "allow-same-origin" not in policy
    assert "default-src 'none'" in policy


def test_a_report_on_paper(studio: Studio, done: dict[str, Any]) -> None:
    answer = studio.client.post("/run/report", json={"path": done["path"], "pdf": True})
    job = studio.ended(answer)
    assert job["state"] == "done", job
    assert (studio.folder / job["path"]).read_bytes().startswith(b"%PDF")


def test_a_run_is_watched_and_plays_on_when_it_is_done(studio: Studio) -> None:
    asked = {**CHANGES, "speed": "150 km/h"}
    with page(studio.port) as one:
        answer = studio.run(changes=asked)
        job = answer.json()["job"]
        about = one.play({"job": job["id"]})
        assert about["wires"]
        while not about["final"]:
            about = {"final": one.hear("edge")["final"]}
        live = pieces(one, {"job": job["id"]})
        assert studio.ended(answer)["state"] == "done"  # the report takes longer than the run
        assert one.play({"run": job["path"]})["wires"]
        assert pieces(one, {"run": job["path"]}) == live
        line = studio.client.get("/run/line", params={"job": job["id"]}).json()
        assert len(line["wires"][0]["x"]) == len(line["wires"][0]["z"])


def test_motion_of_a_stored_run_is_computed(studio: Studio, done: dict[str, Any]) -> None:
    """A second run has the same forces, and the motion of a run that records it."""
    name = studio.ended(studio.run(record_motion=True))["path"]
    with studio_of(studio.folder) as fresh, page(fresh.port) as one:  # no spools are there
        source = {"run": done["path"]}
        about = one.play(source)
        assert about["wires"] is False
        assert {each["name"] for each in about["channels"]} >= {"pantograph.0", "droppers"}
        one.tell("compute motion", source=source)
        assert one.hear("computing")["source"] == source
        about = one.hear("channels")
        assert (about["source"], about["wires"]) == (source, True)
        [job] = fresh.client.get("/jobs").json()
        assert (job["state"], job["outcome"], job["notes"]) == ("done", True, [])
        computed = pieces(one, source)
        one.play({"run": name})
        assert pieces(one, {"run": name}) == computed


def pieces(one: Any, source: dict[str, str]) -> list[tuple[str, bytes]]:
    """Return frames of a second, without the numbers of their channels."""
    assert one.want(source, 1.0, 2.0, 0.0)["dropped"] == 0
    return [(name, frame[4:]) for name, frame in one.frames]


def test_a_run_is_current_until_something_that_it_was_computed_from_changes(
    studio: Studio, done: dict[str, Any]
) -> None:
    def current(**asked: Any) -> Any:
        whole = {"run": done["path"], "scenario": "short.yaml", "changes": CHANGES, **asked}
        answer = studio.client.post("/run/current", json=whole)
        return answer.json().get("current", answer.status_code)

    assert current() is True
    assert current(changes={**CHANGES, "certainty": {"starts": 4}}) is True
    assert current(changes={**CHANGES, "speed": "151 km/h"}) is False
    assert current(run="none") == 404
    file = studio.folder / "short.yaml"
    text = file.read_text("utf-8")
    try:
        file.write_text(text.replace("name: short", "name: short  # kept"), "utf-8")
        assert current() is True
        file.write_text(text + "contact: {stiffness: 51 kN/m}\n", "utf-8")
        assert current() is False
    finally:
        file.write_text(text, "utf-8")
