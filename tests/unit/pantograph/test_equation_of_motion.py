"""Matrices of a pantograph, and the vector that raises its strips."""

from typing import Any

import numpy as np
import pytest

from arcless.model import load_pantograph
from arcless.pantograph.equation_of_motion import matrices, raising_the_strips
from arcless.simulate.setup import pantographs

Data = dict[str, Any]
MASS: Data = {"mass": 9.0, "stiffness": 160.0, "damping": 100.0}
STRIP: Data = {"half_length": 0.8, "mass": 3.75, "stiffness": 3500.0, "damping": 22.5}
PLACES = np.linspace(-0.8, 0.8, 9)
BENDING: Data = {
    "shape_positions": PLACES.tolist(),
    "modes": [{"frequency": 60, "modal_mass": 1.9, "shape": (np.cos(2 * PLACES) - 0.4).tolist()}],
}
ROLL: Data = {"roll": {"inertia": 0.8, "stiffness": 1700.0, "damping": 11.0}}
HEADS = [
    {**STRIP, "strips": 1},
    {**STRIP, "strips": 2, "strip_spacing": 0.5, **ROLL},
    {**STRIP, "strips": 3, "strip_spacing": 0.5, **ROLL, **BENDING},
]


def test_a_chain_of_two_masses() -> None:
    lower = {"mass": 15.0, "stiffness": 50.0, "damping": 90.0}
    upper = {"mass": 7.2, "stiffness": 4200.0, "damping": 10.0}
    found = matrices(load_pantograph({"name": "two", "masses": [lower, upper]}))
    np.testing.assert_array_equal(found.mass, [[15.0, 0.0], [0.0, 7.2]])
    np.testing.assert_array_equal(found.stiffness, [[4250.0, -4200.0], [-4200.0, 4200.0]])
    np.testing.assert_array_equal(found.damping, [[100.0, -10.0], [-10.0, 10.0]])


@pytest.mark.parametrize("head", HEADS)
def test_the_strips_are_raised_as_the_core_feels_them(head: Data) -> None:
    model = load_pantograph({"name": "head", "masses": [MASS], "head": head})
    strips = pantographs.data(model, 0.0).strips
    middle = [[np.interp(0.0, one.knots, row) for row in np.array(one.vectors).T] for one in strips]
    # The middle is a knot of the shapes: rounding.
    np.testing.assert_allclose(raising_the_strips(model), np.mean(middle, axis=0), atol=1e-14)
