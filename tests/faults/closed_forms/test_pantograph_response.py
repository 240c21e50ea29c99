"""What the checks of the pantograph's response notice."""

from collections.abc import Callable
from typing import Any

import pytest

from tests.support.run_faults import prepared_with, rider_scaled, spoiled
from tests.verification.closed_forms import test_pantograph_response as topic

Notice = Callable[..., None]


@pytest.mark.parametrize("matrix", ["mass", "stiffness"])
def test_matrix(noticed: Notice, matrix: str) -> None:
    with rider_scaled(matrix, 1.01):
        noticed(f"{matrix} 1 % high", topic.test_response, kind="roof")


def test_damping(noticed: Notice) -> None:
    with rider_scaled("damping", 1.01):
        noticed("damping 1 % high", topic.test_response, kind="free")


def test_contact(noticed: Notice) -> None:
    with prepared_with(contact_stiffness=lambda stiffness: 1.01 * stiffness):
        noticed("contact 1 % stiff", topic.test_response, kind="wavy wire")


def test_dropped_rate_of_the_roof(noticed: Notice) -> None:
    def still(arguments: dict[str, Any]) -> None:
        (head,) = arguments["riders"]
        forces, (carried, height, rate) = head[7]
        given = forces, (carried, height, [0.0 * value for value in rate])
        arguments["riders"] = [(*head[:7], given, *head[8:])]

    with spoiled(running=still):
        noticed("dampers do not feel the roof move", topic.test_response, kind="roof")


def test_coupling_of_the_masses(noticed: Notice) -> None:
    def turned(arguments: dict[str, Any]) -> None:
        (head,) = arguments["riders"]
        a, b, c, d = head[1]
        arguments["riders"] = [(head[0], [a, -b, -c, d], *head[2:])]

    with spoiled(running=turned):
        noticed("sign of the damper between the masses", topic.test_response, kind="free")
