"""Loss of contact: the samples at which the unfiltered contact force is zero.

    NQ = 100 % · Σ t_arc / t,   over all arcs with t_arc > 5 ms

with t the time in the section (EN 50317, from memory: mark C). A measurement sees arcs, and counts
only those at currents above 30 % of the nominal one; here every loss of contact counts as an arc,
as if current flowed all the time.

A measured record may have gaps. It is then pieces, one behind the other, and a loss ends where its
piece does: what happened in the gap is not known.
"""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

# Shorter arcs do not count for NQ: EN 50317, from memory (mark C). In s.
SHORTEST_ARC_S = 5e-3
# Steps of a loss are whole, their sum in s is not: five steps of 1 ms are not longer than 5 ms.
ROUNDING = 1e-9


def contact_loss_percent(force: NDArray[np.float64]) -> float:
    """Return the share of time without contact, in per cent.

    Parameters
    ----------
    force
        Unfiltered contact force in N at equal time steps; every sample stands for one step.
    """
    return 100.0 * float(np.count_nonzero(force <= 0.0)) / force.size


def longest_loss_s(
    force: NDArray[np.float64],
    step_s: float,
    inside: NDArray[np.bool_] | None = None,
    cuts: Sequence[int] = (),
) -> float:
    """Return the duration in s of the longest loss of contact.

    Parameters
    ----------
    force
        Unfiltered contact force in N at equal time steps.
    step_s
        Time step in s. A loss over k samples in a row lasts k steps.
    inside
        Samples that count; all without it. A loss that reaches beyond counts with its part inside.
    cuts
        Samples at which a new piece begins.
    """
    lost = force <= 0.0
    begins, ends = _losses(lost if inside is None else lost & inside, cuts)
    return float((ends - begins).max(initial=0)) * step_s


def arcing_percent(
    force: NDArray[np.float64],
    inside: NDArray[np.bool_],
    step_s: float,
    cuts: Sequence[int] = (),
) -> float:
    """Return NQ in per cent: the share of time in losses of contact of more than 5 ms.

    Parameters
    ----------
    force
        Unfiltered contact force in N at equal time steps, whole record.
    inside
        Samples in the section, at least one. Of a loss that reaches beyond it, the whole duration
        decides whether it counts, and the part inside is what counts.
    step_s
        Time step in s.
    cuts
        Samples at which a new piece begins.
    """
    begins, ends = _losses(force <= 0.0, cuts)
    long = (ends - begins) * step_s > SHORTEST_ARC_S * (1.0 + ROUNDING)
    counted = np.concatenate(([0], np.cumsum(inside)))
    lost = (counted[ends] - counted[begins])[long].sum()
    return 100.0 * float(lost) / int(counted[-1])


def _losses(
    lost: NDArray[np.bool_], cuts: Sequence[int]
) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """Return the first sample of each loss of contact, and the first one after it."""
    whole = np.concatenate(([False], lost, [False]))
    changes = np.flatnonzero(whole[1:] != whole[:-1])
    at = np.asarray(cuts, np.intp)
    across = at[lost[at] & lost[at - 1]]
    begins, ends = (np.concatenate((part, across)) for part in (changes[::2], changes[1::2]))
    return np.sort(begins), np.sort(ends)
