"""The checks of weights notice what is wrong with friction, mass, anchor or wire."""

from collections.abc import Callable
from unittest.mock import patch

from arcless.mesh.build.wires_and_droppers import Wiring
from arcless.model import Wire
from arcless.model.line.parts.midpoint_anchor import MidpointAnchor
from tests.support.faults import misbuilt, scaled
from tests.verification.closed_forms import test_tensioning_weights as checks

Noticed = Callable[..., None]
HELD, START = reversed(checks.ANCHORS)


def test_friction_1_percent_low(noticed: Noticed) -> None:
    with patch.object(Wire, "end_band", property(lambda w: (0.98 * w.tension, w.tension / 0.98))):
        noticed(
            "η 0.98 for 0.97", checks.test_a_device_with_friction_slides, difference=40.0, case=HELD
        )


def test_friction_that_pulls_with_the_motion(noticed: Noticed) -> None:
    with patch.object(Wire, "end_band", property(lambda w: (w.tension, w.tension / 0.97))):
        noticed(
            "no friction where the wire grows longer",
            checks.test_a_device_with_friction_slides,
            difference=3.0,
            case=START,
        )


def test_devices_that_never_hold_still(noticed: Noticed) -> None:
    with patch.object(Wire, "has_friction", False):
        noticed("friction left out", checks.test_a_device_with_friction_holds_still, difference=1.0)


def test_an_anchor_one_support_off(noticed: Noticed) -> None:
    known = Wiring._midpoint

    def midpoint(self: Wiring, anchor: MidpointAnchor) -> float:
        return known(self, anchor) + 40.0

    with patch.object(Wiring, "_midpoint", midpoint):
        noticed(
            "anchor at support 7 of 11",
            checks.test_a_device_with_friction_slides,
            difference=-40.0,
            case=HELD,
        )


def test_expansion_1_percent_high(noticed: Noticed) -> None:
    with misbuilt("length_factor", lambda factor: 1.0 + 1.01 * (factor - 1.0)):
        for difference, check, more in (
            (1.0, checks.test_a_device_with_friction_holds_still, {}),
            (-40.0, checks.test_a_device_with_friction_slides, {"case": START}),
        ):
            noticed("wires expand 1 % too much", check, difference=difference, **more)


def test_a_mass_without_the_square_of_the_ratio(noticed: Noticed) -> None:
    with patch.object(Wire, "end_mass", property(lambda w: w.tension / 9.81)):
        noticed("weights felt as n m", checks.test_mass_of_the_weights_along_the_wire)
    with scaled("masses", "mass", 0.98):
        noticed("weights 2 % light", checks.test_mass_of_the_weights_along_the_wire)
