"""Lines with gradients, and lines whose heights were measured: statics and runs."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from arcless.equilibrium import equilibrium
from arcless.errors import EquilibriumError
from arcless.model import Scenario, load
from arcless.model.as_built.measured_heights import measured_places
from arcless.results import Result

Short = Callable[..., Scenario]
Run = Callable[..., Result]
CHANGES = "line.geometry.height_changes"
HEIGHTS = "as_built.measured_heights"
BOTH_MODELS = pytest.mark.parametrize("wire_model", ["hermite", "lumped"])


def ramp(scenario: Scenario, gradient: float) -> dict[str, Any]:
    """A uniform gradient over the whole line."""
    count = len(scenario.line.support_positions())
    end = scenario.line.geometry.contact_wire_height + gradient * scenario.line.total_length
    return {CHANGES: [{"from_support": 1, "to_support": count, "height": end}]}


def contact_heights(found: equilibrium.Equilibrium) -> np.ndarray:
    return np.asarray(found.positions[found.mesh.contact_nodes, 2])


@BOTH_MODELS
@pytest.mark.parametrize("gradient", [0.001, 0.02])
def test_a_uniform_gradient_shears_the_line(short: Short, wire_model: str, gradient: float) -> None:
    """With the horizontal tension given, H z″ = q ds/dx: adding g x to z changes the weight of a
    metre of track alone, by ½ g² + g z′ of it; the second part has two signs in a span.
    """
    level = short(**{"solver.wire_model": wire_model})
    flat = equilibrium.find(level)
    steep = equilibrium.find(level.with_(**ramp(level, gradient)))
    x = flat.positions[flat.mesh.contact_nodes, 0]
    sheared = contact_heights(flat) + gradient * x
    # Between droppers, at which it is held, the contact wire sags by 8 mm with slopes of 3e-3.
    np.testing.assert_allclose(
        contact_heights(steep), sheared, rtol=0, atol=0.01 * gradient * (3e-3 + gradient)
    )
    # The messenger wire sags by q L²/8T = 0.47 m with slopes up to 0.04.
    lengths = steep.of_droppers("link_length") - flat.of_droppers("link_length")
    assert np.abs(lengths).max() < 0.47 * gradient * (0.04 + gradient)
    assert np.ptp(contact_heights(steep)) > 0.9 * gradient * level.line.total_length - 0.1


@BOTH_MODELS
def test_the_wire_hangs_at_the_measured_heights(short: Short, wire_model: str) -> None:
    scenario = short(**{"solver.wire_model": wire_model})
    places = measured_places(scenario.line)
    rng = np.random.default_rng(4)
    heights = {x: 5.3 + float(rng.uniform(-2e-3, 2e-3)) for x in places}
    rows = [{"position": x, "height": h} for x, h in heights.items()]
    found = equilibrium.find(scenario.with_(**{HEIGHTS: rows}))
    x = found.positions[found.mesh.contact_nodes, 0]
    at = [int(np.argmin(np.abs(x - place))) for place in places]
    # Lengths are found for these heights; the service equilibrium repeats them to rounding.
    np.testing.assert_allclose(
        contact_heights(found)[at], list(heights.values()), rtol=0, atol=1e-8
    )
    assert (found.of_droppers("link_tension") > 0).all()


def test_a_rail_lies_at_its_measured_heights() -> None:
    """Its supports hold it; there are no droppers."""
    scenario = load("conductor-rail-1-120")
    places = measured_places(scenario.line)
    rows = [{"position": x, "height": 5 + 1e-3 * (i % 3)} for i, x in enumerate(places)]
    found = equilibrium.find(scenario.with_(**{HEIGHTS: rows}))
    x = found.positions[found.mesh.contact_nodes, 0]
    at = [int(np.argmin(np.abs(x - place))) for place in places]
    exact = [row["height"] for row in rows]
    # The lengths were found for these heights; rounding, over 1e2 N/m.
    np.testing.assert_allclose(contact_heights(found)[at], exact, rtol=0, atol=1e-8)


def test_a_survey_of_the_design_finds_the_design(short: Short) -> None:
    scenario = short()
    design = equilibrium.find(scenario)
    x = design.positions[design.mesh.contact_nodes, 0]
    rows = []
    for place in measured_places(scenario.line):
        node = int(np.argmin(np.abs(x - place)))
        rows.append({"position": place, "height": float(contact_heights(design)[node])})
    again = equilibrium.find(scenario.with_(**{HEIGHTS: rows}))
    for name in ("link_rest_length", "link_tension"):
        # Arms that hold the wire where it hangs by itself carry rounding.
        np.testing.assert_allclose(
            again.of_droppers(name), design.of_droppers(name), rtol=1e-6, atol=1e-6
        )


def test_heights_that_no_dropper_can_hold_name_the_readings(short: Short) -> None:
    scenario = short()
    places = list(measured_places(scenario.line))
    rows = [{"position": x, "height": 5.3} for x in places]
    rows[5]["height"] = 5.25
    with pytest.raises(EquilibriumError) as caught:
        equilibrium.find(scenario.with_(**{HEIGHTS: rows}))
    message = str(caught.value)
    assert "would have to push" in message
    assert f"5.25 m at {places[5]:g} m" in message
    assert "measured were" in message


def test_a_run_begins_at_the_local_height(run: Run, short: Short) -> None:
    flat, steep = run(), run(**ramp(short(), 0.001))
    first = [float(r.dataset["contact_height"][0, 0]) for r in (flat, steep)]
    start = float(flat.dataset["position"][0, 0])
    # Heights of the wire differ by the ramp alone; the uplift at the start is that of the level
    # line but for second order. The force begins as on the level and not with that of a pantograph
    # that starts 60 mm below: contact stiffness times that would be 3 kN. In the first step the
    # head is hit by a wire that rises with V g = 0.06 m/s.
    assert first[1] - first[0] == pytest.approx(0.001 * start, abs=2e-4)
    force = [float(r.dataset["contact_force"][0, 0]) for r in (flat, steep)]
    assert force[1] == pytest.approx(force[0], abs=5.0)


def test_on_a_gradient_the_mean_force_differs_by_the_base_damper(run: Run, short: Short) -> None:
    """A pantograph lifted steadily with V g pulls down with c V g; without a base spring that is
    all: M has no part in it, nor have the springs between masses.
    """
    gradient, damping = 0.002, 400.0
    model = short().to_dict()["pantographs"][0]["model"]
    model["masses"][0] |= {"stiffness": 0.0, "damping": damping}
    speed = {"speed": 20.0, "pantographs.0.model": model}
    flat, steep = run(**speed), run(**speed, **ramp(short(), gradient))
    means = []
    for result in (flat, steep):
        position = result.dataset["position"].values[:, 0]
        inside = (position >= 100) & (position <= 150)
        means.append(result.dataset["contact_force"].values[inside, 0].mean())
    # Whole spans, so that what changes along a span averages out; what is left is the start, where
    # the pantograph stands still on the gradient, and second order.
    assert means[0] - means[1] == pytest.approx(damping * 20.0 * gradient, abs=0.4)
