"""Explicit steps: what they need, what they refuse, and that a run with them is a run."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from typer.testing import CliRunner

import arcless
from arcless import _core
from arcless.cli.app import app
from arcless.equilibrium import equilibrium
from arcless.errors import ContactError, EquilibriumError, ModelError
from arcless.mesh import Mesh
from arcless.model import Scenario
from arcless.results import Result
from arcless.simulate.batches.fingerprints import shared_key
from arcless.simulate.runs import failures
from arcless.simulate.runs.failures import translated
from tests.support.explicit import EXPLICIT
from tests.support.small import differing

Run = Callable[..., Result]
Short = Callable[..., Scenario]
# Cubic elements that meet forces as the wire does.
SHORTER = {
    "solver.time_step": "1 ms",
    "solver.contact_wire_element": 0.48,
    "solver.messenger_wire_element": 0.96,
    "solver.residual_flexibility": True,
}
TOO_LONG = {**EXPLICIT, "solver.time_step": "4 ms"}
STAGGER = {"line.geometry.stagger_contact_wire": [0.2, -0.2]}
ARM = {"kind": "arm", "length": "1.2 m", "slope": "10 deg", "mass": "1 kg/m"}


def force(result: Result) -> Any:
    """Contact force, N."""
    return result.dataset["contact_force"].values[:, 0]


@pytest.mark.parametrize(
    "changes",
    [
        {},
        {"contact.law": "rigid"},
        {"contact.friction_coefficient": 0.3},
        {**STAGGER, "line.steady_arm": ARM},
    ],
    ids=["compliant", "rigid", "friction", "in space"],
)
def test_a_run_is_near_that_of_steps_that_are_solved_for(run: Run, changes: dict[str, Any]) -> None:
    solved, steps = run(**SHORTER, **changes), run(**EXPLICIT, **changes)
    one, other = solved.assessment.pantographs[0], steps.assessment.pantographs[0]
    assert np.all(np.isfinite(force(steps)))
    assert np.all(force(steps) >= 0)
    gap = steps.dataset["contact_gap"].values[:, 0]
    assert np.all((gap == 0) | (force(steps) == 0))
    # A mean force is a balance of weights, up to the parts of a span at the ends of the section.
    assert other.mean_force_N == pytest.approx(one.mean_force_N, rel=0.01)
    # Both are within half a percent of what varies (decisions 36 and 39); the partner, default
    # elements of 1.45 m, is not: 13.2 and 12.3 N, with rigid contact 13.6 and 12.0 N.
    assert other.std_force_N == pytest.approx(one.std_force_N, rel=0.01)


@pytest.mark.parametrize("scheme", ["central-difference", "generalised-alpha"])
def test_what_auto_stands_for_gives_the_same_bits(short: Short, scheme: str) -> None:
    left = short(**{"solver.scheme": scheme, "solver.time_step": "1 ms"})
    solver = left.stepping
    given = left.with_(**{
        "solver.wire_model": solver.wires,
        "solver.contact_wire_element": solver.contact_wire_element_m,
        "solver.messenger_wire_element": solver.messenger_wire_element_m,
    })  # fmt: skip
    assert shared_key(left) == shared_key(given)
    one, other = (arcless.run(scenario).dataset for scenario in (left, given))
    assert set(one.variables) == set(other.variables)
    for name, variable in one.data_vars.items():
        assert differing(other[name], variable)[1] == 0, name
    # What was taken can be read from the result, whatever the scenario says.
    for found in (one, other):
        assert found.attrs["wire_model"] == solver.wires
        assert found.attrs["contact_wire_element_m"] == solver.contact_wire_element_m
        assert found.attrs["messenger_wire_element_m"] == solver.messenger_wire_element_m


def test_the_ledger_changes_no_bit_and_is_kept_by_default(short: Short) -> None:
    results = {
        kept: arcless.run(short(**EXPLICIT, **{"output.energy": kept, "output.line_every": 7}))
        for kept in ("auto", "always", "never")
    }
    plain = results["never"].dataset
    for kept in ("auto", "always"):
        data = results[kept].dataset
        more = {str(name) for name in data.variables if name not in plain.variables}
        assert more and all(name.startswith("energy_") for name in more)
        for name, variable in plain.data_vars.items():
            assert differing(data[name], variable)[1] == 0, name
        # Rounding; 500 times that of a step where one in 500 is measured.
        assert 0.0 < results[kept].assessment.to_dict()["energy_residual_relative"] < 1e-11
    settled = np.flatnonzero(np.isfinite(results["auto"].dataset["energy_elastic"].values))
    # One step in 500, rounded up to rows: 504 = 72 rows of 7 steps.
    assert len(settled) > 2 and (np.diff(settled) == 72).all()
    assert np.isfinite(results["always"].dataset["energy_elastic"].values).all()
    notes = results["never"].assessment.notes
    assert "no energy balance was kept; `output.energy: always` keeps one" in notes


def test_a_batch_keeps_the_ledger_of_explicit_steps(short: Short) -> None:
    (outcome,) = arcless.batch([short(**EXPLICIT)])
    assert outcome.assessment is not None
    found = outcome.assessment.energy_residual_relative
    assert found is not None and 0.0 < found < 1e-11


@pytest.mark.parametrize("what", ["residual", "damping", "switching"])
def test_a_balance_that_does_not_close_says_when(what: str) -> None:
    details = {"what": what, "step": 7, "time": 0.008, "off": -0.25, "turnover": 2.0}
    error = translated(Mesh.__new__(Mesh), ["one"], "balance", "", details)
    assert isinstance(error, ContactError)
    assert error.where == "step 7, t = 0.008 s" and error.got == "-0.25 J"
    assert error.expected is not None and "of the 2 J turned over" in error.expected
    assert error.hint


def test_a_step_too_long_is_refused(short: Short) -> None:
    with pytest.raises(ModelError) as caught:
        arcless.run(short(**TOO_LONG))
    error = caught.value
    assert (error.where, error.got) == ("solver.time_step", "4 ms")
    assert error.expected is not None
    longest = float(error.expected.removeprefix("at most about ").partition(" ms")[0])
    # A chain is stable for h < ℓ/c; the wires here carry waves with 128 and 122 m/s.
    assert 0.5 < longest / (1e3 * 0.45 / 128.0) < 1.0
    with pytest.raises(ModelError, match="too long for the elements"):
        arcless.realtime(short(**TOO_LONG), simulated=True)
    (outcome,) = arcless.batch([short(**TOO_LONG)])
    assert "too long for the elements" in str(outcome.error)


def test_a_support_stiff_along_the_track_takes_shorter_steps_or_is_refused(short: Short) -> None:
    stiff = {**EXPLICIT, "line.support.longitudinal_stiffness": 1e8}
    with pytest.raises(ModelError, match="too long for the elements"):
        arcless.run(short(**{**stiff, "solver.time_step": "1 ms"}))
    left = short(**{**stiff, "solver.time_step": "auto"})
    assert left.stepping.time_step < 0.5e-3
    assert np.all(np.isfinite(force(arcless.run(left))))


def test_elements_too_short_are_refused(short: Short) -> None:
    with pytest.raises(ModelError, match=r"elements: got 1 ms.*hint: .*of 0\.45 m") as caught:
        arcless.run(short(**{**EXPLICIT, "solver.contact_wire_element": 0.1}))
    assert caught.value.where == "solver.time_step"


def test_one_setting_switches_them_on(tmp_path: Path) -> None:
    files = Path(__file__).parents[1] / "interface" / "data"
    command = ["run", str(files / "short.yaml"), "--set", "solver.scheme=central-difference"]
    CliRunner().invoke(app, [*command, "--out", str(tmp_path / "out")])
    scenario = arcless.open(tmp_path / "out" / "result.nc").scenario
    solver, taken = scenario.solver, scenario.stepping
    assert (solver.scheme.name, solver.contact_wire_element) == ("central-difference", "auto")
    page = (tmp_path / "out" / "report.html").read_text("utf-8")
    assert f"auto ({taken.contact_wire_element_m:g} m)" in page
    assert f"auto ({taken.messenger_wire_element_m:g} m)" in page


def test_the_command_line_says_so_in_words(short: Short, tmp_path: Path) -> None:
    files = Path(__file__).parents[1] / "interface" / "data"
    words = [part for key, value in TOO_LONG.items() for part in ("--set", f"{key}={value}")]
    out = ["--out", str(tmp_path / "out")]
    done = CliRunner().invoke(app, ["run", str(files / "short.yaml"), *words, *out])
    assert done.exit_code == ModelError.exit_code
    assert "solver.time_step: explicit steps too long for the elements: got 4 ms" in done.stderr
    assert "Traceback" not in done.stderr
    assert not (tmp_path / "out").exists()


def test_what_else_the_core_refuses_is_said(short: Short) -> None:
    scenario = short(**EXPLICIT)
    mesh = equilibrium.find(scenario).mesh
    facts = {"array": "solver", "reason": "node 3 moves without mass"}
    with pytest.raises(ModelError) as caught, failures.preparing(mesh, scenario):
        raise _core.NativeError("input", "", facts)
    assert str(caught.value) == (
        "solver.scheme: this line cannot be stepped with the scheme central-difference: got node 3"
        " moves without mass; hint: leave solver.scheme to auto"
    )
    with (
        pytest.raises(EquilibriumError, match="lanes: none"),
        failures.preparing(mesh, scenario),
    ):
        raise _core.NativeError("input", "input array lanes: none", {"array": "lanes"})


def test_members_of_a_batch_are_what_they_are_alone(short: Short) -> None:
    changes: list[dict[str, Any]] = [
        {},
        {"speed": "120 km/h"},
        {"pantographs.0.static_force": "90 N"},
        {"pantographs.0.mean_force": "80 N"},
    ]
    scenarios = [short(**EXPLICIT, **some) for some in changes]
    outcomes = arcless.batch([short(), *scenarios], keep="result", workers=2)[1:]
    for scenario, outcome in zip(scenarios, outcomes, strict=True):
        assert outcome.result is not None
        alone = arcless.run(scenario).dataset
        assert set(outcome.result.dataset.variables) == set(alone.variables)
        for name, variable in alone.data_vars.items():
            assert differing(outcome.result.dataset[name], variable)[1] == 0, name


def test_what_is_recorded_does_not_change_what_is_computed(short: Short) -> None:
    """Explicit steps keep up to date what is read; what is not read must not matter."""
    few = {"output.droppers": False, "output.supports": False, "output.line_every": 1000}
    much = {"output.points": [80.0, 101.3, 133.0], "output.line_every": 1, "output.around": "30 m"}
    one, *others = (arcless.run(short(**EXPLICIT, **some)) for some in ({}, few, much))
    for other in others:
        np.testing.assert_array_equal(force(other), force(one))
