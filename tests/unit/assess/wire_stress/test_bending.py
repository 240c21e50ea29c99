"""Bending of a stiff string at a point force, against a finely divided beam under tension."""

from math import pi, sqrt

import numpy as np
import pytest

from arcless.assess.wire_stress.bending import StiffString
from arcless.errors import ModelError
from arcless.model.line.parts.components import TensionedWire
from arcless.model.line.wire_section import WireSection
from arcless.model.shipped.wire_catalogue import catalogue

WIRE = TensionedWire(
    mass=1.07, axial_stiffness=14.4e6, bending_stiffness=137.5, tension=20e3, diameter=0.0132
)


def string(tension: float = 20e3) -> StiffString:
    section = WireSection.of(WIRE)
    assert section is not None
    return StiffString(section, tension, WIRE.mass)


def beam_curvature(wire: StiffString, element: float, force: float, speed: float = 0.0) -> float:
    """Curvature at a force in the middle of 8 m of cubic elements, both ends on supports.

    The mesh is moved with the force: a steady motion feels T − μ v².
    """
    count = 2 * round(4.0 / element)
    le, t, ei = 8.0 / count, wire.moving_tension(speed), wire.section.bending_stiffness
    bending = ei / le**3 * np.array(
        [[12, 6 * le, -12, 6 * le], [6 * le, 4 * le**2, -6 * le, 2 * le**2],
         [-12, -6 * le, 12, -6 * le], [6 * le, 2 * le**2, -6 * le, 4 * le**2]]
    )  # fmt: skip
    pulling = t / (30 * le) * np.array(
        [[36, 3 * le, -36, 3 * le], [3 * le, 4 * le**2, -3 * le, -(le**2)],
         [-36, -3 * le, 36, -3 * le], [3 * le, -(le**2), -3 * le, 4 * le**2]]
    )  # fmt: skip
    size = 2 * (count + 1)
    stiffness, load = np.zeros((size, size)), np.zeros(size)
    for k in range(count):
        at = slice(2 * k, 2 * k + 4)
        stiffness[at, at] += bending + pulling
    load[count] = force
    free = [i for i in range(size) if i not in (0, size - 2)]
    w = np.zeros(size)
    w[free] = np.linalg.solve(stiffness[np.ix_(free, free)], load[free])
    w1, s1, w2, s2 = w[count - 2 : count + 2]
    return float((6 * w1 - 6 * w2) / le**2 + (2 * s1 + 4 * s2) / le)  # at the end of the element


@pytest.mark.parametrize("speed", [0.0, 60.0])
def test_the_curvature_is_that_of_a_beam_under_tension(speed: float) -> None:
    wire, force = string(), 100.0
    section = wire.section
    fine = beam_curvature(wire, 0.005, force, speed)
    expected = -section.modulus * section.half_height * fine
    # The curvature of cubic elements is in error by (λℓ)²/12 at an end: 2e-4 here.
    assert force * wire.stress_per_newton(speed) == pytest.approx(expected, rel=1e-3)
    assert wire.stress_per_newton(60.0) > 1.05 * wire.stress_per_newton()


def test_elements_of_a_run_miss_the_layer() -> None:
    wire = string()
    exact = -beam_curvature(wire, 0.005, 100.0)
    found = {size: -beam_curvature(wire, size, 100.0) / exact for size in (0.5, 0.25, 0.1, 0.05)}
    # What the guide says of elements of half a metre and a quarter.
    assert found[0.5] == pytest.approx(0.50, abs=0.01) and found[0.25] == pytest.approx(
        0.73, abs=0.01
    )
    assert found[0.1] < 0.95
    assert sorted(found.values()) == [found[size] for size in (0.5, 0.25, 0.1, 0.05)]


def test_the_moment_is_that_of_half_the_corner() -> None:
    """M = √(T EI) θ with θ = P/(2 T) on each side."""
    wire, force = string(), 80.0
    section = wire.section
    moment = sqrt(wire.tension * section.bending_stiffness) * force / (2.0 * wire.tension)
    curvature = moment / section.bending_stiffness
    expected = section.modulus * section.half_height * curvature
    assert force * wire.stress_per_newton() == pytest.approx(expected, rel=1e-12)
    assert wire.layer() == pytest.approx(sqrt(137.5 / 20e3))


def test_a_force_as_fast_as_waves_has_no_stress() -> None:
    with pytest.raises(ModelError, match="below the wave speed, 492 km/h"):
        string().stress_per_newton(140.0)


def test_catalogue_wires_have_the_area_of_their_name() -> None:
    unround: list[str] = []
    for name, wire in catalogue().wires.items():
        digits = "".join(c if c.isdigit() else " " for c in name).split()
        section = WireSection.of(
            TensionedWire(tension=1e4, **wire.model_dump(exclude={"description"}))
        )
        if section is None:
            unround.append(name)
            continue
        # Strands are called by a round number, of 65.8 mm² by 70; stiffnesses are rounded.
        assert 1e6 * section.area == pytest.approx(float(digits[-1]), rel=0.065), name
    # Strands whose EI is that of sliding wires.
    assert "St180" in unround and "Cu AC-100" not in unround


def test_a_stated_area_gives_the_modulus() -> None:
    section = WireSection.of(WIRE, 1.2e-4)
    assert section is not None and section.stated
    assert section.modulus == pytest.approx(120e9)
    assert section.half_height == 0.0066
    no_diameter = WireSection.of(WIRE.model_copy(update={"diameter": None}), 1.2e-4)
    assert no_diameter is not None
    assert no_diameter.half_height == pytest.approx(sqrt(1.2e-4 / pi))
    assert WireSection.of(WIRE.model_copy(update={"bending_stiffness": 0.0})) is None
    with pytest.raises(ModelError, match=r"got 1\.2e\+08 mm²"):
        WireSection.of(WIRE, 120.0)  # mm² meant
