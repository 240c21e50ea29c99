"""Percentiles of a sample's outputs, with the interval that their sampling error leaves.

For the quantile q_p of any continuous distribution and n independent values, the number of values
below q_p is binomial (n, p). So the order statistics y_(l) and y_(u) with
l = B⁻¹(α/2), u = B⁻¹(1 − α/2) + 1 have q_p between them with a probability of at least 1 − α.
Source: David and Nagaraja, Order Statistics, 3rd ed. (2003), section 7.1.
"""

import math
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any

from arcless.study.definition.study import Study
from arcless.study.designs import LatinHypercube, MonteCarlo, Sobol
from arcless.study.journal.row import Row

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

PERCENT = (1.0, 5.0, 50.0, 95.0, 99.0)
CONFIDENCE = 0.95


def percentiles(study: Study, rows: Iterable[Row]) -> dict[str, Any] | None:
    """Return the percentiles of every output.

    Parameters
    ----------
    study
        None is returned unless its design is a sample.
    rows
        Those that are done count; the percentiles are those of the variants that have a value.

    Returns
    -------
    dict or None
        ``confidence``, and by output ``values``, ``without_value`` and ``percentiles``:
        ``percent``, ``value``, ``low``, ``high``; None where there are too few values for a bound.
    """
    if not isinstance(study.design, MonteCarlo | LatinHypercube | Sobol):
        return None
    import numpy as np

    found: dict[str, list[float]] = {name: [] for name in study.outputs}
    count = 0
    for row in rows:
        count += 1
        for name, known in found.items():
            value = row.outputs.get(name)
            if value is not None:
                known.append(value)
    return {
        "confidence": CONFIDENCE,
        "outputs": {
            name: {
                "values": len(known),
                "without_value": count - len(known),
                "percentiles": of_values(np.array(known)),
            }
            for name, known in found.items()
        },
    }


def of_values(values: "NDArray[np.float64]") -> list[dict[str, float | None]]:
    """Return the percentiles of values, each with its interval; see `percentiles`."""
    import numpy as np

    ordered, count = np.sort(values), values.size
    found: list[dict[str, float | None]] = []
    for percent in PERCENT:
        part, tail = percent / 100.0, 0.5 * (1.0 - CONFIDENCE)
        low, high = 0, count + 1
        if count:
            low, above = binomial_quantiles(count, part, (tail, 1.0 - tail))
            high = above + 1
        found.append(
            {
                "percent": percent,
                "value": float(np.quantile(ordered, part)) if count else None,
                "low": float(ordered[low - 1]) if low >= 1 else None,
                "high": float(ordered[high - 1]) if high <= count else None,
            }
        )
    return found


def binomial_quantiles(count: int, part: float, at: Sequence[float]) -> list[int]:
    """Return B⁻¹(u) for each u: the least k with P(X ≤ k) ≥ u, X binomial (count, part).

    Neighbours k and k + 1 differ in likelihood by the factor (n − k)/(k + 1) · p/(1 − p).
    Written here because to import it takes longer than a thousand rows.

    Parameters
    ----------
    count, part
        n ≥ 1 and 0 < p < 1.
    at
        Between 0 and 1.
    """
    import numpy as np

    k = np.arange(count, dtype=float)
    steps = np.log((count - k) / (k + 1.0)) + math.log(part / (1.0 - part))
    weights = np.concatenate([[0.0], np.cumsum(steps)])
    likely = np.exp(weights - weights.max())
    below = np.cumsum(likely) / likely.sum()
    return [min(int(np.searchsorted(below, u)), count) for u in at]
