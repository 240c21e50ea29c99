"""What the checks of the orders of cubic elements notice."""

from collections.abc import Callable

import pytest

from tests.support.faults import gravity, scaled
from tests.verification.orders import test_element_length_cubic as topic

Notice = Callable[..., None]


@pytest.mark.parametrize("model", ["cubic, planar", "cubic, spatial"])
def test_frequencies(noticed: Notice, model: str) -> None:
    # An error that refinement does not take away: the slope is that of a constant.
    with scaled("wires", "mass", 1.0001):
        noticed(f"{model}: mass 0.01 % high", topic.test_frequencies, model=model)


@pytest.mark.parametrize("model", ["cubic, planar", "cubic, spatial"])
def test_statics(noticed: Notice, model: str) -> None:
    with scaled("wires", "EA", 1.01):
        noticed(f"{model}: EA 1 % high", topic.test_statics, model=model)
    with gravity(1.001):
        noticed(f"{model}: gravity 0.1 % high", topic.test_statics, model=model)


def test_wind(noticed: Notice) -> None:
    with scaled("wire_loads", "across", -1.0):
        noticed("wind from the other side", topic.test_statics, model="cubic, spatial")


def test_bending(noticed: Notice) -> None:
    with scaled("wires", "EI", 1.01):
        noticed("EI 1 % high", topic.test_frequencies, model="cubic, planar")
        noticed("EI 1 % high", topic.test_statics, model="cubic, planar")
