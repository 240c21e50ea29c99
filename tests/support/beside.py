"""A run and test runs of the same force along the line: every offset and deviation is known."""

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from arcless.model import load
from arcless.results import Result
from tests.support.measured import write
from tests.support.synthetic import SPAN_M, scenario_data, synthetic_dataset

Floats = NDArray[np.float64]

SPEED = 20.0  # m/s, of the run
SECTION = (200.0, 400.0)
# Waves along the line: amplitude in N, waves in a metre. At 20 m/s 0.4, 2 and 8 Hz; whole waves in
# the section.
PERIODIC = ((20.0, 1.0 / SPAN_M), (12.0, 0.1), (6.0, 0.4))
# What is not the same in every span: an amplitude in N, and waves of 70 m.
OWN = ((9.0, 1.0 / 70.0),)


def along(
    x: Floats, waves: Sequence[tuple[float, float]] = PERIODIC + OWN, mean: float = 100.0
) -> Floats:
    """Return the force in N at places in m."""
    return mean + sum(size * np.sin(2.0 * np.pi * count * x) for size, count in waves)


def run(
    force: Callable[[Floats], Floats] = along,
    *,
    scenario: dict[str, Any] | None = None,
    **more: Any,
) -> Result:
    """Return a run of 600 m at 20 m/s with a force that is known along the line."""
    data = scenario_data(**(scenario or {}))
    made = synthetic_dataset(
        force=lambda t: force(SPEED * t), scenario=data, section=SECTION,
        height=lambda t: 5.3 + 0.02 * np.cos(2.0 * np.pi * SPEED * t / SPAN_M), **more,
    )  # fmt: skip
    return Result(made, load(data))


def test_run(
    path: Path,
    force: Callable[[Floats], Floats] = along,
    *,
    offset_m: float = 0.0,
    drift: float = 0.0,
    begin_m: float = 100.0,
    end_m: float = 500.0,
    speed: float = SPEED,
    rate: float = 200.0,
    noise_N: float = 0.0,
    seed: int = 1,
    falling: bool = False,
    kept: Callable[[Floats], NDArray[np.bool_]] | None = None,
    **columns: Floats,
) -> Path:
    """Write a test run whose odometer shows `offset_m` too much at its first sample.

    `drift` is what it shows too much for each metre; `kept` says which samples are in the file.
    """
    time = np.arange(int((end_m - begin_m) / speed * rate) + 1) / rate
    true = begin_m + speed * time
    shown = true + offset_m + drift * (true - begin_m)
    shown = 1000.0 - shown if falling else shown
    noise = noise_N * np.random.default_rng(seed).standard_normal(time.size)
    table = {
        "time [s]": time, "position [m]": shown, "speed [m/s]": np.full(time.size, speed),
        "contact_force [N]": force(true) + noise,
        "contact_height [m]": 5.3 + 0.02 * np.cos(2.0 * np.pi * true / SPAN_M), **columns,
    }  # fmt: skip
    rows = np.ones(time.size, bool) if kept is None else kept(true)
    return write(path, {name: values[rows] for name, values in table.items()})


test_run.__test__ = False  # type: ignore[attr-defined]
