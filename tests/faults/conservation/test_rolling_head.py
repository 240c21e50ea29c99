"""The check of a rolling head notices an energy that is not booked."""

from collections.abc import Callable
from unittest.mock import patch

import arcless
from arcless.results import Result
from tests.verification.conservation import test_rolling_head as checks

Noticed = Callable[..., None]


def test_a_fault_of_the_core_stands_in_the_list_of_mutations(noticed: Noticed) -> None:
    """What can be spoiled at the border moves both sides of the ledger; so spoil the record."""
    sound = arcless.run

    def leaking(*arguments: object, **named: object) -> Result:
        found = sound(*arguments, **named)
        work = float(abs(found.dataset["energy_work_traction"].values[-1]))
        turned = float(abs(found.dataset["energy_work_uplift"].values).max())
        found.dataset.attrs["energy_residual_relative"] = work / turned
        return found

    with patch.object(arcless, "run", leaking):
        noticed("work of traction not booked", checks.test_ledger, scheme="trapezoidal")
