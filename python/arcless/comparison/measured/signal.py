"""Channel of one pantograph along the line, simulated or measured."""
# ruff: noqa: N815 - the names carry their units

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from arcless.assess.signals.filter import low_pass, spectrum_of
from arcless.assess.signals.gapped import stretches
from arcless.comparison.alignment import Trace

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]


@dataclass(frozen=True, eq=False)
class Signal:
    """Samples of one pantograph, piece behind piece, all at one time step.

    Attributes
    ----------
    position_m
        Positions on the line in m, rising.
    values
        Of the channel, unfiltered: contact force in N, or height of the contact point in m.
    rate_Hz
        Samples in a second.
    pieces
        Stretches without a gap.
    counted
        Samples that count: those in the section, and away from gaps.
    speed_m_s
        Mean speed in m/s.
    """

    position_m: Floats
    values: Floats
    rate_Hz: float
    pieces: Sequence[slice]
    counted: Flags
    speed_m_s: float

    def low_passed(self, cutoff_Hz: float) -> Floats:
        """Return the channel after a low-pass, piece by piece: nothing reaches over a gap.

        Raises
        ------
        ModelError
            The cut-off is not below half the rate.
        """
        found = np.zeros_like(self.values)  # of samples between pieces, which do not count
        for piece in self.pieces:
            found[piece] = low_pass(self.values[piece], self.rate_Hz, cutoff_Hz)
        return found

    def band(self, low_Hz: float, high_Hz: float) -> Floats | None:
        """Return the channel between two frequencies; None where the rate is too low for it.

        It is the difference of two low-passes, so that bands side by side add up.
        """
        if not high_Hz < 0.5 * self.rate_Hz:
            return None
        high = self.low_passed(high_Hz)
        return high if low_Hz <= 0.0 else high - self.low_passed(low_Hz)

    def trace(self, values: Floats, shortest_m: float) -> Trace:
        """Return a channel of these samples along the line."""
        return Trace(self.position_m, values, self.counted, shortest_m)

    @cached_property
    def parts(self) -> list[Floats]:
        """Values that count, one array for each stretch without a gap."""
        found = [self.values[one] for one in stretches(self.counted, self.pieces)]
        return [part for part in found if part.size > 1]

    @property
    def longest_s(self) -> float:
        """Length in s of the longest stretch that counts."""
        return max((part.size for part in self.parts), default=0) / self.rate_Hz

    def density(self, window_s: float) -> tuple[Floats, Floats] | None:
        """Return frequencies in Hz and power spectral density; None without samples.

        Parameters
        ----------
        window_s
            Length of the windows in s.
        """
        return spectrum_of(self.parts, self.rate_Hz, window_s) if self.parts else None


def settled(size: int, pieces: Sequence[slice], rate_Hz: float, margin_s: float) -> Flags:
    """Return which samples are further from the ends of their piece than a time.

    A filter without phase shift makes up what lies beyond an end, and so do the numbers near it.

    Parameters
    ----------
    size
        Number of samples.
    pieces
        Stretches without a gap.
    rate_Hz
        Samples in a second.
    margin_s
        The time in s.
    """
    found = np.zeros(size, dtype=np.bool_)
    steps = int(np.ceil(margin_s * rate_Hz))
    for piece in pieces:
        begin, end, _ = piece.indices(size)
        if end - begin > 2 * steps:
            found[begin + steps : end - steps] = True
    return found
