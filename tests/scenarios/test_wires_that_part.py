"""Two contact wires that part and meet in plan, against the equilibrium of strings.

Under the tension T a wire that goes from y₀ to y₁ over the span L pulls its support aside by
T (y₁ − y₀)/L, whatever hangs on it. So a wire between +b/2 and −b/2 pulls an arm by 2 T b/L, and
one between b/2 and c/2 by T (b − c)/L, outwards at wide supports and inwards at narrow ones.
"""

from typing import Any

import numpy as np
import pytest

import arcless
from arcless.equilibrium.equilibrium import Equilibrium, find
from arcless.errors import ModelError
from arcless.model import load
from tests.support.line_types import scenario_data
from tests.support.overlaps import overlap_data, plain_data

SPAN, TENSION = 60.0, 15e3
# Without bending stiffness, which rounds the corner at a support over √(EI/T): strings.
# By a matrix, without the residual flexibility that explicit steps add.
STRING = {
    "contact_wire__bending_stiffness": 0.0,
    "solver__wire_model": "lumped",
    "solver__scheme": "generalised-alpha",
}
ARM = {"kind": "arm", "length": 1.0, "slope": 0.0, "mass": 0.0}


def data(separations: Any, **changes: Any) -> dict[str, Any]:
    """Return a scenario of six spans whose droppers hang upright where the wires meet."""
    solver = {name: changes.pop(name) for name in list(changes) if name.startswith("solver")}
    line = plain_data(6, twin_contact_wires=separations, **changes)
    return scenario_data(line, **solver)


def rest(separations: list[float], **changes: Any) -> Equilibrium:
    return find(load(data({"separations": separations}, **changes)))


def arms(found: Equilibrium) -> dict[str, tuple[float, float]]:
    """Return pull in N and side of the arms at the inner supports."""
    side = found.mesh.parts["struts"]["direction"][:, 1]
    return {
        place.name: (float(found.arrays["strut_tension"][row]), float(side[row]))
        for place in found.mesh.supports
        if (row := place.steady_arm) is not None
    }


# One dropper in the middle of each span: wires that cross there hang upright, and their pull is
# that of the wire alone.
MIDDLE = {"span_types__span__droppers": {"positions": [SPAN / 2], "presag": [0.0]}}


@pytest.mark.parametrize("apart", [0.1, 0.6])
def test_wires_that_cross_pull_their_arms_like_strings(apart: float) -> None:
    found = rest([apart, -apart], steady_arm=ARM, **MIDDLE, **STRING)
    expected = 2 * TENSION * apart / SPAN
    for name, (pull, side) in arms(found).items():
        # Rounding of the horizontal tension, which the design finds to 1e-7 N.
        assert pull == pytest.approx(expected, rel=1e-9), name
        first, wide = name.endswith("wire 1"), name.split()[1] in ("3", "5")
        assert side == (1.0 if first == wide else -1.0), name
    for nodes, sign in zip(found.mesh.contact_wires, (1.0, -1.0), strict=True):
        x, y, _ = found.positions[nodes].T
        places = SPAN * np.arange(7)
        drawn = np.interp(x, places, sign * 0.5 * apart * np.array([1, -1, 1, -1, 1, -1, 1]))
        np.testing.assert_allclose(y, drawn, atol=1e-9)


def test_wires_that_part_and_meet_are_pulled_to_both_sides() -> None:
    wide, narrow = 0.8, 0.1
    # Droppers lean to the messenger wire over the middle. One that carries F and is h high pulls
    # by F y/h; half of what the droppers of two spans take goes to the arm between.
    found = rest([wide, narrow], steady_arm=ARM, **MIDDLE, **STRING)
    force = found.of_droppers("link_tension")
    vector = [
        found.positions[d.nodes[0]] - found.positions[d.nodes[1]] for d in found.mesh.droppers
    ]
    across = {
        d.name: f * v[1] / np.linalg.norm(v)
        for d, f, v in zip(found.mesh.droppers, force, vector, strict=True)
    }
    for name, (pull, side) in arms(found).items():
        number, wire = int(name.split()[1]), name.split()[-1]
        outwards = 1.0 if wire == "1" else -1.0
        leaning = sum(across[f"span {n} dropper 1 wire {wire}"] for n in (number - 1, number)) / 2
        is_wide = number % 2 == 1
        kink = outwards * (1.0 if is_wide else -1.0) * TENSION * (wide - narrow) / SPAN
        assert side * pull == pytest.approx(kink - leaning, rel=1e-6), name


def test_equal_separations_are_one_separation() -> None:
    spatial = {"solver__dimension": "spatial"}
    one = find(load(data({"separation": 0.2}, **spatial)))
    list_ = rest([0.2, 0.2])
    np.testing.assert_array_equal(one.positions, list_.positions)


def test_wires_that_cross_are_their_own_mirror_image() -> None:
    found = rest([0.4, -0.4])
    force = found.of_droppers("link_tension")
    # The balance is found to about 1e-8 N.
    np.testing.assert_allclose(force[0::2], force[1::2], atol=1e-6)


def test_the_pattern_counts_from_the_first_support_of_the_line() -> None:
    line = overlap_data(twin_contact_wires={"separations": [0.2, -0.2]}, overlap__separation=0.0)
    found = find(load(scenario_data(line)))
    y = {s.name: float(found.positions[s.contact_node, 1]) for s in found.mesh.supports}
    # Support 6 of the line is the sixth: the second of the pattern, in both tension lengths.
    assert y["tension length 1 support 6 wire 1"] == pytest.approx(-0.1)
    assert y["tension length 2 support 6 wire 1"] == pytest.approx(-0.1)


def test_a_flat_crossing_is_felt_like_wires_side_by_side() -> None:
    """Slopes in plan of 0.1/60 change lengths and forces by their square, 3e-6."""
    travel = {"speed": "200 km/h", "travel": {"start": 70.0, "end": 140.0}}
    forces = [
        arcless.run(load({**data(twin, solver__dimension="spatial"), **travel})).dataset[
            "contact_force"
        ]
        for twin in ({"separation": 0.1}, {"separations": [0.1, -0.1]})
    ]
    side_by_side, crossing = (force.values for force in forces)
    assert side_by_side.std() > 5.0
    # Droppers of some 0.8 m lean by up to 0.05 m: 0.2 % of what each yields, along the wave.
    assert np.abs(crossing - side_by_side).max() < 0.005 * side_by_side.max()


@pytest.mark.parametrize(
    ("twin", "changes", "message"),
    [
        ({"separation": 0.1, "separations": [0.1, 0.2]}, {}, "both separation and separations"),
        ({}, {}, "twin_contact_wires.separation: missing field"),
        ({"separations": [0.1]}, {}, "twin_contact_wires.separations"),
        ({"separations": [0.1, 3.0]}, {}, "twin_contact_wires.separations.1"),
        ({"separations": [0.1, 0.2]}, {"steady_arm": {"kind": "none"}}, "nothing holds the wires"),
        ({"separations": [0.1, 0.2]}, {"solver__dimension": "planar"}, "solver.dimension"),
        ({"separation": 0.1, "droppers": "alternating"}, MIDDLE, "wire hangs on nothing"),
    ],
)
def test_refused(twin: dict[str, Any], changes: dict[str, Any], message: str) -> None:
    with pytest.raises(ModelError, match=message.replace(".", r"\.")):
        load(data(twin, **changes))
