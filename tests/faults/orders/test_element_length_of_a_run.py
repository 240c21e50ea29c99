"""What the checks of the order of a run in element length notice."""

from collections.abc import Callable
from typing import Any

import pytest

from tests.support.faults import spoiled
from tests.verification.orders import test_element_length_of_a_run as topic

Notice = Callable[..., None]


@pytest.mark.parametrize(
    ("model", "table"), [("cubic, planar", "wires"), ("point masses, planar", "segments")]
)
def test_mass_that_goes_with_the_mesh(noticed: Notice, model: str, table: str) -> None:
    """A constant error cancels between meshes; one that the reference alone has does not."""
    column = {"wires": 3, "segments": 2}[table]

    def heavy(arguments: dict[str, Any]) -> bool:
        rows = arguments["parts"][table][1]
        is_finest = len(rows) == topic.FINEST
        if is_finest:
            rows[:, column] *= 1.05
        return is_finest

    with spoiled(heavy):
        what = f"{model}: mass of the finest mesh 5 % high"
        noticed(what, topic.test_order, model=model, kind="stiff wire")


def test_no_bending(noticed: Notice) -> None:
    def limp(arguments: dict[str, Any]) -> None:
        arguments["parts"]["wires"][1][:, 2] = 0.0

    with spoiled(limp):
        what = "bending of cubic elements dropped"
        noticed(what, topic.test_order, model="cubic, planar", kind="stiff wire")


def test_no_bends(noticed: Notice) -> None:
    def limp(arguments: dict[str, Any]) -> None:
        arguments["parts"]["bends"][1][:, 0] = 0.0

    with spoiled(limp):
        what = "bending of chains dropped"
        noticed(what, topic.test_order, model="point masses, planar", kind="stiff wire")
