"""Faults that forces at rest on both families of elements must notice."""

from collections.abc import Callable
from unittest.mock import patch

from tests.support import hung_beams
from tests.support.faults import scaled, unflexible
from tests.verification.closed_forms import test_force_at_rest as checks

Noticed = Callable[..., None]


def test_wire_off(noticed: Noticed) -> None:
    for column, factor in (("tension", 1.001), ("EI", 1.05)):
        with scaled("wires", column, factor):
            noticed(f"{column} × {factor}", checks.test_bare_wire, name="cubic")


def test_dropper_off(noticed: Noticed) -> None:
    with scaled("links", "stiffness", 1.02):
        for check in (checks.test_lift_at_droppers, checks.test_slow_push_at_droppers):
            noticed("droppers 2 % too stiff", check, name="cubic", count=1)


def test_residual_flexibility_left_out(noticed: Noticed) -> None:
    with unflexible():
        noticed("no residual flexibility", checks.test_bare_wire, name="cubic")
        noticed("no residual flexibility", checks.test_lift_at_droppers, name="cubic", count=2)


def test_second_dropper_forgotten(noticed: Noticed) -> None:
    whole = hung_beams.Hung

    def one(wires: object, links: list[object]) -> hung_beams.Hung:
        return whole(wires, links[:1])  # type: ignore[arg-type]

    with patch.object(checks, "Hung", one):
        noticed("closed form of one dropper", checks.test_lift_at_droppers, name="cubic", count=2)
