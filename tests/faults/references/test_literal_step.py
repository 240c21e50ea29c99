"""What the check of a run against the literal step of the founding paper notices."""

from collections.abc import Callable
from typing import Any

from tests.support.faults import gravity, scaled
from tests.support.run_faults import prepared_with, rider_scaled, spoiled
from tests.support.schemes import DEFAULT
from tests.verification.references import test_literal_step as topic

Notice = Callable[..., None]
TOUCHING = {"force": 150.0, "opens": False}
LEAVING = {"force": 20.0, "opens": True}


def test_another_method(noticed: Notice) -> None:
    with prepared_with(updated=lambda updated: not updated):
        noticed("kinematics about the state at rest", topic.test_every_step, **TOUCHING)
    with prepared_with(scheme=lambda _: (DEFAULT.name, list(DEFAULT.numbers))):
        noticed("another scheme", topic.test_every_step, **TOUCHING)
    with prepared_with(contact_stiffness=lambda _: 1e9):
        noticed("a contact that yields by 1 nm/N", topic.test_every_step, **LEAVING)


def test_another_line(noticed: Notice) -> None:
    with scaled("segments", "EA", 1.0001):
        noticed("EA 0.01 % high", topic.test_every_step, **TOUCHING)
    with scaled("bends", "EI", 1.001):
        noticed("EI 0.1 % high", topic.test_every_step, **TOUCHING)
    with gravity(1.001):
        noticed("weight 0.1 % high", topic.test_every_step, **LEAVING)


def test_another_pantograph(noticed: Notice) -> None:
    with rider_scaled("damping", 1.001):
        noticed("dampers 0.1 % high", topic.test_every_step, **LEAVING)

    def without_friction(arguments: dict[str, Any]) -> None:
        arguments["friction"] = 0.0

    with spoiled(running=without_friction):
        noticed("no friction", topic.test_every_step, **TOUCHING)
