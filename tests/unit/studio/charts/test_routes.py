"""Answers of the routes of charts: to right questions, and to wrong ones."""

import json
import warnings
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from starlette.applications import Starlette

from arcless.dataset.netcdf.store import save
from arcless.results import open as open_result
from arcless.studio.charts.routes import routes
from arcless.studio.project.project import Project
from tests.support.synthetic import synthetic_dataset

with warnings.catch_warnings():
    # Starlette names another package for its client than the one that is there.
    warnings.simplefilter("ignore")
    from starlette.testclient import TestClient


def wave(t: np.ndarray) -> np.ndarray:
    return 100.0 + 20.0 * np.sin(2.0 * np.pi * 0.4 * t) + 5.0 * np.sin(2.0 * np.pi * 1.7 * t)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    found = tmp_path_factory.mktemp("project")
    for name, factor in (("a", 1.0), ("b", 1.1)):
        place = found / "runs" / name
        place.mkdir(parents=True)
        save(synthetic_dataset(force=lambda t, k=factor: k * wave(t)), place / "result.nc")
    return found


@pytest.fixture(scope="module")
def client(folder: Path) -> Iterator[TestClient]:
    yield TestClient(Starlette(routes=routes(Project.of(folder))))


def test_series_have_the_extremes_of_the_record(client: TestClient) -> None:
    found = client.get(
        "/api/series", params={"run": "runs/a", "name": "contact_force", "points": 200}
    )
    about = json.loads(found.headers["X-About"])
    x, low, high = np.frombuffer(found.content, "<f4").reshape(3, about["count"])
    force = wave(np.arange(about["samples"]) * 1e-3)
    assert about["count"] <= 100
    # Singles: a part in 2²⁴.
    assert high.max() == pytest.approx(force.max(), rel=1e-6)
    assert low.min() == pytest.approx(force.min(), rel=1e-6)
    assert np.all(np.diff(x) > 0)
    assert about["unit"] == "N"


def test_the_filtered_force_is_that_of_the_assessment(client: TestClient, folder: Path) -> None:
    asked = {"run": "runs/a", "name": "filtered_contact_force", "x": "time", "from": 1, "to": 1.05}
    rows = np.frombuffer(client.get("/api/series", params=asked).content, "<f4").reshape(3, -1)
    at = slice(999, 999 + rows.shape[1])
    expected = open_result(folder / "runs" / "a").filtered_force().values[at, 0]
    # Singles of some hundred newtons.
    np.testing.assert_allclose(rows[1], expected, atol=1e-3)
    np.testing.assert_allclose(rows[2], expected, atol=1e-3)


def test_series_over_time(client: TestClient) -> None:
    asked = {"run": "runs/a", "name": "contact_force", "x": "time", "from": 1.0, "to": 1.05}
    found = client.get("/api/series", params=asked)
    about = json.loads(found.headers["X-About"])
    x = np.frombuffer(found.content, "<f4").reshape(3, -1)[0]
    np.testing.assert_allclose(x, 1.0 + 1e-3 * np.arange(-1, 52), rtol=1e-6)
    assert about["to"] == pytest.approx(30.0)


def test_each_head_of_a_figure_has_its_figure(client: TestClient) -> None:
    told = client.get("/api/figures", params={"run": "runs/a"}).json()
    keys = [head["key"] for part in told["sections"] for row in part["rows"] for head in row]
    assert "force-1" in keys
    assert "by-span-1" in keys
    assert len(keys) == len(set(keys))
    for key in keys:
        answer = client.get("/api/figure", params={"run": "runs/a", "key": key})
        assert answer.status_code == 200
        assert answer.json()["layers"]


def test_a_run_is_told_in_the_words_of_its_report(client: TestClient) -> None:
    told = client.get("/api/assessed", params={"run": "runs/a"}).json()
    assert told["verdict"]["text"]
    marks = {one["mark"] for one in told["criteria"]}
    assert marks <= told["marks"].keys()
    assert all(one["source"] for one in told["criteria"] if one["title"])
    assert told["report"] is False


def test_shares_of_an_explanation_add_up_and_places_have_their_time(client: TestClient) -> None:
    told = client.get("/api/explain", params={"run": "runs/a"}).json()
    (pantograph,) = told["pantographs"]
    assert sum(one["share_percent"] for one in pantograph["groups"]) == pytest.approx(
        100.0, abs=1e-6
    )
    for place in pantograph["worst"]:
        # 20 m/s from 0 m; places lie between samples, 0.02 m apart.
        assert place["time_s"] == pytest.approx(place["position_m"] / 20.0, abs=1e-3)


