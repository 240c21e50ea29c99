"""Loss of contact: the samples at which the unfiltered contact force is zero."""

import numpy as np
from numpy.typing import NDArray


def contact_loss_percent(force: NDArray[np.float64]) -> float:
    """Return the share of time without contact, in per cent.

    Parameters
    ----------
    force
        Unfiltered contact force in N at equal time steps; every sample stands for one step.
    """
    return 100.0 * float(np.count_nonzero(force <= 0.0)) / force.size


def longest_loss_s(force: NDArray[np.float64], step_s: float) -> float:
    """Return the duration in s of the longest loss of contact.

    Parameters
    ----------
    force
        Unfiltered contact force in N at equal time steps.
    step_s
        Time step in s. A loss over k samples in a row lasts k steps; one that reaches beyond
        either end of ``force`` counts with its part inside.
    """
    lost = np.concatenate(([False], force <= 0.0, [False]))
    changes = np.flatnonzero(lost[1:] != lost[:-1])
    lengths = changes[1::2] - changes[::2]
    return float(lengths.max(initial=0)) * step_s
