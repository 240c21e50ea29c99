"""Residual forces that an equilibrium may leave."""

import sys
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

import arcless
from arcless.equilibrium import equilibrium
from arcless.equilibrium.equilibrium import MOST_KEPT
from tests.support.line_types import scenario_data
from tests.support.overlaps import plain_data


def test_what_is_left_of_rounding_is_no_failure() -> None:
    """Twin wires with cubic elements of 0.35 m leave 1.003 of what a wire by itself may."""
    twin = {"separation": 0.04, "droppers": "paired"}
    damping = {"alpha": 0.0125, "beta": 1e-4}
    line = plain_data(10, twin_contact_wires=twin, contact_wire__damping=damping)
    data = scenario_data(
        line,
        speed="250 km/h",
        travel={"start": 130.0, "end": 480.0},
        solver__kinematics="updated",
    )
    found = equilibrium.find(arcless.load(data))
    assert found.positions.shape[0] > 3000


def test_runs_that_share_a_line_ask_at_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """Values kept by one thread must not disturb another one that looks them up."""
    asked = [np.array([float(k)]) for k in range(MOST_KEPT)]
    found = equilibrium.Equilibrium(None, None, {})  # type: ignore[arg-type]
    monkeypatch.setattr(equilibrium.Equilibrium, "_elasticity", lambda _, x, force: x + force)

    def ask(first: int) -> None:
        for k in range(MOST_KEPT):
            own = asked[(first + k) % MOST_KEPT]
            one, again = found.elasticities([own, own], 0.5)
            assert one == again == own + 0.5

    before = sys.getswitchinterval()
    sys.setswitchinterval(1e-6)
    try:
        for _ in range(20):
            found._found.clear()
            with ThreadPoolExecutor(8) as pool:
                list(pool.map(ask, range(0, MOST_KEPT, 7)))
    finally:
        sys.setswitchinterval(before)
