"""Statics and runs of a line that is not as designed."""

from collections.abc import Callable
from math import pi
from typing import Any

import numpy as np
import pytest

import arcless
from arcless.equilibrium import equilibrium
from arcless.errors import EquilibriumError
from arcless.mesh.build.alteration import worn_bending
from arcless.model import Scenario

Short = Callable[..., Scenario]

WIRES = ("contact_wire", "messenger_wire")
FREE_ENDS: dict[str, Any] = {f"line.{wire}.ends": "constant_force" for wire in WIRES}
BOTH_MODELS = pytest.mark.parametrize("wire_model", ["hermite", "lumped"])


def tensions(found: equilibrium.Equilibrium) -> dict[str, float]:
    """Dropper forces in N by name."""
    names = [dropper.name for dropper in found.mesh.droppers]
    return dict(zip(names, found.of_droppers("link_tension").tolist(), strict=True))


def heights(found: equilibrium.Equilibrium) -> np.ndarray:
    """Height of the contact wire at each dropper in m."""
    lower = found.mesh.parts["links"]["nodes"][[d.link for d in found.mesh.droppers], 1]
    return np.asarray(found.positions[lower, 2])


def carried(found: equilibrium.Equilibrium) -> float:
    """Force in N with which droppers and steady arms carry the contact wire."""
    nodes = found.mesh.parts["springs"]["node"]
    arms = np.isin(nodes, found.mesh.contact_nodes)
    return float(sum(tensions(found).values()) + found.arrays["spring_force"][arms].sum())


@BOTH_MODELS
def test_neighbours_take_the_load_of_a_broken_dropper(short: Short, wire_model: str) -> None:
    base = {"solver.wire_model": wire_model, "line.dropper.mass": 0.0}
    gone = "span 3 dropper 3"
    whole = equilibrium.find(short(**base))
    broken = equilibrium.find(short(**base, **{"as_built.missing_droppers": [gone]}))
    before, after = tensions(whole), tensions(broken)
    assert set(before) - set(after) == {gone}
    # The far ends of the contact wire, two spans away, feel little of it; the partner, a force that
    # nobody takes over, would be the whole of it.
    assert carried(broken) == pytest.approx(carried(whole), abs=0.02 * before[gone])
    gained = {name: force - before[name] for name, force in after.items()}
    beside = gained["span 3 dropper 2"] + gained["span 3 dropper 4"]
    assert beside > 0.6 * before[gone]
    assert gained["span 3 dropper 2"] == pytest.approx(gained["span 3 dropper 4"], rel=0.02)
    assert abs(gained["span 6 dropper 5"]) < 0.01 * before[gone]


def test_height_follows_one_length_error_as_elasticity_says(short: Short) -> None:
    at = "span 3 dropper 3"
    error = 0.5e-3
    change = [{"span": 3, "dropper": 3, "length_error": error}]
    design = equilibrium.find(short())
    longer = equilibrium.find(short(**{"as_built.dropper_length_errors": change}))
    without = equilibrium.find(short(**{"as_built.missing_droppers": [at]}))
    index = next(i for i, d in enumerate(design.mesh.droppers) if d.name == at)
    drop = heights(design)[index] - heights(longer)[index]
    lost = tensions(design)[at] - tensions(longer)[at]
    x = np.array([design.mesh.droppers[index].x])
    softer = without.elasticity(x)[0] - design.elasticity(x)[0]
    # With a, b, c the flexibilities of both clamps without the dropper and s = a + b − 2c + 1/k,
    # the dropper takes (a − c)²/s off the elasticity; a length error δ is a pair of forces δ/s that
    # lowers the wire by (a − c) δ/s. So drop² = δ · lost force · difference of elasticities.
    # Its removal lowers the wire by 30 mm and changes the tensions by 0.1 %: hence 1 %.
    assert drop == pytest.approx(np.sqrt(error * lost * softer), rel=0.01)
    # The partner: a messenger wire that does not yield, so that the wire sinks by the whole error.
    assert drop < 0.75 * error


