"""What the comparison with scikit-fem notices: with the same elements, nearly everything."""

import pytest

from tests.support.faults import gravity, scaled
from tests.verification.peers import test_scikit_fem_line as checked


@pytest.mark.parametrize("column", ["EA", "EI", "mass"])
def test_wires(noticed, column: str) -> None:
    with scaled("wires", column, 1.0 + 1e-4):
        noticed(f"{column} of the wires 1e-4 too large", checked.test_same_elements)


@pytest.mark.parametrize("kind", ["links", "springs"])
def test_springs(noticed, kind: str) -> None:
    with scaled(kind, "stiffness", 1.0 + 1e-4):
        noticed(f"stiffness of {kind} 1e-4 too large", checked.test_same_elements)


def test_gravity(noticed) -> None:
    with gravity(1.0 + 1e-4):
        noticed("gravity 1e-4 too large", checked.test_same_elements)


def test_half_as_many_elements(noticed) -> None:
    coarse = checked.designed
    try:
        checked.designed = lambda contact, messenger: coarse(2 * contact, 2 * messenger)
        checked.shipped.cache_clear()
        noticed("elements twice as long", checked.test_elements_of_the_shipped_case)
    finally:
        checked.designed = coarse
        checked.shipped.cache_clear()
