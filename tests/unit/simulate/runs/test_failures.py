"""Failures speak the words of the line, and leave a file with which they can be replayed."""

import json
import pickle
import re
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

import arcless
from arcless import _core
from arcless.equilibrium import equilibrium
from arcless.errors import ContactError, EquilibriumError
from arcless.model import Scenario
from arcless.simulate.runs import failures
from arcless.simulate.setup.trajectory import Motion
from arcless.studio.answers.answers import complaint

Short = Callable[..., Scenario]


@pytest.fixture(autouse=True)
def temporary(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Send the files of failures into the test's own folder."""
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    return tmp_path


@pytest.fixture
def pushing(short: Short) -> Scenario:
    """A pre-sag that asks one dropper to hold the wire down."""
    presag = [0.0, 0.0, 0.08, 0.0, 0.0]
    return short(**{"line.span_types.span.droppers.presag": presag})


def test_a_dropper_that_would_push_is_named(pushing: Scenario) -> None:
    with pytest.raises(EquilibriumError) as caught:
        arcless.statics(pushing)
    text = str(caught.value)
    assert re.search(r"span \d dropper [1-5] would have to push", text)
    assert re.search(r"\d+\.\d\d m: .*got a force of -\d+\.\d N, expected a tension", text)
    assert "pre-sag" in text


def test_a_static_failure_leaves_no_file(pushing: Scenario, temporary: Path) -> None:
    with pytest.raises(EquilibriumError) as caught:
        arcless.run(pushing)
    assert "replay" not in str(caught.value)
    assert list(temporary.iterdir()) == []


def test_a_tension_that_carries_nothing_is_no_nan(short: Short) -> None:
    with pytest.raises(EquilibriumError) as caught:
        arcless.statics(short(**{"line.contact_wire.tension": 22.0}))
    assert "nan" not in str(caught.value)
    assert "inf N" not in str(caught.value)


def placed(name: str) -> list[Any]:
    """Return placements of which only the name is asked for."""
    return [SimpleNamespace(name=name)]


@pytest.mark.parametrize(
    ("kind", "details", "words"),
    [
        (
            "equilibrium",
            {"node": 0, "residual": 12.3, "iterations": 100, "tolerance": 1e-6},
            "no static equilibrium was found: got 12.3 N out of balance after 100 iterations",
        ),
        ("singular", {"node": 0}, "the line is loose"),
        ("another", {}, "as the core says"),
    ],
)
def test_statics_errors_in_words(short: Short, kind: str, details: dict, words: str) -> None:
    found = equilibrium.find(short())
    message = "as the core says"
    with pytest.raises(EquilibriumError, match=words) as caught, equilibrium.named(found.mesh):
        raise _core.NativeError(kind, message, details)
    if details:
        assert re.match(r"(contact|messenger) wire at 0\.00 m: ", str(caught.value))


@pytest.mark.parametrize(
    ("kind", "details", "words"),
    [
        (
            "off_wire",
            {"pantograph": 0, "step": 7, "position": 301.25},
            "front left the wire",
        ),
        (
            "out_of_reach",
            {"pantograph": 0, "step": 7, "position": 301.25, "lateral": -0.41, "half_width": 0.4},
            r"301.25 m, step 7: the contact wire leaves the collector of pantograph front "
            r"sideways: got 0.410 m off the middle, expected at most the half width of the "
            r"collector, 0.400 m",
        ),
        ("slack_set", {"step": 7, "time": 0.014}, "step 7, t = 0.014 s: the set of"),
        ("folded", {"step": 7}, "step 7: the motion grew beyond all bounds: the contact wire"),
        ("not_finite", {"step": 7}, "step 7: the motion grew beyond all bounds"),
    ],
)
def test_stepping_errors_in_words(kind: str, details: dict, words: str) -> None:
    mesh = SimpleNamespace(droppers=[])
    with pytest.raises(ContactError, match=words), failures.stepping(mesh, placed("front")):
        raise _core.NativeError(kind, "", details)


def test_a_step_that_fails_says_where_the_pantographs_are(short: Short) -> None:
    mesh = SimpleNamespace(droppers=[])
    placements: list[Any] = [
        SimpleNamespace(name="front", distance=0.0), SimpleNamespace(name="rear", distance=35.0)
    ]  # fmt: skip
    travel = Motion(np.linspace(100.0, 200.0, 101), np.full(101, 50.0), 0.02)
    with pytest.raises(ContactError) as caught, failures.stepping(mesh, placements, travel):
        raise _core.NativeError("not_finite", "", {"step": 12})
    error = caught.value
    where = "step 12, t = 0.24 s, front at 112.00 m, rear at 77.00 m"
    assert str(error).startswith(f"{where}: the motion grew beyond all bounds")
    assert error.time_s == pytest.approx(12 * 0.02, abs=1e-15)  # rounding
    assert error.positions_m == {"front": 112.0, "rear": 77.0}
    # It crosses from the process that stepped to the one that tells it.
    assert pickle.loads(pickle.dumps(error)).positions_m == error.positions_m
    told = complaint(error)
    assert (told["time_s"], told["positions_m"]) == (error.time_s, error.positions_m)
    # A step is counted from its start or its end; its time decides.
    with pytest.raises(ContactError) as caught, failures.stepping(mesh, placements, travel):
        raise _core.NativeError("slack_set", "", {"step": 12, "time": 13 * 0.02})
    assert caught.value.positions_m["front"] == 113.0
    with pytest.raises(ContactError) as caught, failures.stepping(mesh, placements, travel):
        raise _core.NativeError("off_wire", "", {"pantograph": 1, "step": 101, "position": 165.0})
    assert str(caught.value).startswith("step 101: pantograph rear left the wire: got 165.00 m")
    assert caught.value.positions_m["rear"] == 165.0


def test_statics_of_a_run_fail_in_the_same_words(short: Short) -> None:
    mesh = equilibrium.find(short()).mesh
    with (
        pytest.raises(EquilibriumError, match="the line is loose"),
        failures.stepping(mesh, placed("P1")),
    ):
        raise _core.NativeError("singular", "", {"node": 0})


def test_an_unsolved_problem_names_its_links_and_is_saved(short: Short, temporary: Path) -> None:
    mesh = equilibrium.find(short()).mesh
    details = {
        "step": 12,
        "time": 0.024,
        "contacts": [[0, 0, 0]],
        "links": [3],
        "stops": [1],
        "h": [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0],
        "w": [-1.0, -2.0, 0.5],
        "reason": "it cycles",
    }
    with pytest.raises(ContactError) as caught, failures.stepping(mesh, placed("front")):
        raise _core.NativeError("lcp", "", details)
    text = str(caught.value)
    assert "step 12, t = 0.024 s, pantograph front, span 1 dropper 4" in text
    assert "it cycles" in text
    (path,) = temporary.glob("arcless-lcp-*.json")
    saved = json.loads(path.read_text(encoding="utf-8"))
    assert saved["links"] == [
        "pantograph front",
        "span 1 dropper 4",
        "stop or kink 1 of pantograph front",
    ]
    assert (saved["H"], saved["w"]) == (details["h"], details["w"])
    assert str(path) in text


def test_contacts_of_one_pantograph_are_told_apart() -> None:
    names = ["front", "rear"]
    assert failures._contacts([[0, 0, 0], [1, 0, 0]], names) == [
        "pantograph front",
        "pantograph rear",
    ]
    assert failures._contacts([[1, 0, 0], [1, 1, 0]], names) == [
        "pantograph rear strip 1 wire 1",
        "pantograph rear strip 2 wire 1",
    ]


def test_a_mean_force_that_cannot_be_reached(short: Short, monkeypatch: pytest.MonkeyPatch) -> None:
    # With a mean that never follows, the search must end and say so.
    monkeypatch.setattr("arcless.simulate.runs.mean_force._means", lambda *_: np.array([50.0]))
    with pytest.raises(ContactError, match=r"pantographs\.0\.mean_force.*P1 was not reached"):
        arcless.run(short(**{"pantographs.0.mean_force": 80.0}))


def test_a_mean_force_below_the_lift_is_told_why(short: Short) -> None:
    lift = {"speed": [0.0, 100.0], "force": [200.0, 200.0]}
    change = {
        "pantographs.0.mean_force": 40.0,
        "pantographs.0.static_force": None,
        "pantographs.0.model.masses.0.lift": lift,
    }
    with pytest.raises(ContactError, match="with a static force of") as caught:
        arcless.run(short(**change))
    assert "lift and base spring give more than that by themselves" in str(caught.value)
