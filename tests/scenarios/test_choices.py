"""Wire model, scheme, kinematics and contact law combine freely."""

from collections.abc import Callable
from itertools import product
from typing import Any

import numpy as np
import pytest

import arcless
from arcless.errors import ContactError, ModelError
from arcless.model import Scenario, scenario_warnings
from arcless.results import Result

Run = Callable[..., Result]
Short = Callable[..., Scenario]

SCHEMES = (
    {"name": "generalised-alpha", "spectral_radius": 0.0},
    {"name": "hht", "alpha": -0.1},
    {"name": "newmark", "beta": 0.5625, "gamma": 1.0},
    {"name": "trapezoidal"},
    {"name": "backward-difference"},
)
FEW = {
    "line.spans": [{"type": "span", "count": 4}],
    "travel": {"start": "50 m", "end": "150 m"},
    "analysis": {"from": "60 m", "to": "140 m"},
    "solver.contact_wire_element": 0.5,
    "solver.messenger_wire_element": 1.0,
}


# Generalised-α too, with other numbers.
ALIKE = ("hht", "newmark")
COMBINATIONS = [
    pytest.param(
        wire, scheme, kinematics, law,
        marks=pytest.mark.evidence if scheme["name"] in ALIKE and kinematics == "updated" else (),
    )
    for wire, scheme, kinematics, law in product(
        ("hermite", "lumped"), SCHEMES, ("linearised", "updated"), ("compliant", "rigid")
    )
]  # fmt: skip


@pytest.mark.parametrize(
    ("wire", "scheme", "kinematics", "law"),
    COMBINATIONS,
    ids=lambda value: value["name"] if isinstance(value, dict) else value,
)
def test_every_combination_runs(
    run: Run, wire: str, scheme: dict[str, Any], kinematics: str, law: str
) -> None:
    result = run(
        **FEW,
        **{
            "solver.wire_model": wire,
            "solver.scheme": scheme,
            "solver.kinematics": kinematics,
            "contact.law": law,
        },
    )
    force = result.dataset["contact_force"].values[:, 0]
    gap = result.dataset["contact_gap"].values[:, 0]
    assert np.all(np.isfinite(force))
    assert np.all(force >= 0)
    assert np.all((gap == 0) | (force == 0))
    # The mean is the static force, up to the base spring and half a span too many or too few.
    assert result.assessment.pantographs[0].mean_force_N == pytest.approx(80.0, rel=0.05)
    counts = result.metadata["lcp_pivots_per_step"]
    assert sum(counts) == result.metadata["steps"]
    pivots = sum(i * n for i, n in enumerate(counts))
    assert pivots == result.metadata["lcp_pivots_total"]
    assert result.metadata["lcp_pivots_mean"] == pytest.approx(pivots / sum(counts))


def test_updated_kinematics_are_a_small_correction(run: Run) -> None:
    old, new = (run(**FEW, **{"solver.kinematics": name}) for name in ("linearised", "updated"))
    one, other = (r.dataset["contact_force"].values[:, 0] for r in (old, new))
    apart = float(np.max(np.abs(one - other)))
    # Uplifts of 25 mm: tension and directions change by a few per mille. Equal would mean unused.
    assert 0.0 < apart < 0.02 * float(np.mean(one))


def test_three_dimensions_lumped_and_updated(short: Short) -> None:
    stagger = {"line.geometry.stagger_contact_wire": [0.2, -0.2]}
    arm = {
        "line.steady_arm": {"kind": "arm", "length": "1.2 m", "slope": "10 deg", "mass": "1 kg/m"}
    }
    forces = {}
    for kinematics in ("linearised", "updated"):
        choice = {"solver.wire_model": "lumped", "solver.kinematics": kinematics}
        result = arcless.run(short(**FEW, **stagger, **arm, **choice))
        lateral = result.dataset["contact_lateral"].values[:, 0]
        assert 0.15 < np.max(np.abs(lateral)) <= 0.21
        forces[kinematics] = result.dataset["contact_force"].values[:, 0]
    apart = np.abs(forces["linearised"] - forces["updated"])
    assert 0.0 < float(np.max(apart)) < 0.05 * float(np.mean(forces["updated"]))


def test_points_move_along_the_track(run: Run) -> None:
    points = {"output.points": ["75 m", "100 m"]}
    rubbed = {"contact.friction_coefficient": 0.3}
    plain, dragged = run(**FEW, **points), run(**FEW, **points, **rubbed)
    assert plain.dataset["point_along"].dims == ("line_time", "point")
    assert plain.dataset["point_along"].attrs["units"] == "m"
    along = [float(r.dataset["point_along"].mean()) for r in (plain, dragged)]
    # 24 N drag the wire forwards; both of its ends are fixed.
    assert along[1] > along[0]


def test_no_energy_ledger_with_updated_kinematics(short: Short, run: Run) -> None:
    choice = {"solver.kinematics": "updated", "solver.scheme": "trapezoidal"}
    result = run(**FEW, **choice)
    assert not [name for name in result.dataset if str(name).startswith("energy")]
    assert result.assessment.to_dict()["energy_residual_relative"] is None
    with pytest.raises(ModelError, match="energy"):
        short(**FEW, **choice, **{"output.energy": "always"})


def test_motion_that_grows_ends_with_a_word() -> None:
    changes = {
        "contact.law": "compliant",
        "solver.time_step": "1 ms",
        "line.contact_wire.mass": "0.89 kg/m",
        "line.dropper.clamp_mass_contact_wire": 0.0,
        "solver.scheme": "trapezoidal",
    }
    scenario = arcless.load("praks-340").with_(**changes)
    assert any("can grow" in word for word in scenario_warnings(scenario))
    with pytest.raises(ContactError, match="the motion grew beyond all bounds"):
        arcless.run(scenario)
    damped = scenario.with_(**{"solver.scheme": "generalised-alpha"})
    assert not any("can grow" in word for word in scenario_warnings(damped))
    assert np.max(arcless.run(damped).dataset["contact_force"].values) < 300.0


@pytest.mark.parametrize(
    ("changed", "moves"),
    [
        ({}, True),
        ({"solver.kinematics": "updated"}, True),
        ({"solver.scheme": {"name": "backward-difference"}}, False),
        ({"solver.wire_model": "lumped"}, False),
    ],
    ids=["default", "updated", "first order", "point masses"],
)
def test_period_correction_where_there_is_one(
    run: Run, changed: dict[str, Any], moves: bool
) -> None:
    on, off = (
        run(**FEW, **changed, **{"solver.period_correction": value}).dataset["contact_force"].values
        for value in (True, False)
    )
    assert np.array_equal(on, off) != moves
    # Tenths of a percent of the force; single peaks somewhat more.
    assert np.std(on - off) < 0.05 * np.std(off)


def test_energy_is_kept_with_the_corrected_mass(run: Run) -> None:
    result = run(**FEW, **{"output.energy": "always"})
    # The ledger adds up but for the rounding of some thousand steps.
    assert result.metadata["energy_residual_relative"] < 1e-9
