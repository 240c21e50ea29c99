"""Runs with a pantograph that is an FMU: against the same one inside, and what is refused."""

from collections.abc import Callable
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import arcless
from arcless import ControlInput, FmuError, ModelError
from arcless.model import Scenario
from arcless.results import Result
from arcless.simulate.fmu.admission import ENVIRONMENT
from tests.support import fmus

Floats = NDArray[np.float64]
Short = Callable[..., Scenario]
pytestmark = fmus.can_run
# The scheme in which the C pantograph steps with `scheme: 1`.
TRAPEZOIDAL = {"solver.scheme": {"name": "trapezoidal"}}
CONTROLLER = {"sample_time": "6 ms", "delay": "4 ms", "pid": {"target": 120, "proportional": 0.5}}


def inside(strips: int = 1) -> dict[str, Any]:
    """Return the data of the pantograph that the C source has, as masses."""
    chain = [
        {"mass": 6.0, "stiffness": 160.0, "damping": 100.0},
        {"mass": 9.0, "stiffness": 15500.0, "damping": 0.1},
    ]
    if strips == 1:
        return {
            "name": "inside",
            "masses": [*chain, {"mass": 7.5, "stiffness": 7e3, "damping": 45}],
        }
    head = {
        "strips": strips, "strip_spacing": 0.4, "half_length": 0.8,
        "mass": 7.5 / strips, "stiffness": 7e3 / strips, "damping": 45.0 / strips,
    }  # fmt: skip
    return {"name": "inside", "masses": chain, "head": head}


def outside(file: Path, strips: int = 1, **more: Any) -> dict[str, Any]:
    own: dict[str, Any] = {"file": str(file), "static_force": "static_force", **more}
    if strips == 1:
        return {"name": "outside", "fmu": own}
    for name in ("contact_force", "strip_height"):
        own[name] = [f"{name}_{i + 1}" for i in range(strips)]
    own["strip_offset"] = [-0.2, 0.2]
    return {"name": "outside", "fmu": own, "half_length": 0.8}


def with_model(scenario: Scenario, model: dict[str, Any], **placed: Any) -> Scenario:
    force = {} if "mean_force" in placed else {"static_force": 120.0}
    return scenario.with_(pantographs=[{"model": model, **force, **placed}])


def forces(result: Result) -> Floats:
    return np.asarray(result.dataset["contact_force"].values[:, 0])


def run(scenario: Scenario) -> Result:
    return arcless.run(scenario, allow_fmu=True)


@pytest.mark.parametrize("fmi", [2, 3])
def test_the_same_steps_give_the_same_forces(tmp_path: Path, short: Short, fmi: int) -> None:
    file = fmus.fmu(tmp_path, fmi)
    base = short(**TRAPEZOIDAL)
    own = run(with_model(base, inside()))
    found = run(with_model(base, outside(file, parameters={"scheme": 1.0})))
    assert np.ptp(forces(own)) > 40.0
    # Rounding of heights of 5 m, 1e-15 m, over the compliance of the contact of 50 kN/m and of the
    # step, 2e-5 m/N, and what the line makes of it.
    np.testing.assert_allclose(forces(found), forces(own), rtol=0, atol=1e-7)
    facts = found.metadata["fmus"]["P1"]
    assert facts["sha256"] == found.scenario.pantographs[0].model.fmu.sha256  # type: ignore[union-attr]
    assert facts["fmi_version"] == fmi
    assert facts["compliance_measured"] == 1
    assert facts["largest_height_difference_m"] < 1e-14
    assert found.metadata["warnings"] == own.metadata["warnings"]
    moved, masses = found.dataset["mass_displacement"], own.dataset["mass_displacement"]
    np.testing.assert_allclose(moved.values[:, 0, 0], masses.values[:, 0, 2], rtol=0, atol=1e-9)


