"""The check of halved meshes notices a step that is far too long."""

from collections.abc import Callable
from typing import Any

from arcless.results import Result
from tests.support import fresh
from tests.verification.orders import test_halving as checks

Noticed = Callable[..., None]


def test_a_step_of_10_ms(noticed: Noticed, run_once: Callable[..., Result]) -> None:
    def coarse(name: str, changes: dict[str, Any] | None = None) -> Result:
        if "solver.time_step" in (changes or {}):
            # Explicit steps refuse to be so long: with a matrix.
            far = {"solver.scheme": "generalised-alpha", "solver.time_step": 10e-3}
            return fresh.run(name, {**(changes or {}), **far})
        return run_once(name, changes)

    noticed(
        "10 ms where 0.5 ms should be", checks.test_halving, run_once=coarse,
        scenario="en50318-2002-250", refined="time step",
    )  # fmt: skip
