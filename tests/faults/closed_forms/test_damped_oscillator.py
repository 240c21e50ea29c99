"""What the checks of the damped oscillator notice."""

from collections.abc import Callable

import pytest

from tests.support.faults import scaled
from tests.support.run_faults import prepared_with, rider_scaled
from tests.support.schemes import ALL, DEFAULT, Member
from tests.verification.closed_forms import test_damped_oscillator as topic

Notice = Callable[..., None]


@pytest.mark.parametrize("column", ["stiffness", "damping"])
def test_spring_of_the_line(noticed: Notice, column: str) -> None:
    with scaled("springs", column, 1.01):
        noticed(f"{column} of the spring 1 % high", topic.test_frequency_and_damping, scheme=ALL[0])


@pytest.mark.parametrize("matrix", ["mass", "damping", "stiffness"])
def test_matrix_of_the_rider(noticed: Notice, matrix: str) -> None:
    with rider_scaled(matrix, 1.01):
        what = f"{matrix} of the pantograph 1 % high"
        noticed(what, topic.test_frequency_and_damping, scheme=DEFAULT)


@pytest.mark.parametrize("scheme", [s for s in ALL if s.numbers], ids=lambda scheme: scheme.label)
def test_parameter_of_the_scheme(noticed: Notice, scheme: Member) -> None:
    def other(asked: tuple[str, list[float]]) -> tuple[str, list[float]]:
        return asked[0], [number + 0.001 for number in asked[1]]

    with prepared_with(scheme=other):
        what = f"{scheme.label}: parameters 0.001 high"
        noticed(what, topic.test_frequency_and_damping, scheme=scheme)


def test_step(noticed: Notice) -> None:
    with prepared_with(step=lambda h: 1.01 * h):
        noticed("step 1 % long", topic.test_what_20_hz_at_1_ms_costs)


def test_another_scheme(noticed: Notice) -> None:
    with prepared_with(scheme=lambda _asked: (DEFAULT.name, list(DEFAULT.numbers))):
        noticed("default scheme in place of the one asked for", topic.test_what_20_hz_at_1_ms_costs)