def test_small_length_errors_add_up(short: Short) -> None:
    def sunk(*errors: tuple[int, int, float]) -> np.ndarray:
        rows = [{"span": s, "dropper": d, "length_error": e} for s, d, e in errors]
        found = equilibrium.find(short(**{"as_built.dropper_length_errors": rows}))
        return heights(found) - heights(equilibrium.find(short()))

    first, second = sunk((3, 3, 1e-3)), sunk((3, 4, -1e-3))
    both = sunk((3, 3, 1e-3), (3, 4, -1e-3))
    # 1 mm in 1 m of dropper and 10 m between droppers: what is not linear is of order 1e-3.
    np.testing.assert_allclose(both, first + second, atol=2e-6)
    assert np.abs(both - first).max() > 2e-4, "the partner: the second one alone is missing"


def lifted(*errors: tuple[int, float]) -> dict[str, Any]:
    rows = [{"support": number, "height_error": error} for number, error in errors]
    return {"as_built.support_height_errors": rows}


def at_supports(found: equilibrium.Equilibrium) -> np.ndarray:
    """Height of the contact wire at each support in m."""
    return np.asarray(found.positions[[place.contact_node for place in found.mesh.supports], 2])


@BOTH_MODELS
@pytest.mark.parametrize("kind", ["spring", "arm"])
def test_supports_in_a_ramp_shear_the_line(short: Short, wire_model: str, kind: str) -> None:
    """With every support higher by g x nothing else changes: see `test_heights`."""
    model: dict[str, Any] = {"solver.wire_model": wire_model}
    if kind == "arm":
        arm = {"kind": "arm", "length": 1.2, "slope": 0.2, "mass": 0.8}
        model |= {"line.steady_arm": arm, "line.geometry.stagger_contact_wire": [0.2, -0.2]}
    gradient = 1e-4
    drawn = equilibrium.find(short(**model))
    x = np.array([place.x for place in drawn.mesh.supports])
    rows = [(number, gradient * x[number - 1]) for number in range(2, len(x))]
    built = equilibrium.find(short(**model, **lifted(*rows)))
    rise = at_supports(built) - at_supports(drawn)
    # The last span comes down to its anchor, which stays as drawn, 30 mm in all: a kink of 6e-4
    # that both wires carry into the spans beside it. Three spans away a thousandth is left.
    np.testing.assert_allclose(rise[1:4], gradient * x[1:4], atol=2e-3 * gradient * x[-1])
    assert rise[0] == rise[-1] == 0.0


def test_the_wire_follows_its_support(short: Short) -> None:
    drawn, error = equilibrium.find(short()), 10e-3
    built = equilibrium.find(short(**lifted((4, error))))
    rise = at_supports(built) - at_supports(drawn)
    # The messenger wire does, as a string with a tip. The contact wire hangs from it 5 m to either
    # side, where 1 − 5/50 of the tip is left; there the kink of the contact wire pulls with some
    # 22 kN · 9 mm/45 m = 4 N at a dropper, under which the messenger wire yields by 1 mm.
    assert 0.75 * error < rise[3] < 0.9 * error
    np.testing.assert_allclose(rise[[2, 4]], 0.0, atol=0.1 * error)
    np.testing.assert_allclose(rise[[1, 5]], 0.0, atol=0.02 * error)


def test_errors_of_supports_do_not_depend_on_the_mesh(short: Short) -> None:
    errors = lifted((2, 8e-3), (3, -5e-3), (4, 3e-3), (6, -9e-3))
    finer = {"solver.contact_wire_element": "0.5 m", "solver.messenger_wire_element": "0.7 m"}
    rises = [
        at_supports(equilibrium.find(short(**mesh, **errors)))
        - at_supports(equilibrium.find(short(**mesh)))
        for mesh in ({}, finer)
    ]
    # Cubic elements of some metres: bending near the supports, a few per cent of the kinks there.
    np.testing.assert_allclose(rises[1], rises[0], atol=0.1e-3)


def test_a_rail_follows_its_supports() -> None:
    base = arcless.load("conductor-rail-1-120")
    drawn = equilibrium.find(base)
    rows = [(number, 1e-3) for number in range(2, len(drawn.mesh.supports))]
    built = equilibrium.find(base.with_(**lifted(*rows)))
    rise = at_supports(built) - at_supports(drawn)
    # A beam on supports that all stand higher: but for its ends it is lifted as it is.
    np.testing.assert_allclose(rise[6:-6], 1e-3, atol=1e-6)


