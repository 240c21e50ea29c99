"""The low-pass of contact-force measurement as an instrument has it: forwards, sample by sample.

One pass of the Butterworth filter of `filter`, order 6, halves the power of a sine at the cut-off
and delays low frequencies by 0.62/f_c (the sum of 2 sin θ over its pairs of poles, divided by
2π f_c): 31 ms at 20 Hz. An assessment filters a whole record without delay; what a train knows
while it runs is this.
"""

import numpy as np
from numpy.typing import NDArray

from arcless import _core
from arcless.assess.signals import butterworth
from arcless.assess.signals.filter import ORDER
from arcless.errors import ModelError

Floats = NDArray[np.float64]


class RunningLowPass:
    """Low-pass of several signals side by side, continued from piece to piece.

    Parameters
    ----------
    cutoff_Hz, rate_Hz
        Where 3 dB are lost, and the rate of the samples, in Hz.
    signals
        Number of signals.

    Raises
    ------
    ModelError
        The cut-off is not between zero and half of the rate.
    """

    def __init__(self, cutoff_Hz: float, rate_Hz: float, signals: int) -> None:
        if not 0.0 < cutoff_Hz < 0.5 * rate_Hz:
            raise ModelError(
                "the low-pass frequency does not fit the rate",
                got=f"{cutoff_Hz:g} Hz",
                expected=f"above 0 and below half of the rate of {rate_Hz:g} Hz",
            )
        self._sections = butterworth.sections(ORDER, cutoff_Hz, rate_Hz)
        self._steady = butterworth.steady(self._sections)
        self._states = np.zeros((signals, *self._steady.shape))

    def begin(self, rows: NDArray[np.intp], values: Floats) -> None:
        """Begin some signals, given by their numbers, as if each had always had its value."""
        self._states[rows] = values[:, None, None] * self._steady

    def filtered(self, rows: NDArray[np.intp], pieces: Floats) -> Floats:
        """Return the next piece of some signals, filtered, a row for each."""
        states, found = self._states[rows], np.array(pieces, dtype=np.float64, order="C")
        _core.filter_on(self._sections, states, found)
        self._states[rows] = states
        return found