def test_a_comparison_tells_what_differs_and_draws_it(client: TestClient) -> None:
    subjects = ["runs/a", "runs/b"]
    told = client.post("/api/compare", json={"subjects": subjects}).json()
    assert len(told["names"]) == len(told["colours"]) == 2
    mean = next(one for one in told["main"] if one["label"].startswith("mean"))
    assert mean["cells"][1][1].startswith("+10.0")
    heads = [head for part in told["sections"] for row in part["rows"] for head in row]
    for head in heads:
        body = {"subjects": subjects, "figure": head["key"], "points": 100}
        figure = client.post("/api/compare", json=body).json()
        assert figure["title"] == head["title"]
    force = client.post("/api/compare", json={"subjects": subjects, "figure": "force-1"}).json()
    names = {one["name"] for one in force["layers"] if one["kind"] == "curve"}
    assert names == set(told["names"])


def test_a_run_without_motion_says_so(client: TestClient) -> None:
    found = client.get("/api/space_time", params={"run": "runs/a"})
    assert found.status_code == 200
    assert json.loads(found.headers["X-About"]) == {"recorded": False}


def test_channels_as_a_file(client: TestClient) -> None:
    found = client.get("/api/export", params={"run": "runs/a", "as": "csv"})
    assert found.headers["Content-Disposition"] == 'attachment; filename="synthetic.csv"'
    assert found.text.count("\n") > 30_000


@pytest.mark.parametrize(
    ("path", "asked", "said"),
    [
        ("figure", {"run": "runs/a", "key": "none"}, "no such figure"),
        ("figure", {"run": "runs/a", "key": "force-1", "points": "9e99"}, "whole number"),
        ("figure", {"run": "runs/a", "key": "force-1", "from": "nan"}, "no number"),
        ("figures", {"run": "../a"}, "no file of this folder"),
        ("figures", {"run": "runs"}, "no run in this folder"),
        ("figures", {"run": "runs/c"}, "no such run"),
        ("figures", {}, "no file of this folder"),
        ("series", {"run": "runs/a", "name": "support_x"}, "no series"),
        ("series", {"run": "runs/a", "name": "contact_force", "column": 7}, "no such column"),
        ("space_time", {"run": "runs/link"}, "no file of this folder"),
        ("export", {"run": "runs/a", "as": "exe"}, "none of csv"),
    ],
)
def test_wrong_questions_are_told_what_is_expected(
    client: TestClient, folder: Path, path: str, asked: dict, said: str
) -> None:
    link = folder / "runs" / "link"
    link.mkdir(exist_ok=True)
    if not (link / "result.nc").is_symlink():
        (link / "result.nc").symlink_to("/etc/hostname")
    found = client.get(f"/api/{path}", params=asked)
    assert found.status_code == 400
    assert said in found.json()["error"]["text"]


@pytest.mark.parametrize(
    ("body", "status", "said"),
    [
        ({}, 400, "not a list"),
        ({"subjects": [1, 2]}, 400, "not a list"),
        ({"subjects": ["runs/a"]}, 400, "at least two"),
        ({"subjects": ["runs/a", "runs/a"]}, 400, "twice"),
        ({"subjects": ["runs/a", "measured/x.csv"]}, 404, "no measured/x.csv"),
        ({"subjects": ["runs/a", "../x.csv"]}, 400, "no file of this folder"),
        ({"subjects": ["runs/a"] * 9}, 400, "9 are ticked"),
    ],
)
def test_wrong_comparisons(client: TestClient, body: dict, status: int, said: str) -> None:
    found = client.post("/api/compare", json=body)
    assert found.status_code == status
    assert said in found.json()["error"]["text"]


def test_a_run_that_was_computed_anew_is_read_anew(client: TestClient, folder: Path) -> None:
    place = folder / "runs" / "c"
    place.mkdir()
    save(synthetic_dataset(), place / "result.nc")
    before = client.get("/api/assessed", params={"run": "runs/c"}).json()
    save(synthetic_dataset(force=lambda t: np.full_like(t, 150.0)), place / "result.nc")
    after = client.get("/api/assessed", params={"run": "runs/c"}).json()
    assert before["numbers"][0][0][2] == ["100.0"]
    assert after["numbers"][0][0][2] == ["150.0"]


