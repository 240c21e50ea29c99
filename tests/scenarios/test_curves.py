"""Lines in curves against closed forms: offsets, forces of steady arms, and the tension's part."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from arcless.equilibrium import equilibrium
from arcless.errors import EquilibriumError, ModelError
from arcless.model import Scenario, load
from arcless.results import Result
from tests.support.line_types import compound_data, scenario_data, stitched_data
from tests.support.overlaps import overlap_data

Short = Callable[..., Scenario]
Run = Callable[..., Result]
RADIUS, SPAN = 1200.0, 50.0
ARM = {"kind": "arm", "length": 1.2, "slope": "8 deg"}
EVERYWHERE: dict[str, Any] = {"from": -1000, "to": 5000, "radius": RADIUS, "side": "left"}
BOTH_MODELS = pytest.mark.parametrize("wire_model", ["hermite", "lumped"])


def curved(curve: dict[str, Any] | None = None, stagger: tuple[float, ...] = (0.0,)) -> Any:
    """Droppers hang in the plane of both wires where these have one stagger: the offset L²/8R does
    not depend on the tension.
    """
    return {
        "line.track": {"curves": [curve or EVERYWHERE]},
        "line.steady_arm": ARM,
        "line.geometry.stagger_contact_wire": list(stagger),
        "line.geometry.stagger_messenger_wire": list(stagger),
    }


def middle(found: equilibrium.Equilibrium, nodes: list[int], span: int = 2) -> float:
    """Lateral position of a wire in the middle of a span (from 0)."""
    points = found.positions[nodes]
    x = (span + 0.5) * SPAN
    return float(np.interp(x, points[:, 0], points[:, 1]))


def arms(found: equilibrium.Equilibrium) -> np.ndarray:
    """Lateral force of each steady arm in N, positive to the left."""
    rows = [s.steady_arm for s in found.mesh.supports if s.steady_arm is not None]
    pull = found.mesh.parts["struts"]["direction"][rows, 1]
    return np.asarray(found.arrays["strut_tension"][rows] * pull)


@BOTH_MODELS
def test_wires_lie_to_the_inside_and_arms_pull_to_the_outside(
    short: Short, wire_model: str
) -> None:
    scenario = short(**curved(), **{"solver.wire_model": wire_model})
    found = equilibrium.find(scenario)
    tension = scenario.line.contact_wire.tension
    assert scenario.line.span_list()[0].length == SPAN
    # (y′, z′)² ≤ (L/2R)² + 0.06² changes lengths, and so the offset, by 2e-3; a chain of straight
    # segments follows the load on its nodes alone: (3 m / 50 m)² = 4e-3 of the offset more. A
    # contact wire with bending stiffness rounds the kink at a support over √(EI/T) = 0.1 m, of
    # cubic elements an eighth of their length, δ = 0.2 m: 4δ/L of the offset less.
    offset = SPAN**2 / (8 * RADIUS)
    assert middle(found, found.mesh.messenger_nodes) == pytest.approx(offset, rel=6e-3)
    assert middle(found, found.mesh.contact_nodes) == pytest.approx(offset, rel=1.5e-2)
    # The load on droppers' clamps is shared, and each wire carries its own T/R.
    np.testing.assert_allclose(arms(found)[1:-1], -tension * SPAN / RADIUS, rtol=3e-3)


@BOTH_MODELS
def test_stagger_adds_its_own_part(short: Short, wire_model: str) -> None:
    most = 0.2
    scenario = short(**curved(stagger=(most, -most)), **{"solver.wire_model": wire_model})
    found = equilibrium.find(scenario)
    tension = scenario.line.contact_wire.tension
    by_stagger = 4 * most * tension / SPAN
    # Supports 3 and 5 stand at +0.2 m, support 4 at -0.2 m. Tolerance as above.
    expected = np.array([1, -1, 1]) * by_stagger - tension * SPAN / RADIUS
    np.testing.assert_allclose(arms(found)[1:4], expected, rtol=5e-3)
    assert (np.sign(expected) == [-1, -1, -1]).all(), "all arms pull to the outside"
    assert (found.arrays["strut_tension"] > 0).all()


def test_with_its_transitions_a_curve_turns_by_what_the_arms_hold(short: Short) -> None:
    curve = {**EVERYWHERE, "from": 90, "to": 220, "side": "right", "transition": 40, "cant": 0.1}
    scenario = short(**curved(curve))
    found = equilibrium.find(scenario)
    held, tension = arms(found), scenario.line.contact_wire.tension
    # Cant comes and goes: in all, the axis turns by ∫ ds/R, and the arms carry T times that.
    assert held.sum() == pytest.approx(tension * (130 - 40) / RADIUS, rel=3e-3)
    flat = equilibrium.find(short(**curved({**curve, "cant": 0.0})))
    assert np.abs(held - arms(flat)).max() > 0.02 * held.max(), "the axis swings on the ramps"


def on_arc(found: equilibrium.Equilibrium, nodes: list[int]) -> None:
    """κ x (L − x)/2 in every span. The contact wire rounds its kinks at the supports by 4δ/L of the
    offset L²/8R, see above, with δ = 0.2 to 0.4 m, and droppers pull the other wires there with it.
    """
    length = found.mesh.supports[1].x
    x = np.mod(found.positions[nodes, 0], length)
    arc = x * (length - x) / (2 * RADIUS)
    # The droppers' pull, see above.
    np.testing.assert_allclose(found.positions[nodes, 1], arc, rtol=0, atol=3e-2 * arc.max())


def test_every_wire_of_a_compound_line_lies_on_the_same_arc() -> None:
    bent = compound_data(track={"curves": [EVERYWHERE]}, steady_arm=ARM)
    found = equilibrium.find(load(scenario_data(bent)))
    for nodes in (
        found.mesh.contact_nodes,
        found.mesh.messenger_nodes,
        found.mesh.auxiliary_nodes,
    ):
        on_arc(found, nodes)


def test_a_stitch_wire_cuts_the_corner_of_its_support() -> None:
    bent = stitched_data(track={"curves": [EVERYWHERE]}, steady_arm=ARM)
    found = equilibrium.find(load(scenario_data(bent)))
    on_arc(found, found.mesh.contact_nodes)
    # Droppers lean to the stitch wire, which is 0.2 m to the inside: 3 % more than T L/R.
    np.testing.assert_allclose(arms(found)[1:-1], -15e3 * 60.0 / RADIUS, rtol=5e-2)
    stitch = found.mesh.stitches[2]
    y = found.positions[stitch.nodes, 1]
    # From clamp to clamp it runs past the support, at which the messenger wire is held at y = 0, on
    # an arc of its own: κ 18²/8 = 34 mm, less or more as the droppers on it lean.
    assert y.min() == pytest.approx(y[0], abs=1e-9)
    assert 0.5 * 0.034 < y.max() - y[0] < 2.0 * 0.034


def test_twin_wires_and_overlaps_bend_with_the_track() -> None:
    line = overlap_data(track={"curves": [EVERYWHERE]}, steady_arm=ARM)
    found = equilibrium.find(load(scenario_data(line)))
    straight = equilibrium.find(load(scenario_data(overlap_data(steady_arm=ARM))))
    mesh = found.mesh
    x = mesh.positions[mesh.contact_nodes, 0]
    moved = found.positions[mesh.contact_nodes, 1] - straight.positions[mesh.contact_nodes, 1]
    length = mesh.supports[1].x - mesh.supports[0].x
    along = np.mod(x, length)
    arc = along * (length - along) / (2 * RADIUS)
    # The contact wire rounds its kinks at the supports: 4δ/L with δ up to 0.4 m.
    np.testing.assert_allclose(moved, arc, rtol=0, atol=5e-2 * arc.max())


def test_left_and_right_are_mirror_images(short: Short) -> None:
    left = equilibrium.find(short(**curved()))
    right = equilibrium.find(short(**curved({**EVERYWHERE, "side": "right"})))
    # Newton's method stops at rounding of the forces; of the shape, that is below a nanometre.
    np.testing.assert_allclose(left.positions[:, 1], -right.positions[:, 1], rtol=0, atol=1e-8)
    np.testing.assert_allclose(left.positions[:, 2], right.positions[:, 2], rtol=0, atol=1e-8)


def test_a_colder_wire_pulls_harder_into_the_curve(short: Short) -> None:
    """The load goes with the tension, so the offset stays and the arms carry more."""
    ends = {f"line.{wire}_wire.ends": "fixed" for wire in ("contact", "messenger")}
    warm = equilibrium.find(short(**curved(), **ends))
    cold = equilibrium.find(short(**curved(), **ends, **{"as_built.temperature_difference": -20}))
    ratio = cold.mean_tensions()[0] / warm.mean_tensions()[0]
    assert ratio > 1.15
    # Half a per cent: tensions differ a little along the line, droppers pull at arms that moved.
    assert arms(cold)[2] / arms(warm)[2] == pytest.approx(ratio, rel=1e-2)
    offset = middle(warm, warm.mesh.contact_nodes)
    assert middle(cold, cold.mesh.contact_nodes) == pytest.approx(offset, rel=2e-2)


def test_wind_blows_on_top_of_the_curve(short: Short) -> None:
    wires = {f"line.{wire}_wire.diameter": "12 mm" for wire in ("contact", "messenger")}
    calm = equilibrium.find(short(**curved(), **wires))
    blown = equilibrium.find(short(**curved(), **wires, **{"as_built.wind.speed": 20}))
    load = 0.5 * 1.225 * 400 * 0.012
    tension = calm.mean_tensions()[0]
    moved = middle(blown, blown.mesh.contact_nodes) - middle(calm, calm.mesh.contact_nodes)
    # w L²/8T of the contact wire alone; the messenger wire, less tight, drags it a little.
    assert moved == pytest.approx(load * SPAN**2 / (8 * tension), rel=0.2)


def test_a_run_through_a_curve_records_where_the_wire_lies(run: Run) -> None:
    result = run(**curved())
    lateral = result.dataset["contact_lateral"].values[:, 0]
    offset = SPAN**2 / (8 * RADIUS)
    # 5 %: the wire rounds its kinks at the supports, see above.
    assert lateral.max() == pytest.approx(offset, rel=0.05)
    assert abs(lateral.min()) < 0.1 * offset


def test_explicit_steps_see_the_same_curve(run: Run) -> None:
    fine = {"solver.contact_wire_element": 0.5, "solver.messenger_wire_element": 0.6}
    tight = curved({**EVERYWHERE, "radius": 500}) | {"line.steady_arm": {**ARM, "slope": 0}}
    matrix, steps = (
        run(**tight, **fine, **way).dataset
        for way in ({"solver.residual_flexibility": True}, {"solver.scheme": "central-difference"})
    )
    heights = [data["contact_height"].values[:, 0] for data in (matrix, steps)]
    count = min(map(len, heights))
    apart = np.abs(heights[0][:count] - heights[1][:count])
    # A share of what lifting is; two families.
    assert apart.max() < 2e-3, apart.max()
    assert np.ptp(heights[0]) > 20e-3, "the partner: it moves"


def test_planar_models_have_no_curves(short: Short) -> None:
    with pytest.raises(ModelError, match="stagger, curves, hinged"):
        equilibrium.find(
            short(
                **{
                    "line.track": {"curves": [EVERYWHERE]},
                    "solver.dimension": "planar",
                }
            )
        )


def test_an_arm_that_would_push_is_named(short: Short) -> None:
    """Stagger and curve cancel up to 1 % of the tension's part; the messenger wire, half a metre
    to the outside, pulls the contact wire there through the droppers.
    """
    cancel = SPAN**2 / (4 * RADIUS) * 0.995
    pattern = [cancel, 0.0]
    changes = curved(stagger=(0.0,)) | {
        "line.geometry.stagger_contact_wire": pattern,
        "line.geometry.stagger_messenger_wire": [-0.5],
    }
    with pytest.raises(EquilibriumError, match="steady arm at support 3 would have to push"):
        equilibrium.find(short(**changes))


def test_a_steep_arm_that_lifts_the_wire_in_a_curve_is_named(short: Short) -> None:
    """T L/R = 22 kN · 50/450 = 2.4 kN, of which tan 8° lifts: more than hangs there."""
    tight = {**EVERYWHERE, "radius": 450}
    with pytest.raises(EquilibriumError, match="would have to push") as caught:
        equilibrium.find(short(**curved(tight, stagger=(-0.3,))))
    message = str(caught.value)
    assert "the steady arm at support 2 pulls with some 2444 N" in message
    assert "lifts the wire by 344 N, more than the" in message
    assert "try a flatter arm, steady_arm.slope below some" in message
    flat = curved(tight, stagger=(-0.3,))
    flat["line.steady_arm"] = {**ARM, "slope": 0}
    assert (equilibrium.find(short(**flat)).of_droppers("link_tension") > 0).all()
