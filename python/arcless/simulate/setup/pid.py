"""PID, sample by sample."""

import math
from collections.abc import Callable

from arcless.model.pantograph.controller import Pid
from arcless.simulate.setup.stops_and_friction import Numbers

Limit = Callable[[float], float]


class PidLaw:
    """PID with a low-pass on the measurement; the integral waits while the force is at a limit."""

    def __init__(self, pid: Pid, sample_time: float) -> None:
        self._pid, self._step = pid, sample_time
        self._share = 1.0 if pid.filter == 0 else -math.expm1(-sample_time / pid.filter)
        self._measured: float | None = None
        self._error: float | None = None
        self._integral = 0.0

    def __call__(self, measured: float, limit: Limit) -> float:
        """Return the limited force in N for a measured contact force in N."""
        pid, old = self._pid, self._measured
        self._measured = measured if old is None else old + self._share * (measured - old)
        error = pid.target - self._measured
        rate = 0.0 if self._error is None else (error - self._error) / self._step
        self._error = error
        fixed = pid.proportional * error + pid.derivative * rate
        integral = self._integral + pid.integral * self._step * error
        wanted = fixed + integral
        given = limit(wanted)
        # Integrating on while a limit holds would have to be integrated back later.
        if (wanted - given) * error <= 0.0:
            self._integral = integral
            return given
        return limit(fixed + self._integral)

    def numbers(self) -> Numbers:
        """Return the state of the law."""
        known = self._measured is not None
        return [float(known), self._measured or 0.0, self._error or 0.0, self._integral]

    def put_back(self, numbers: Numbers) -> None:
        """Restore the state that `numbers` returned."""
        known, measured, error, self._integral = numbers
        self._measured, self._error = (measured, error) if known else (None, None)
