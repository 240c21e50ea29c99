"""Devices with friction on lines of several wires, and what becomes of them in a run."""

from typing import Any
from unittest.mock import patch

import numpy as np
import pytest

import arcless
from arcless.equilibrium import equilibrium
from arcless.equilibrium.sliding_ends import SlidingEnds
from arcless.errors import EquilibriumError
from arcless.model import load
from tests.support.line_types import compound_data, scenario_data, stitched_data

ANCHOR = {"midpoint_anchor": {"stiffness": 1e6}}
COARSE = {"solver__contact_wire_element": 2.0, "solver__messenger_wire_element": 4.0}
WIRES = ("contact_wire", "messenger_wire", "auxiliary_wire")


def on_weights(data: dict[str, Any], efficiency: float | None = 0.97) -> dict[str, Any]:
    """Hang all wires of a line on weights."""
    for name in WIRES:
        if data.get(name) is not None:
            data[name] |= {"ends": "weights", "end_efficiency": efficiency}
    return data | ANCHOR


def rest(line: dict[str, Any], **built: Any) -> equilibrium.Equilibrium:
    changes = {f"as_built__{name}": value for name, value in built.items()}
    return equilibrium.find(load(scenario_data(line, **COARSE, **changes)))


def pulls(found: equilibrium.Equilibrium) -> dict[tuple[str, float], float]:
    """Horizontal tension in N of each wire at each end."""
    nodes = found.mesh.parts["wires"]["nodes"]
    told = {}
    for end in found.mesh.ends:
        chord = np.diff(found.positions[nodes[end.element]], axis=0)[0]
        cosine = chord[0] / np.linalg.norm(chord)
        tension = float(found.arrays["wire_tension"][end.element] * cosine)
        told[end.wire, end.outward] = tension
    return told


@pytest.mark.parametrize("difference", [-20.0, 20.0])
@pytest.mark.parametrize("make", [stitched_data, compound_data])
def test_every_wire_of_a_line_gets_its_own_bound(make: Any, difference: float) -> None:
    line = on_weights(make())
    share = 0.97 if difference > 0 else 1 / 0.97
    told = pulls(rest(line, temperature_difference=difference))
    assert len(told) == 2 * sum(name in line for name in WIRES)
    for (wire, _), tension in told.items():
        # Of the part of the wire's bending at its anchor, shear times slope, and long elements.
        assert tension == pytest.approx(share * line[wire]["tension"], rel=5e-4)


def test_one_wire_may_slide_and_another_hold() -> None:
    line = on_weights(stitched_data())
    line["messenger_wire"] |= {"axial_stiffness": 7.4e5}  # 12.6 N/K: 3 % of 15 kN are 36 K
    told = pulls(rest(line, temperature_difference=-20.0))
    assert told["contact_wire", 1.0] == pytest.approx(15e3 / 0.97, rel=5e-4)
    assert 15.1e3 < told["messenger_wire", 1.0] < 15.4e3


def test_what_lies_within_the_band_moves_no_end() -> None:
    line = on_weights(stitched_data(), 0.9)
    found = rest(line, ice={"contact_wire": 0.3, "messenger_wire": 0.3})
    assert found.end_travel() == found.end_travel(0) == (0.0, 0.0)
    assert pulls(found)["messenger_wire", 1.0] > 15.1e3


def test_ice_draws_the_ends_in() -> None:
    line = on_weights(stitched_data())
    found = rest(line, ice={"contact_wire": 2.0, "messenger_wire": 2.0})
    (_, end), (_, start) = found.end_travel(), found.end_travel(0)
    assert end is not None and start is not None
    assert end < 0 < start
    # The horizontal pull along a wire that sags.
    assert pulls(found)["messenger_wire", 1.0] == pytest.approx(15e3 / 0.97, rel=5e-4)


def test_an_overlap_has_devices_of_both_its_tension_lengths() -> None:
    base = arcless.load("ac-simple-overlap-275").line.to_dict()
    found = rest(on_weights(base), temperature_difference=-20.0)
    assert len(found.mesh.ends) == 8
    for (wire, _), tension in pulls(found).items():
        # The same.
        assert tension == pytest.approx(base[wire]["tension"] / 0.97, rel=5e-4)


def test_devices_that_cannot_decide_end_with_an_error() -> None:
    always = patch.object(SlidingEnds, "renew", lambda *_: True)
    with always, pytest.raises(EquilibriumError, match="start and stop without end"):
        rest(on_weights(stitched_data()), temperature_difference=5.0)


@pytest.mark.parametrize("scheme", ["generalised-alpha", "central-difference"])
def test_weights_are_as_good_as_anchors_to_waves(scheme: str) -> None:
    """Three times 15 kN over g are 4.6 t; a massless device of constant force is a loose end."""
    steps = {"solver__scheme": scheme, "pantographs": [{"model": "dsa-250", "static_force": 120.0}]}
    fine = {"solver__contact_wire_element": 0.5, "solver__messenger_wire_element": 0.5}

    def along(line: dict[str, Any]) -> Any:
        data = scenario_data(line, **steps, **fine, output={"points": [300.0]})
        x = arcless.run(load(data)).dataset["point_along"].values[:, 0]
        return np.diff(x, n=2)[: len(x) // 2]  # accelerations: waves of tension

    def line(kind: str) -> dict[str, Any]:
        return stitched_data(contact_wire__ends=kind, messenger_wire__ends=kind)

    anchored, free, heavy = (along(line(k)) for k in ("fixed", "constant_force", "weights"))
    # The weights swing at √(EA/LM)/2π = 0.5 Hz, where waves of 5 Hz and more are a hundred times
    # as fast in their acceleration.
    assert np.abs(heavy - anchored).std() < 0.05 * np.abs(free - anchored).std()
