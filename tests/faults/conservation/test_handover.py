"""The checks of overlaps notice another mass, and a force that is lost between the wires."""

from collections.abc import Callable
from unittest.mock import patch

from arcless.results import Result
from tests.support.run_faults import rider_scaled
from tests.verification.conservation import test_handover as checks

Noticed = Callable[..., None]


def _with_force(factor: float, wire: int) -> Callable[..., Result]:
    """Ride with the recorded force of one wire changed."""
    sound = checks.ride

    def ride(*arguments: object, **changes: object) -> Result:
        found = sound(*arguments, **changes)
        shares = found.dataset["wire_contact_force"]
        lost = (1.0 - factor) * shares[:, wire]
        shares[:, wire] = factor * shares[:, wire]
        found.dataset["contact_force"][:, 0] -= lost
        return found

    return ride


def test_a_force_a_thousandth_too_small(noticed: Noticed) -> None:
    with patch.object(checks, "ride", _with_force(0.999, 1)):
        noticed("force of the second wire 0.1 % too small", checks.test_momentum)


def test_base_without_its_preload(noticed: Noticed) -> None:
    def spoilt_sum(*arguments: object, **changes: object) -> Result:
        found = sound(*arguments, **changes)
        found.dataset["wire_contact_force"][:, 1] *= 0.999
        return found

    sound = checks.ride
    with patch.object(checks, "ride", spoilt_sum):
        noticed(
            "force of the second wire 0.1 % too small, sum as it was", checks.test_handover,
            shared=3, dimension="spatial",
        )  # fmt: skip


def test_a_rider_that_bounces(noticed: Noticed) -> None:
    with rider_scaled("mass", 30.0):
        noticed("thirty times the mass", checks.test_handover, shared=3, dimension="spatial")
