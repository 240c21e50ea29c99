"""What the checks of the orders of chains of point masses notice."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from tests.support.faults import gravity, scaled, spoiled
from tests.verification.orders import test_element_length_point_masses as topic

Notice = Callable[..., None]


@pytest.mark.parametrize("model", ["point masses, planar", "point masses, spatial"])
def test_frequencies(noticed: Notice, model: str) -> None:
    with scaled("segments", "mass", 1.01):
        noticed(f"{model}: mass 1 % high", topic.test_frequencies, model=model)
    with scaled("bends", "EI", 1.01):
        noticed(f"{model}: EI 1 % high", topic.test_frequencies, model=model)


@pytest.mark.parametrize("model", ["point masses, planar", "point masses, spatial"])
def test_statics(noticed: Notice, model: str) -> None:
    with scaled("segments", "EA", 1.01):
        noticed(f"{model}: EA 1 % high", topic.test_statics, model=model)
    with gravity(1.01):
        noticed(f"{model}: gravity 1 % high", topic.test_statics, model=model)


def test_wind(noticed: Notice) -> None:
    with scaled("wire_loads", "across", -1.0):
        noticed("wind from the other side", topic.test_statics, model="point masses, spatial")


def test_bends_between_unequal_pieces(noticed: Notice) -> None:
    """A bend takes the mean of the pieces beside it; here that before it, where they differ."""

    def before(arguments: dict[str, Any]) -> bool:
        pieces = arguments["parts"]["segments"][1][:, 0]
        numbers, floats = arguments["parts"]["bends"]
        share = pieces[numbers[:, 0]] / pieces[numbers].mean(axis=1)
        floats[:, 0] *= share
        return bool(np.any(abs(share - 1.0) > 1e-6))

    with spoiled(before):
        what = "bends with the length of the piece before them"
        noticed(what, topic.test_frequencies, model="point masses, planar")