def test_two_strips_are_two_contacts(tmp_path: Path, short: Short) -> None:
    file = fmus.fmu(tmp_path, strips=2)
    base = short(**TRAPEZOIDAL)
    own = run(with_model(base, inside(2)))
    found = run(with_model(base, outside(file, 2, parameters={"scheme": 1.0})))
    # At the start the line shares 120 N a little unevenly, and the FMU knows it not: a swing of
    # some 10 mN that dies out.
    off = np.abs(forces(found) - forces(own))
    assert np.max(off) < 0.05
    assert np.max(off[len(off) // 2 :]) < 0.2 * np.max(off)
    assert found.dataset["wire_contact_force"].shape[1] == 2


@pytest.mark.parametrize("scheme", ["generalised-alpha", "central-difference"])
def test_coupling_is_of_second_order(tmp_path: Path, short: Short, scheme: str) -> None:
    """Exact motion in the FMU, another scheme inside: a quarter of the difference per half step."""
    file = fmus.fmu(tmp_path)
    # Elements that explicit steps of 1 ms and of less are stable with: only the step changes.
    elements = {"solver.contact_wire_element": 0.5, "solver.messenger_wire_element": 0.5}
    off = []
    for step in (1e-3, 0.5e-3):
        base = short(**{"solver.scheme": scheme, **elements, "solver.time_step": step})
        own, found = (forces(run(with_model(base, model))) for model in (inside(), outside(file)))
        off.append(np.max(np.abs(found - own)))
    assert off[0] < 0.2
    assert 0.2 < off[1] / off[0] < 0.32


@pytest.mark.parametrize(
    "scheme",
    [
        {"name": "generalised-alpha", "spectral_radius": 0.0},
        {"name": "backward-difference"},
        "central-difference",
    ],
    ids=["generalised-alpha", "backward-difference", "central-difference"],
)
def test_rigid_contact(tmp_path: Path, short: Short, scheme: Any) -> None:
    """Schemes that balance at the end of a step: half of a force is that of the step before."""
    base = short(**{"contact.law": "rigid", "solver.scheme": scheme})
    own = run(with_model(base, inside()))
    found = run(with_model(base, outside(fmus.fmu(tmp_path))))
    ours, theirs = (one.assessment.pantographs[0].std_force_N for one in (own, found))
    # These schemes damp what the FMU does exactly; ringing would be tens of N from step to step.
    assert theirs == pytest.approx(ours, rel=0.1)
    steps = [np.std(np.diff(forces(one))) for one in (own, found)]
    assert steps[1] < 1.2 * steps[0]


def test_an_fmu_without_saved_states(tmp_path: Path, short: Short) -> None:
    base = short()
    file = fmus.fmu(tmp_path)
    saved = run(with_model(base, outside(file)))
    file = fmus.fmu(tmp_path, faults=("NOSTATE",), keeps_state=False)
    found = run(with_model(base, outside(file, strip_mass=7.5)))
    off = np.abs(forces(found) - forces(saved))
    assert 1e-6 < np.max(off) < 1.0
    assert found.metadata["fmus"]["P1"]["largest_height_difference_m"] < 1e-6


def test_a_hardening_head_is_measured_again(tmp_path: Path, short: Short) -> None:
    model = outside(fmus.fmu(tmp_path), parameters={"hardening": 5e8})
    found = run(with_model(short(), model))
    facts = found.metadata["fmus"]["P1"]
    assert facts["compliance_measured"] > 10
    assert 0.0 < facts["largest_height_difference_m"] < 1e-8


def test_a_roof_that_moves(tmp_path: Path, short: Short) -> None:
    roof = {"time": [0.0, 1.0, 2.0, 9.0], "displacement": [0.0, 0.02, -0.02, 0.0]}
    names = {"base_height": "base_height", "base_velocity": "base_velocity"}
    base = short(**TRAPEZOIDAL)
    own = run(with_model(base, inside(), roof_motion=roof))
    model = outside(fmus.fmu(tmp_path), parameters={"scheme": 1.0}, **names)
    found = run(with_model(base, model, roof_motion=roof))
    still = run(with_model(base, inside()))
    assert np.max(np.abs(forces(own) - forces(still))) > 1.0
    # The roof is held at its mean in a step, of which the trapezoidal rule takes the same.
    np.testing.assert_allclose(forces(found), forces(own), rtol=0, atol=1e-6)


def test_a_controlled_force(tmp_path: Path, short: Short) -> None:
    base = short(**TRAPEZOIDAL)
    own = run(with_model(base, inside(), controller=CONTROLLER))
    model = outside(fmus.fmu(tmp_path), parameters={"scheme": 1.0}, control_force="control_force")
    found = run(with_model(base, model, controller=CONTROLLER))
    assert np.ptp(own.dataset["control_force"].values) > 5.0
    np.testing.assert_allclose(forces(found), forces(own), rtol=0, atol=1e-6)
    np.testing.assert_allclose(
        found.dataset["control_force"].values,
        own.dataset["control_force"].values,
        rtol=0,
        atol=1e-6,
    )


def test_samples_of_a_function(tmp_path: Path, short: Short) -> None:
    seen: list[ControlInput] = []

    def look(sample: ControlInput) -> float:
        seen.append(sample)
        return 0.0

    model = outside(fmus.fmu(tmp_path), control_force="control_force")
    data = arcless.run(
        with_model(short(), model, controller={"sample_time": "2 ms"}),
        controllers={"P1": look}, allow_fmu=True,
    ).dataset  # fmt: skip
    assert [one.sample_number for one in seen] == list(range(len(seen)))
    assert seen[0].contact_force_N == pytest.approx(120.0)
    moved = data["mass_displacement"].values[:, 0, 0]
    # At the start of a step it sees the end of the one before; records are of the time of balance.
    between = [(a.displacements_m[0], b.displacements_m[0]) for a, b in pairwise(seen)]
    low, high = np.min(between, axis=1) - 1e-12, np.max(between, axis=1) + 1e-12
    assert np.all((moved[:-1] >= low) & (moved[:-1] <= high))
    rates = [(b - a) / 2e-3 for a, b in between]
    np.testing.assert_allclose([one.velocities_m_s[0] for one in seen[1:]], rates, atol=1e-9)


def test_a_mean_force_is_found(tmp_path: Path, short: Short) -> None:
    found = run(with_model(short(), outside(fmus.fmu(tmp_path)), mean_force=110.0))
    assert found.assessment.pantographs[0].mean_force_N == pytest.approx(110.0, abs=0.03)
    own = run(with_model(short(), inside(), mean_force=110.0))
    told = [one.metadata["static_force_found"]["P1"] for one in (found, own)]
    assert told[0] == pytest.approx(told[1], abs=0.1)


def test_batches_and_other_starts(tmp_path: Path, short: Short) -> None:
    scenario = with_model(short(), outside(fmus.fmu(tmp_path)))
    own = run(scenario).assessment.pantographs[0].std_force_N
    several = arcless.batch([scenario, scenario], workers=2, allow_fmu=True)
    assert [one.error for one in several] == [None, None]
    assert [one.assessment.pantographs[0].std_force_N for one in several if one.assessment] == [
        own, own,
    ]  # fmt: skip
    refused = arcless.batch([scenario])
    assert isinstance(refused[0].error, FmuError)


def test_an_fmu_that_does_not_start_in_balance(tmp_path: Path, short: Short) -> None:
    model = outside(fmus.fmu(tmp_path))
    del model["fmu"]["static_force"]
    model["fmu"]["parameters"] = {"static_force": 100.0}
    found = run(with_model(short(), model))
    assert found.metadata["fmus"]["P1"]["start_imbalance_N"] == pytest.approx(-20.0, abs=0.1)
    words = "pantograph P1: its FMU does not start in balance: −20 N are left on its strips"
    assert any(warning.startswith(words) for warning in found.metadata["warnings"])


@pytest.mark.parametrize(
    ("fault", "words"), [("CRASH=0.501", "crashed"), ("NOTANUMBER=0.501", "nan")]
)
def test_a_failure_ends_the_run_with_time_and_place(
    tmp_path: Path, short: Short, fault: str, words: str
) -> None:
    scenario = with_model(short(), outside(fmus.fmu(tmp_path, faults=(fault,))))
    with pytest.raises(FmuError, match=words) as caught:
        run(scenario)
    # 160 km/h from 50 m on: 0.5 s are 22 m.
    assert str(caught.value).startswith("pantograph P1, t = 0.5")
    assert " 72." in str(caught.value)


def test_without_consent_nothing_runs(
    tmp_path: Path, short: Short, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delenv(ENVIRONMENT, raising=False)
    scenario = with_model(short(), outside(fmus.fmu(tmp_path, faults=("CRASH=-1",))))
    with pytest.raises(FmuError, match="P1 is an FMU, and FMUs are not allowed to run") as caught:
        arcless.run(scenario)
    assert "SHA-256" in str(caught.value)
    assert "--allow-fmu" in str(caught.value)
    monkeypatch.setenv(ENVIRONMENT, "0")
    with pytest.raises(FmuError, match="not allowed"):
        arcless.run(scenario)
    monkeypatch.setenv(ENVIRONMENT, "1")
    with pytest.raises(FmuError, match="it crashed"):
        arcless.run(scenario)


def test_a_changed_file_is_refused(tmp_path: Path, short: Short) -> None:
    scenario = with_model(short(), outside(fmus.fmu(tmp_path)))
    fmus.fmu(tmp_path, faults=("SPEAK",))
    with pytest.raises(ModelError, match="another FMU than the model was made with"):
        run(scenario)


def test_a_run_in_parts_is_refused(tmp_path: Path, short: Short) -> None:
    scenario = with_model(short(), outside(fmus.fmu(tmp_path)))
    with pytest.raises(FmuError, match="a run with an FMU cannot stop early"):
        arcless.run(scenario, until="100 m", allow_fmu=True)


def test_a_real_time_loop_is_refused(tmp_path: Path, short: Short) -> None:
    scenario = with_model(short(), outside(fmus.fmu(tmp_path)))
    with pytest.raises(ModelError, match="not in a real-time loop: an FMU runs in a process"):
        arcless.realtime(scenario, simulated=True)
    assert arcless.realtime(scenario).contacts == ("P1",)


def test_a_result_is_opened_without_the_fmu(tmp_path: Path, short: Short) -> None:
    file = fmus.fmu(tmp_path)
    result = run(with_model(short(), outside(file)))
    result.save(tmp_path / "result.nc")
    file.unlink()
    again = arcless.open(tmp_path / "result.nc")
    assert again.metadata["fmus"] == result.metadata["fmus"]
    assert again.assessment.pantographs[0].std_force_N == pytest.approx(
        result.assessment.pantographs[0].std_force_N, rel=1e-12
    )
