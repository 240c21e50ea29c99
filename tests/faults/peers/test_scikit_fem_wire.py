"""What the comparison of a stepped wire with scikit-fem notices."""

import pytest

from tests.support.faults import scaled
from tests.verification.peers import test_scikit_fem_wire as checked


@pytest.mark.parametrize(("kind", "column"), [("wires", "EI"), ("springs", "stiffness")])
def test_elasticity(noticed, kind: str, column: str) -> None:
    with scaled(kind, column, 1.01):
        noticed(f"{column} of {kind} 1 % too large", checked.test_elasticity)


@pytest.mark.parametrize("kind", ["wires", "masses"])
def test_frequencies(noticed, kind: str) -> None:
    with scaled(kind, "mass", 1.001):
        noticed(f"mass of {kind} 0.1 % too large", checked.test_frequencies)


def test_tension(noticed) -> None:
    with scaled("wires", "EA", 1.01):
        noticed("EA of the wires 1 % too large", checked.test_frequencies)