@BOTH_MODELS
def test_free_ends_travel_and_keep_the_tension(short: Short, wire_model: str) -> None:
    model = {"solver.wire_model": wire_model, "as_built.temperature_difference": 40.0}
    found = arcless.statics(short(**model, **FREE_ENDS))
    held = arcless.statics(short(**model))
    assert found.as_built is not None
    assert held.as_built is not None
    for wire, tension in zip(WIRES, (22e3, 16e3), strict=True):
        # Travel of a straight wire, 17e-6 · 40 K · 300 m; the sag's own growth is 1e-3 of it.
        travel = found.as_built[f"{wire}_end_travel_m"]
        assert travel == pytest.approx(17e-6 * 40.0 * 300.0, rel=5e-3)
        assert found.as_built[f"{wire}_tension_N"] == pytest.approx(tension, rel=1e-3)
        assert held.as_built[f"{wire}_end_travel_m"] == 0.0
        assert held.as_built[f"{wire}_tension_N"] < 0.8 * tension
    design = equilibrium.find(short()).of_droppers("link_rest_length")
    rest = found.equilibrium.of_droppers("link_rest_length")
    if wire_model == "hermite":
        # A product and its quotient, lengths kept with some 1e-12 m.
        np.testing.assert_allclose(rest / design, 1.0 + 17e-6 * 40.0, rtol=1e-9)


def test_ice_is_weight_and_inertia(short: Short) -> None:
    base = {**FREE_ENDS, "line.steady_arm": {"kind": "none"}}
    clear = arcless.statics(short(**base))
    iced = arcless.statics(short(**base, **{"as_built.ice.contact_wire": 0.3}))
    # Wave speeds go with the lowest tension along the wire, which a heavier wire lowers by up to
    # 0.1 %.
    assert iced.wave_speed == pytest.approx(clear.wave_speed * np.sqrt(1.35 / 1.65), rel=2e-3)
    loads = [tensions(found.equilibrium) for found in (iced, clear)]
    more = sum(loads[0][d] - loads[1][d] for d in loads[1] if d.startswith(("span 3", "span 4")))
    # Two spans in the middle of six: what lies between their droppers hangs on them.
    assert more == pytest.approx(0.3 * 9.81 * 100.0, rel=0.03)
    ratio = np.array(clear.natural_frequencies_Hz[:3]) / np.array(iced.natural_frequencies_Hz[:3])
    # Both wires swing in the lowest modes: 2.73/2.43 of the mass; the partner is weight alone.
    np.testing.assert_allclose(ratio, np.sqrt(2.73 / 2.43), rtol=0.02)


SPATIAL = {
    "solver.dimension": "spatial",
    "line.contact_wire.diameter": "12 mm",
    "line.messenger_wire.diameter": "11 mm",
}


@BOTH_MODELS
def test_wind_blows_the_wires_off(short: Short, wire_model: str) -> None:
    model = {**SPATIAL, **FREE_ENDS, "solver.wire_model": wire_model}
    found = equilibrium.find(short(**model, **{"as_built.wind.speed": 25.0}))
    # Both wires between the supports of a 50 m span, which hold them: y = Σq L²/8ΣT. Droppers tie
    # them together, but loads and tensions share alike only in part: a few per cent.
    force = 0.5 * 1.225 * 625.0 * (0.012 + 0.011)
    expected = force * 50.0**2 / (8.0 * (22e3 + 16e3))
    middle = [found.mesh.contact_nodes, found.mesh.messenger_nodes]
    blown = [found.positions[nodes][:, 1].max() for nodes in middle]
    assert np.average(blown, weights=[22.0, 16.0]) == pytest.approx(expected, rel=0.05)
    # Mirrored arithmetic gives the mirrored numbers; the rest is room for another processor.
    opposite = equilibrium.find(short(**model, **{"as_built.wind.speed": -25.0}))
    np.testing.assert_allclose(opposite.positions[:, 1], -found.positions[:, 1], atol=1e-7)
    calm = equilibrium.find(short(**model))
    assert np.abs(calm.positions[:, 1]).max() < 1e-9, "the partner: no wind"


