"""Statics on the short line."""

from collections.abc import Callable

import numpy as np
import pytest

import arcless
from arcless.model import Scenario

Short = Callable[..., Scenario]


def test_to_dict_has_the_documented_keys(short: Short) -> None:
    found = arcless.statics(short()).to_dict()
    assert set(found) >= {
        "droppers",
        "supports",
        "elasticity",
        "elasticity_nonuniformity",
        "contact_wire_sag_m",
        "wave_speed_m_s",
        "natural_frequencies_Hz",
    }
    assert found["wave_speed_m_s"] == pytest.approx(np.sqrt(22e3 / 1.35))
    assert found["natural_frequencies_Hz"] == sorted(found["natural_frequencies_Hz"])
    assert len(found["droppers"]) == 30


def test_heights_asked_for_are_heights_found(short: Short) -> None:
    presag = [0.0, 0.015, 0.025, 0.015, 0.0]
    found = arcless.statics(short(**{"line.span_types.span.droppers.presag": presag})).equilibrium
    mesh = found.mesh
    lower = mesh.parts["links"]["nodes"][:, 1]
    heights = found.positions[lower, 2].reshape(6, 5)
    # Far below a millimetre; the equilibrium is solved to rounding.
    np.testing.assert_allclose(heights, 5.3 - np.tile(presag, (6, 1)), atol=1e-7)
    supports = [found.positions[s.contact_node, 2] for s in mesh.supports]
    assert supports[3] == pytest.approx(5.3, abs=0.01)


def test_tensions_are_those_asked_for(short: Short) -> None:
    found = arcless.statics(short()).equilibrium
    tension = found.arrays["wire_tension"]
    contact = found.mesh.parts["wires"]["mass"] == 1.35
    # Tension exceeds its horizontal part by half the slope squared: at the supports the messenger
    # has 0.08, the contact wire 0.01 and the local error of its elements.
    np.testing.assert_allclose(tension[contact], 22e3, rtol=3e-4)
    np.testing.assert_allclose(tension[~contact], 16e3, rtol=5e-3)


def test_symmetric_line_has_symmetric_forces(short: Short) -> None:
    found = arcless.statics(short())
    force = np.array([d["force_N"] for d in found.droppers])
    # The balance is found to about 1e-8 N of forces of some ten newtons.
    np.testing.assert_allclose(force, force[::-1], rtol=1e-6)
    assert np.all(force > 0)
    support = [s["messenger_force_N"] for s in found.supports]
    assert support[0] is None
    assert support[-1] is None
    line = found.scenario.line
    weight = 9.81 * (line.contact_wire.mass + line.messenger_wire.mass) * 50.0
    # Clamps have no mass here; the droppers' own weight and the wire's stretch are the rest.
    assert support[3] == pytest.approx(weight, rel=0.01)


def test_elasticity_is_least_near_the_supports(short: Short) -> None:
    found = arcless.statics(short())
    e = np.array(found.elasticity_m_per_N)
    # With an arm as soft as 300 N/m, at the first dropper rather than at the support itself.
    x = np.array(found.elasticity_x_m) % 50.0
    assert min(x[np.argmin(e)], 50.0 - x[np.argmin(e)]) <= 5.0
    assert e[50] > 1.5 * e[0]
    # Span 3 of 6 is not quite the middle, so its two sides differ a little.
    np.testing.assert_allclose(e, e[::-1], rtol=1e-4)
    expected = (e.max() - e.min()) / (e.max() + e.min())
    assert found.elasticity_nonuniformity == pytest.approx(expected)


def test_elasticity_for_a_force_that_slackens_a_dropper_is_higher(short: Short) -> None:
    found = arcless.statics(short()).equilibrium
    x = np.array([125.0])
    assert found.elasticity(x, 400.0)[0] > found.elasticity(x)[0]
    # The same linear solve with nothing slack.
    assert found.elasticity(x, 1.0)[0] == pytest.approx(found.elasticity(x)[0], rel=1e-9)


def test_as_built_lengths_lower_the_wire(short: Short) -> None:
    design = arcless.statics(short())
    rest = [d["unstretched_length_m"] for d in design.droppers if d["span"] == 3]
    longer = [length + 0.02 for length in rest]
    built = arcless.statics(short(**{"line.span_types.span.droppers.lengths": longer}))
    given = [d["unstretched_length_m"] for d in built.droppers if d["span"] == 3]
    assert given == pytest.approx(longer)
    drop = design.supports[3]["contact_wire_height_m"] - built.supports[3]["contact_wire_height_m"]
    # All droppers near the support lower their wire by 20 mm, so it follows as it is, but for what
    # the arm's stiffness holds back.
    assert drop == pytest.approx(0.02, abs=1e-4)


def test_as_built_may_start_slack(short: Short) -> None:
    design = arcless.statics(short())
    rest = [d["unstretched_length_m"] for d in design.droppers if d["span"] == 3]
    rest[2] += 0.3
    built = arcless.statics(short(**{"line.span_types.span.droppers.lengths": rest}))
    middle = [d["force_N"] for d in built.droppers if d["name"].endswith("dropper 3")]
    # Slack means zero; round-off only.
    assert middle == pytest.approx([0.0] * 6, abs=1e-9)


def test_progress_is_told(short: Short) -> None:
    told: list[float] = []
    arcless.statics(short(), progress=lambda fraction, _: told.append(fraction))
    assert told == sorted(told)
    assert told[-1] == 1.0