def test_a_comparison_has_the_names_of_the_page_and_says_what_changed(client: TestClient) -> None:
    body = {"subjects": ["runs/a", "runs/b"], "names": ["as in the file", "force +10 %"]}
    told = client.post("/api/compare", json=body).json()
    assert told["names"] == body["names"]
    (sentence,) = told["changes"]
    # The force of the second run is that of the first times 1.1.
    assert sentence.startswith("force +10 %, compared with as in the file: worse: standard dev")
    assert "no change beyond the ± or the rounding: contact loss" in sentence
    assert told["placed_on"] is None
    turned = {"subjects": body["subjects"][::-1], "names": body["names"][::-1]}
    (other,) = client.post("/api/compare", json=turned).json()["changes"]
    assert other.startswith("as in the file, compared with force +10 %: better: standard dev")
    for names in (["x", "x"], ["x"], ["x", ""], "xy", [1, 2]):
        assert client.post("/api/compare", json={**body, "names": names}).status_code == 400


def sensors(times: np.ndarray) -> str:
    """A record of sensors below a head of 5 kg, which swings at 3 Hz by 0.4 m/s²."""
    a = 0.4 * np.sin(2.0 * np.pi * 3.0 * times)
    rows = zip(times, wave(times) + 5.0 * a, a, strict=True)
    return "time [s],sensor_force [N],acceleration [m/s2]\n" + "\n".join(
        ",".join(f"{one:.6f}" for one in row) for row in rows
    )


def test_a_measurement_is_read_as_the_page_says(client: TestClient, folder: Path) -> None:
    path, file = "measured/sensors.csv", folder / "measured" / "sensors.csv"
    file.parent.mkdir(exist_ok=True)
    file.write_text(sensors(np.arange(0.0, 30.0, 0.002)))

    def ask(**given: str) -> dict:
        found = client.post("/api/measurement", json={"path": path, "as": given})
        assert found.status_code == 200
        return found.json()

    assert "speed" in ask()["refused"]["text"]
    plain, corrected = ask(speed="72 km/h"), ask(speed="72 km/h", head_mass="5 kg")
    sigma = [
        float(next(row[2][0] for row in told["numbers"] if row[0].startswith("standard deviation")))
        for told in (plain, corrected)
    ]
    # √(20² + 5²)/√2 N of the wave; (5 kg · 0.4 m/s²)²/2 of the head beside it; numbers to 0.1 N.
    assert sigma[1] == pytest.approx(np.sqrt(425.0 / 2.0), abs=0.15)
    assert sigma[0] == pytest.approx(np.sqrt(429.0 / 2.0), abs=0.15)
    assert {one["verdict"] for one in plain["criteria"]} == {"not judged"}
    assert "DC 3 kV" in plain["supplies"]
    for wrong in ({"head_lift": "8 N"}, {"head_mass": "5 N"}, {"head_mass": "0 kg"},
                  {"supply": "DC 9 kV"}, {"speed": "9 kg"}):  # fmt: skip
        assert "refused" in ask(**{"speed": "72 km/h", **wrong})
    for bad in ({"mass": "5 kg"}, {"speed": 5}, {"speed": "5" * 200}, [1]):
        found = client.post("/api/measurement", json={"path": path, "as": bad})
        assert found.status_code == 400


def test_a_comparison_takes_the_mass_of_the_head(client: TestClient, folder: Path) -> None:
    file = folder / "measured" / "heads.csv"
    file.parent.mkdir(exist_ok=True)
    file.write_text(sensors(np.arange(0.0, 30.0, 0.002)))
    subjects = ["runs/a", "measured/heads.csv"]
    given = {"measured/heads.csv": {"speed": "72 km/h", "head_mass": "5 kg"}}
    body = {"subjects": subjects, "names": ["run", "line test"], "measured": given}
    told = client.post("/api/compare", json=body).json()
    assert told["placed_on"] == "run"
    sigma = next(one for one in told["main"] if one["label"].startswith("standard deviation"))
    first, second = (float(one[0]) for one in sigma["cells"])
    # The same force: what is left is where the section ends.
    assert second == pytest.approx(first, rel=0.02)
    assert told["changes"] == []
    refused = client.post("/api/compare", json={**body, "measured": [1]})
    assert refused.status_code == 400


def test_a_run_that_is_too_short_is_not_explained_and_says_why(
    client: TestClient, folder: Path
) -> None:
    place = folder / "runs" / "constant"
    place.mkdir()
    save(synthetic_dataset(force=lambda t: np.full_like(t, 150.0)), place / "result.nc")
    found = client.get("/api/explain", params={"run": "runs/constant"})
    assert found.status_code == 200
    assert found.json()["pantographs"] == []
    assert found.json()["refused"]["text"]
