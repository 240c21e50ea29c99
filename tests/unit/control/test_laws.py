"""Laws: closed forms, files, and the controller of a run."""

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import arcless
from arcless import ControlError, ModelError, control
from arcless.control.laws import FORCE_N
from arcless.errors import ResultFormatError
from arcless.model import Scenario
from tests.unit.control.conftest import ACTUATOR

NAMES = ["strip_force_N", "frame_velocity_m_s"]


def law(gains: Any = ((0.4, -0.2, 0.1), (-0.5, 0.3, 0.2)), **more: Any) -> control.FilteredLaw:
    return control.FilteredLaw(NAMES, gains, 0.004, **more)


def test_a_constant_signal_asks_for_nothing() -> None:
    one = law()
    assert all(one(np.array([[90.0, 0.2]]))[0] == 0.0 for _ in range(50))


def test_the_response_to_a_step_is_that_of_its_low_passes() -> None:
    # One gain, one time constant, and a mean so slow that it stays.
    tau, step, sample = 0.05, 30.0, 0.004
    gains = [[0.7], [0.0]]
    one = control.FilteredLaw(NAMES, gains, sample, time_constants_s=[tau], mean_over_s=1e9)
    one(np.array([[80.0, 0.0]]))
    for number in range(1, 20):
        found = one(np.array([[80.0 + step, 0.0]]))[0]
        expected = FORCE_N * 0.7 * step / 50.0 * -np.expm1(-number * sample / tau)
        assert found == pytest.approx(expected, rel=1e-6)


def test_the_slow_mean_is_taken_out() -> None:
    one = law(mean_over_s=0.5)
    one(np.array([[80.0, 0.0]]))
    forces = [one(np.array([[110.0, 0.0]]))[0] for _ in range(2500)]
    assert abs(forces[20]) > 1.0
    assert abs(forces[-1]) < 1e-6 * abs(forces[20])  # e^(−10 s/0.5 s) is 2e-9


def test_laws_side_by_side_are_each_alone() -> None:
    gains = np.random.default_rng(3).normal(size=(3, 2, 3))
    many, each = law(gains), [law(own) for own in gains]
    for seen in np.random.default_rng(4).normal(size=(30, 3, 2)):
        alone = [one(row[None])[0] for one, row in zip(each, seen, strict=True)]
        np.testing.assert_allclose(many(seen), alone, rtol=1e-12)  # the order of a sum of six


def test_after_begin_nothing_is_remembered() -> None:
    one, seen = law(), np.random.default_rng(5).normal(size=(20, 1, 2))
    first = [one(row)[0] for row in seen]
    one.begin()
    assert [one(row)[0] for row in seen] == first


@pytest.mark.parametrize("gains", [[1.0], [[1.0, 2.0, np.nan], [0.0, 0.0, 0.0]], np.zeros((3, 2))])
def test_wrong_gains_are_refused(gains: Any) -> None:
    with pytest.raises(ModelError, match="gains of a law"):
        law(gains)


@pytest.fixture(scope="module")
def task(scenario: Scenario) -> control.Task:
    return control.task(scenario, actuator=ACTUATOR, spans=1, lead_in_spans=1, observe=NAMES)


def test_a_law_of_a_file_is_the_law(task: control.Task, tmp_path: Path) -> None:
    made, file = law(), tmp_path / "law.json"
    control.save_law(file, made, task, {"learnt": "by hand"})
    scenario = task.scenario.with_(
        **{"travel.start": 60.0, "travel.end": 200.0, "analysis": {"from": 110.0, "to": 190.0}}
    )
    runs = [
        arcless.run(scenario, controllers={"P1": controller})
        for controller in (control.LawController.of(made, task), control.load_law(file))
    ]
    there, here = (run.dataset["control_force"].values[:, 0] for run in runs)
    np.testing.assert_array_equal(there, here)
    assert np.abs(there).max() > 1.0
    said = json.loads(file.read_text(encoding="utf-8"))
    assert said["task"]["weights"]["loss_per_s"] == 1000.0
    assert said["about"] == {"learnt": "by hand"}


def test_a_law_is_the_controller_of_a_file(task: control.Task, tmp_path: Path) -> None:
    control.save_law(tmp_path / "law.json", law(), task)
    (tmp_path / "law.py").write_text(
        "from pathlib import Path\n"
        "from arcless.control import load_law\n"
        'damper = load_law(Path(__file__).with_name("law.json"))\n',
        encoding="utf-8",
    )
    own = {**ACTUATOR, "function": f"{tmp_path / 'law.py'}:damper"}
    scenario = task.scenario.with_(
        **{
            "pantographs.0.controller": own,
            "travel": {"start": 60.0, "end": 150.0},
            "analysis": {"from": 110.0, "to": 140.0},
        }
    )
    force = arcless.run(scenario).dataset["control_force"].values
    assert 1.0 < np.abs(force).max() <= 60.0


def test_a_law_is_refused_where_it_does_not_belong(task: control.Task) -> None:
    section = {"travel": {"start": 60.0, "end": 150.0}, "analysis": {"from": 110.0, "to": 140.0}}
    scenario, controller = task.scenario.with_(**section), control.LawController.of(law(), task)
    field = "pantographs.0.controller"
    arcless.run(scenario.with_(**{field: controller.actuator}), controllers={"P1": controller})
    with pytest.raises(ControlError, match=r"sampled at other intervals.*2 ms.*4 ms"):
        arcless.run(scenario.with_(**{field: None}), controllers={"P1": controller})
    one = {"mass": "15 kg", "stiffness": "50 N/m", "damping": "90 N s/m"}
    other = {"pantographs.0.model.masses": [one], field: controller.actuator}
    with pytest.raises(ControlError, match=r"another pantograph.*1 coordinates.*expected 2"):
        arcless.run(scenario.with_(**other), controllers={"P1": controller})


def test_a_law_of_an_unknown_signal_is_refused() -> None:
    with pytest.raises(ModelError, match="unknown signal"):
        control.FilteredLaw(["colour"], [[1.0, 1.0, 1.0]], 0.004)


DAMAGED: list[tuple[str, str]] = [
    ("", "no law can be read"),
    ("[1, 2]", "not a law"),
    ('{"format": "arcless-law/9"}', "not a law"),
    ('{"format": "arcless-law/1"}', "a damaged law"),
]


@pytest.mark.parametrize(("text", "what"), DAMAGED)
def test_damaged_files_are_refused(tmp_path: Path, text: str, what: str) -> None:
    file = tmp_path / "law.json"
    file.write_text(text, encoding="utf-8")
    with pytest.raises(ResultFormatError, match=what):
        control.load_law(file)
    with pytest.raises(ResultFormatError, match="no law can be read"):
        control.load_law(tmp_path / "none.json")


@pytest.mark.parametrize(
    ("field", "value"),
    [("gains", [[1.0]]), ("observe", ["colour", "smell"]), ("sample_time_s", None)],
)
def test_a_law_that_does_not_fit_is_refused(
    task: control.Task, tmp_path: Path, field: str, value: Any
) -> None:
    file = tmp_path / "law.json"
    control.save_law(file, law(), task)
    data = json.loads(file.read_text(encoding="utf-8"))
    data["law"][field] = value
    file.write_text(json.dumps(data), encoding="utf-8")
    with pytest.raises((ResultFormatError, ModelError)):
        control.load_law(file)
