"""Gusts in a run: what they do, what they leave alone, and where their energy goes."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from arcless.equilibrium import equilibrium
from arcless.model import Gusts, Scenario
from arcless.results import Result
from arcless.simulate.setup import gust_loads, trajectory
from tests.support.explicit import EXPLICIT

Run = Callable[..., Result]
Short = Callable[..., Scenario]
SPATIAL: dict[str, Any] = {
    "solver.dimension": "spatial",
    "line.contact_wire.diameter": "12 mm",
    "line.messenger_wire.diameter": "14 mm",
}
STEADY = {**SPATIAL, "as_built.wind.speed": 12, "as_built.wind.angle": "4 deg"}
EVER = [0, 100]


def test_gusts_that_are_the_steady_wind_change_no_bit(run: Run) -> None:
    plain = run(**STEADY)
    same = run(**STEADY, **{"as_built.gusts": {"time": EVER, "speed": [12, 12]}})
    for name in ("contact_force", "contact_lateral", "dropper_force"):
        np.testing.assert_array_equal(same.dataset[name], plain.dataset[name])
    assert "energy_work_wind" not in plain.dataset


def test_gusts_blow_the_wire_aside_and_the_ledger_closes(run: Run) -> None:
    scheme = {"solver.scheme": "trapezoidal"}
    times = np.linspace(0, 5, 51)
    speed = (12 + 4 * np.sin(2 * np.pi * 0.5 * times)).tolist()
    calm = run(**STEADY, **scheme)
    gusty = run(**STEADY, **scheme, **{"as_built.gusts": {"time": times.tolist(), "speed": speed}})
    moved = np.abs(gusty.dataset["contact_lateral"] - calm.dataset["contact_lateral"])
    assert float(moved.max()) > 5e-3
    assert np.abs(gusty.dataset["energy_work_wind"]).max() > 0.1
    # The bound of the ledger's own tests in the core; rounding of a thousand steps.
    assert gusty.dataset.attrs["energy_residual_relative"] < 1e-9


@pytest.mark.parametrize("wire_model", ["hermite", "lumped"])
def test_updated_kinematics_feel_the_same_gust(run: Run, wire_model: str) -> None:
    """Shapes differ by second order: a swing of 0.1 m on 50 m turns a wire by 4 mrad."""
    blow = {"as_built.gusts": {"time": [0, 1, 100], "speed": [12, 24, 24]}}
    model = {"solver.wire_model": wire_model, "solver.scheme": "generalised-alpha"}
    swings = []
    for kinematics in ("linearised", "updated"):
        how = {**STEADY, **model, "solver.kinematics": kinematics}
        gusty, calm = run(**how, **blow), run(**how)
        swings.append((gusty.dataset["contact_lateral"] - calm.dataset["contact_lateral"]).values)
    most = np.abs(swings[0]).max()
    assert most > 0.03
    # Updated kinematics add what goes with the slope squared, here 2 % of a swing of 60 mm.
    np.testing.assert_allclose(swings[1], swings[0], rtol=0, atol=0.05 * most)


def test_pressure_is_that_of_the_wind(short: Short) -> None:
    built = short(**STEADY).as_built
    times = np.array([0.0, 5.0, 10.0])
    one = Gusts(time=(0, 10), speed=(10, -20))
    across, up = gust_loads.pressure(one, built, [0, 1], times)
    # ½ · 1.225 · v² at 10, −5 and −20 m/s; blown to the side it comes from the other.
    strength = 0.5 * 1.225 * np.array([100.0, 25.0, 400.0])
    angle = np.deg2rad(4)
    # Round-off of three products.
    np.testing.assert_allclose(across, np.array([1, -1, -1]) * strength * np.cos(angle), rtol=1e-12)
    np.testing.assert_allclose(up, strength * np.sin(angle), rtol=1e-12)
    both = Gusts(time=(0, 10), speed=(3, 3), vertical=(4, -4))
    across, up = gust_loads.pressure(both, built, [0, 1], times)
    # Round-off.
    np.testing.assert_allclose(across[[0, 2]], 0.5 * 1.225 * 5 * 3, rtol=1e-12)
    np.testing.assert_allclose(up[[0, 2]], [0.5 * 1.225 * 20, -0.5 * 1.225 * 20], rtol=1e-12)


def test_between_places_the_force_is_linear(short: Short) -> None:
    readings = {"time": EVER * 2, "position": [100, 100, 200, 200], "speed": [10, 10, 20, 20]}
    scenario = short(**SPATIAL, **{"as_built.gusts": readings})
    found = equilibrium.find(scenario)
    loads = gust_loads.line_loads(found, scenario, trajectory.motion(scenario))
    assert len(loads) == 2, "nothing blows upwards"
    total = np.zeros(len(found.mesh.positions))
    for pattern, sizes in loads:
        for node, component, share in pattern:
            if component == 1:
                total[node] += share * sizes[7]
    x, is_contact = found.mesh.positions[:, 0], np.zeros(len(total), dtype=bool)
    is_contact[found.mesh.contact_nodes] = True
    strength = np.interp(x, [100, 200], 0.5 * 1.225 * np.array([100.0, 400.0]))
    for wires, diameter in ((is_contact, 0.012), (~is_contact, 0.014)):
        ends = (x[wires].min(), x[wires].max())
        exact = diameter * np.interp(x[wires], x[wires], strength[wires])
        along, order = x[wires], np.argsort(x[wires], kind="stable")
        force = np.trapezoid(exact[order], along[order])
        # Wires stretch by 1.5e-3, and the wind counts per metre of rest length.
        assert total[wires].sum() == pytest.approx(force, rel=3e-3), ends


def test_explicit_steps_feel_the_same_gust(run: Run) -> None:
    """Half a hertz is far below what elements and steps tell apart: waves of tens of metres."""
    times = np.linspace(0, 5, 51)
    speed = (12 + 4 * np.sin(2 * np.pi * 0.5 * times)).tolist()
    blow = {"as_built.gusts": {"time": times.tolist(), "speed": speed}}
    chains = {**EXPLICIT, "solver.scheme": "generalised-alpha"}
    swings = []
    for how in (EXPLICIT, chains):
        friction = {"contact.friction_coefficient": 0.3}
        gusty, calm = (run(**STEADY, **friction, **how, **more) for more in (blow, {}))
        swings.append((gusty.dataset["contact_lateral"] - calm.dataset["contact_lateral"]).values)
    most = np.abs(swings[1]).max()
    assert most > 5e-3
    # Chains with a matrix slow waves of 10 m by (kℓ)²/24 = 0.3 %: 0.1 rad after five turns, and
    # such waves are a tenth or two of the swing.
    np.testing.assert_allclose(swings[0], swings[1], rtol=0, atol=0.02 * most)
