"""Faults that obstacles on both families of elements must notice."""

from collections.abc import Callable

import pytest

from tests.support.faults import scaled, unflexible
from tests.verification.closed_forms import test_obstacles as checks

Noticed = Callable[..., None]
TABLES = {"chain": "segments", "cubic": "wires"}


@pytest.mark.parametrize("name", TABLES)
def test_obstacle_off(noticed: Noticed, name: str) -> None:
    with scaled("springs", "stiffness", 1.02):
        noticed(f"{name}: spring 2 % too stiff", checks.test_spring, name=name, stiffness=5e3)
    with scaled("masses", "mass", 1.1):
        noticed(f"{name}: clamp 10 % too heavy", checks.test_mass, name=name, mass=0.2)


@pytest.mark.parametrize("name", TABLES)
def test_wire_off(noticed: Noticed, name: str) -> None:
    for column in ("tension", "mass"):
        with scaled(TABLES[name], column, 1.03):
            noticed(
                f"{name}: {column} of the wire 3 % too large",
                checks.test_spring, name=name, stiffness=5e3,
            )  # fmt: skip


def test_dropper_off(noticed: Noticed) -> None:
    with scaled("links", "stiffness", 1.04):
        noticed("dropper 4 % too stiff", checks.test_dropper, name="cubic")


def test_residual_flexibility_left_out(noticed: Noticed) -> None:
    with unflexible():
        noticed("no residual flexibility", checks.test_dropper, name="cubic")
