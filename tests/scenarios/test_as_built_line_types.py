"""Weather on stitched and compound lines: every wire has its own ice, expansion and wind."""

from typing import Any

import numpy as np
import pytest

import arcless
from arcless.equilibrium import equilibrium
from arcless.errors import ModelError
from arcless.model import Scenario
from tests.support.line_types import compound_data, scenario_data, stitched_data

GRAVITY = 9.81


def upward(found: equilibrium.Equilibrium) -> float:
    """Vertical force of all springs to the ground in N, positive upwards."""
    up = found.mesh.dimension - 1
    springs = found.mesh.parts["springs"]
    return float(found.arrays["spring_force"][springs["component"] == up].sum())


def of(line: dict[str, Any], **changes: Any) -> Scenario:
    return arcless.load(scenario_data(line)).with_(**changes)


@pytest.mark.parametrize("wire_model", ["hermite", "lumped"])
def test_ice_on_the_stitch_wires_hangs_on_the_supports(wire_model: str) -> None:
    """Only the weight of the ice is new."""
    choice = {"solver.wire_model": wire_model}
    bare = equilibrium.find(of(stitched_data(), **choice))
    iced = equilibrium.find(of(stitched_data(), **choice, **{"as_built.ice.stitch_wire": 0.5}))
    weight = 0.5 * GRAVITY * 18.0 * 5
    # A clamp 9 m from a support of 60 m spans gives it 85 % of its load and the next one the rest:
    # of five supports the two outer ones lose that much of half their load to the anchors, 3 %.
    # The contact wire, which sinks with the stitches, takes a little more there.
    assert 0.92 < (upward(iced) - upward(bare)) / weight < 0.97
    # Partner: the same on the messenger wire is another weight.
    other = equilibrium.find(of(stitched_data(), **choice, **{"as_built.ice.messenger_wire": 0.5}))
    assert upward(other) - upward(bare) > 2.0 * weight


def test_each_wire_expands_by_its_own_coefficient() -> None:
    cold = of(compound_data())
    warm = {"as_built.temperature_difference": 20.0}
    stiff = {"line.auxiliary_wire.thermal_expansion": 0.0}
    tensions = {}
    for name, changes in (("cold", {}), ("warm", warm), ("one stays", {**warm, **stiff})):
        found = equilibrium.find(cold.with_(**changes))
        rows = found.mesh.wire_rows
        tension = found.arrays["wire_tension"]
        tensions[name] = {wire: float(np.mean(tension[k])) for wire, k in rows.items() if k}
    # Wires between fixed ends lose EA α ΔT, less what the sag gives back.
    for wire, axial in (("contact_wire", 14e6), ("auxiliary_wire", 15e6)):
        loss = tensions["cold"][wire] - tensions["warm"][wire]
        assert 0.8 < loss / (axial * 17e-6 * 20.0) <= 1.0
    kept = tensions["cold"]["auxiliary_wire"] - tensions["one stays"]["auxiliary_wire"]
    assert abs(kept) < 0.1 * 15e6 * 17e-6 * 20.0


def test_ice_on_a_wire_that_is_not_there() -> None:
    with pytest.raises(ModelError, match=r"as_built\.ice\.auxiliary_wire.*does not have"):
        of(stitched_data(), **{"as_built.ice.auxiliary_wire": "0.5 kg/m"})
