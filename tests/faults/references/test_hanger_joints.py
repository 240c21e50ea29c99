"""The checks of the founding paper's conclusions notice hangers without effect."""

from collections.abc import Callable

from arcless.results import Result
from tests.support import fresh
from tests.verification.references import test_hanger_joints as checks

Noticed = Callable[..., None]

# A wire of next to no weight, which no hanger's force can bend, on hangers that hold next to
# nothing and joints without mass.
NO_EFFECT = {
    "line.dropper.clamp_mass_contact_wire": 0.0,
    "line.dropper.stiffness": 36.0,
    "line.contact_wire.mass": 0.05,
}


def test_hangers_without_effect(noticed: Noticed, run_once: Callable[..., Result]) -> None:
    def without(name: str, _: object = None) -> Result:
        return fresh.run(name, NO_EFFECT)

    broken = fresh.only(without, "praks-360", run_once)
    noticed("hangers that have no effect, 360 km/h", checks.test_conclusions, run_once=broken)
