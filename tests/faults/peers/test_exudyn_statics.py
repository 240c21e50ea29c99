"""What the comparison with Exudyn at rest notices."""

from tests.support.faults import gravity, scaled
from tests.verification.peers import test_exudyn_statics as checked


def test_wires_too_stiff(noticed) -> None:
    with scaled("wires", "EA", 1.001):
        noticed("EA of the wires 0.1 % too high", checked.test_tensions_are_nominal)


def test_wires_too_heavy(noticed) -> None:
    with scaled("wires", "mass", 1.001):
        noticed("mass of the wires 0.1 % too high", checked.test_line_hangs_as_designed)


def test_wires_bend_less(noticed) -> None:
    with scaled("wires", "EI", 0.9):
        noticed("EI of the wires 10 % too low", checked.test_line_hangs_as_designed)


def test_supports_too_stiff(noticed) -> None:
    with scaled("springs", "stiffness", 1.001):
        noticed("springs 0.1 % too stiff", checked.test_tensions_are_nominal)


def test_less_gravity(noticed) -> None:
    with gravity(0.999):
        noticed("gravity 0.1 % too low", checked.test_line_hangs_as_designed)
