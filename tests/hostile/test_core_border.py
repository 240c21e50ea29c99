"""What was found at the border of the compiled module, called without the layers before it."""

import signal
import time
from functools import cache
from types import FrameType

import pytest

from arcless import _core
from arcless.equilibrium import equilibrium
from tests.support.small import small


@cache
def line() -> equilibrium.Equilibrium:
    return equilibrium.find(small(**{"solver.scheme": "generalised-alpha"}))


@pytest.mark.parametrize("count", [1001, 10**6, 2**63, 2**64 - 1])
def test_too_many_frequencies_are_refused(count: int) -> None:
    with pytest.raises(_core.NativeError, match="at most 1000"):
        line().core.frequencies(count)


def test_frequencies_can_be_interrupted() -> None:
    def stop(_number: int, _frame: FrameType | None) -> None:
        raise KeyboardInterrupt

    before = signal.signal(signal.SIGALRM, stop)
    began = time.monotonic()
    signal.setitimer(signal.ITIMER_REAL, 0.3)
    try:
        with pytest.raises(KeyboardInterrupt):
            line().core.frequencies(1000)
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0.0)
        signal.signal(signal.SIGALRM, before)
    assert time.monotonic() - began < 10.0


@pytest.mark.parametrize("step_s", [1e308, 1e100, 1e-200, 0.0, -1e-3, float("nan")])
def test_steps_that_no_line_takes_are_refused(step_s: float) -> None:
    scheme = ("trapezoidal", [])
    with pytest.raises(_core.NativeError, match="solver"):
        line().core.prepare(line().mesh.lanes, scheme, step_s, 5e4, updated=False)