def test_a_worn_wire_is_lighter_and_faster(short: Short) -> None:
    worn = [{"from": "0 m", "to": "300 m", "fraction": 0.2}]
    new = arcless.statics(short(**FREE_ENDS))
    old = arcless.statics(short(**FREE_ENDS, **{"as_built.contact_wire_wear": worn}))
    # All of the wire alike: only its mass counts for the wave, not its stiffness.
    # Where wires sag less, inclined droppers take 0.8 % of the tension; the partner is 11 % off.
    assert old.wave_speed == pytest.approx(new.wave_speed / np.sqrt(0.8), rel=1e-2)
    assert carried(old.equilibrium) < 0.85 * carried(new.equilibrium)


def test_wear_counts_by_the_share_of_an_element(short: Short) -> None:
    worn = [{"from": 100.0, "to": 100.5, "fraction": 0.4}]
    found = equilibrium.find(short(**{"as_built.contact_wire_wear": worn}))
    mass = found.arrays["wire_mass"][found.mesh.contact_rows]
    lost = (1.35 - mass) * found.arrays["wire_rest_length"][found.mesh.contact_rows]
    # 0.5 m of 0.4 · 1.35 kg/m, counted along the wire as it lies stretched.
    assert lost.sum() == pytest.approx(0.27, rel=2e-3)
    assert np.count_nonzero(lost > 1e-9) == 1


def test_bending_stiffness_of_a_worn_circle() -> None:
    # A cut of 1e-9 of the area moves EI by its power 2/3.
    assert worn_bending(1e-9) == pytest.approx(1.0, abs=1e-6)
    # Half a circle about its own centre: π/8 − 8/9π, from any handbook.
    assert worn_bending(0.5) == pytest.approx((pi / 8 - 8 / (9 * pi)) / (pi / 4), rel=1e-9)
    assert worn_bending(0.2) < 0.8**2, "less than a smaller circle of that section"


def test_an_error_longer_than_the_dropper_is_refused(short: Short) -> None:
    change = [{"span": 3, "dropper": 3, "length_error": "-1.5 m"}]
    with pytest.raises(EquilibriumError, match="span 3 dropper 3 has no length left"):
        equilibrium.find(short(**{"as_built.dropper_length_errors": change}))


def test_a_run_on_the_line_as_built(short: Short) -> None:
    change: dict[str, Any] = {
        "as_built.missing_droppers": ["span 3 dropper 3"],
        "as_built.temperature_difference": "20 K",
        "as_built.contact_wire_wear": [{"from": "100 m", "to": "160 m", "fraction": 0.1}],
    }
    for extra in ({}, {"solver.wire_model": "lumped"}, {"solver.kinematics": "updated"}):
        whole = arcless.run(short(**extra)).dataset
        built = arcless.run(short(**extra, **change)).dataset
        assert "span 3 dropper 3" not in built.dropper.values
        assert built.sizes["dropper"] == whole.sizes["dropper"] - 1
        force = built.contact_force.values
        assert np.all(np.isfinite(force))
        # It starts in equilibrium on the altered line; in the first step kinks of lumped wires
        # add 5 N. The partner: from the design, 30 mm higher, it would be 1.5 kN.
        assert force[0, 0] == pytest.approx(80.0, abs=6.0)
        assert built.contact_height[0, 0] < whole.contact_height[0, 0] - 0.02
        assert np.abs(force - whole.contact_force.values).max() > 5.0


def test_a_run_in_the_wind(short: Short) -> None:
    model = {**SPATIAL, "travel": {"start": "100 m", "end": "150 m"}, "analysis": {}}
    built = arcless.run(short(**model, **{"as_built.wind.speed": 20.0})).dataset
    found = equilibrium.find(short(**model, **{"as_built.wind.speed": 20.0}))
    static = found.positions[found.mesh.contact_nodes]
    expected = np.interp(built.position.values[:, 0], static[:, 0], static[:, 1])
    # The collector meets the wire where the wind holds it; linear between nodes: well below 1 mm.
    np.testing.assert_allclose(built.contact_lateral.values[:, 0], expected, atol=1e-3)
    assert expected.max() > 0.03
