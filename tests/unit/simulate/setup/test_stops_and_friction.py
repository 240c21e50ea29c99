"""Tables, friction and stops of pantographs in a run."""

import json
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import arcless
from arcless.errors import EquilibriumError
from arcless.model import Scenario
from arcless.results import Result
from arcless.simulate.setup import pantographs, stops_and_friction

Run = Callable[..., Result]
Short = Callable[..., Scenario]
Data = dict[str, Any]

MODEL = "pantographs.0.model"
TRAPEZOIDAL = {"solver.scheme": {"name": "trapezoidal"}}
# Droppers that slacken a step earlier or later let rounding grow.
SAME_RUN = 1e-6


def force(result: Result) -> np.ndarray:
    return result.dataset["contact_force"].values


def head(placement: Data, **joint: Any) -> Data:
    """The pantograph with other joints below its head; None takes one away."""
    model = placement["model"]
    changed = {**model["masses"][1], **joint}
    changed = {key: value for key, value in changed.items() if value is not None}
    return {**model, "masses": [model["masses"][0], changed]}


def line(slope: float, *places: float) -> list[float]:
    return [slope * place for place in places]


def test_straight_tables_are_the_linear_pantograph(run: Run, placement: Data) -> None:
    part = placement["model"]["masses"][1]
    k, c = part["stiffness"], part["damping"]
    places, rates = (-0.5, -0.02, 0.1, 0.5), (-10.0, -0.1, 0.2, 10.0)
    listed = head(
        placement,
        stiffness=None,
        damping=None,
        stiffness_table={"elongation": places, "force": line(k, *places)},
        damping_table={"velocity": rates, "force": line(c, *rates)},
    )
    result = run(**{MODEL: listed})
    np.testing.assert_allclose(force(result), force(run()), rtol=0, atol=SAME_RUN)
    assert result.dataset.attrs["warnings"] == run().dataset.attrs["warnings"]


def test_joints_beside_matrices_are_those_of_a_chain(run: Run, placement: Data) -> None:
    joint = {
        "friction": {"force": 6.0},
        "stops": {"below": 0.02, "above": 0.02, "stiffness": 2e5},
        "damping_table": {"velocity": [-1, -0.1, 0, 0.1, 1], "force": [-50, -40, 0, 20, 30]},
    }
    chain = head(placement, damping=None, **joint)
    lift = {"speed": [0.0, 60.0], "force": [0.0, 30.0]}
    chain["masses"][0] = {**chain["masses"][0], "lift": lift}
    bare = head(placement, damping=0.0)
    made = pantographs.data(arcless.model.load_pantograph(bare), 0.0)
    square = {
        name: np.reshape(getattr(made, name), (2, 2)).tolist()
        for name in ("mass", "damping", "stiffness")
    }
    matrices = {
        "name": "general",
        "matrices": {
            **square,
            "strip": made.strips[0].vectors[0],
            "preload": made.preload,
            "joints": [{"between": [-1, 1], **joint}],
            "lift_tables": [{"on": [1, 0], **lift}],
        },
    }
    first, second = run(**{MODEL: chain}), run(**{MODEL: matrices})
    assert force(first).tobytes() == force(second).tobytes()
    assert np.max(np.abs(force(first) - force(run()))) > 10.0


def test_the_energy_balance_closes_with_friction(run: Run, placement: Data) -> None:
    result = run(**{MODEL: head(placement, friction={"force": 8.0})}, **TRAPEZOIDAL)
    assert result.dataset.attrs["energy_residual_relative"] < 1e-11
    heat = result.dataset["energy_dissipated_pantograph"].values
    plain = run(**TRAPEZOIDAL).dataset["energy_dissipated_pantograph"].values
    assert np.all(np.diff(heat) >= 0)
    assert heat[-1] > plain[-1]


def test_a_table_that_is_left_is_a_warning(run: Run, placement: Data) -> None:
    k = placement["model"]["masses"][1]["stiffness"]
    start = -80.0 / k
    ends = (start - 1e-3, 0.1)
    table = {"elongation": ends, "force": line(k, *ends)}
    result = run(**{MODEL: head(placement, stiffness=None, stiffness_table=table)})
    warnings = json.loads(result.dataset.attrs["warnings"])
    (text,) = [text for text in warnings if "was left" in text]
    assert text.startswith("pantograph P1: masses.1.stiffness_table was left: -0.0")
    assert text.endswith("; beyond it the last slope continues")
    # It does: the table is straight.
    np.testing.assert_allclose(force(result), force(run()), rtol=0, atol=SAME_RUN)


def test_a_table_too_short_for_the_static_force_is_refused(short: Short, placement: Data) -> None:
    table = {"elongation": [-0.005, 0.1], "force": [-35.0, 700.0]}
    scenario = short(**{MODEL: head(placement, stiffness=None, stiffness_table=table)})
    with pytest.raises(EquilibriumError) as caught:
        arcless.run(scenario)
    assert str(caught.value) == (
        "pantographs.0.model.masses.1.stiffness_table.elongation: a table of pantograph P1 ends"
        " before the static force is reached: got -0.005 m, expected a table that reaches -0.01143"
        " m; hint: lengthen the table, or lower the static force"
    )


def test_laws_look_at_the_motion_between_a_mass_and_what_is_below(placement: Data) -> None:
    model = arcless.model.load_pantograph(head(placement, friction={"force": 8.0}))
    (law,) = stops_and_friction.piecewise_forces(model)
    found = (law.field, law.data.direction, law.data.is_damper)
    assert found == ("masses.1.friction", [-1.0, 1.0], True)
