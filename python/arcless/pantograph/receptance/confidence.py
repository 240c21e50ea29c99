"""Confidence of what a fit found: standard deviations of parameters, poles and receptance.

With the derivatives J of the residuals (over their errors), S the sum of their squares, N of them
and p parameters, the covariance of the parameters is to first order

    V = S/(N − p) (JᵀJ)⁻¹

and a quantity with the derivatives g has the variance gᵀ V g (G. A. F. Seber & C. J. Wild:
Nonlinear Regression, Wiley 1989, chapter 2). Directions in which JᵀJ is singular are not
determined. The noise is supposed to be independent from one frequency to the next; a misfit that
is no noise makes V a guess.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from arcless.pantograph.receptance.least_squares import Found

Floats = NDArray[np.float64]

# Share of all measurements that ± covers, by Student's distribution.
COVERAGE = 0.95
# Singular values below this share of the largest are no information, but rounding; and the share of
# a quantity's derivatives that may lie in such directions.
SINGULAR, OPEN = 1e-9, 1e-4


@dataclass(frozen=True, eq=False)
class Confidence:
    """Covariance of the parameters of a fit, as a factor: V = R Rᵀ with the rows of R by parameter.

    Attributes
    ----------
    root
        R, including Student's factor of `COVERAGE` (parameters × determined directions).
    open
        Directions that are not determined (parameters × others), each over the parameters' sizes.
    sizes
        Size of a change of each parameter that is felt alike.
    """

    root: Floats
    open: Floats
    sizes: Floats

    def of(self, derivatives: Floats) -> Floats:
        """Return ± of quantities with these derivatives (quantities × parameters).

        Infinite where the data do not determine a quantity.
        """
        found: Floats = np.linalg.norm(derivatives @ self.root, axis=1)
        scaled = derivatives * self.sizes
        length = np.linalg.norm(scaled, axis=1)
        left = np.linalg.norm(scaled @ self.open, axis=1)
        return np.where(left > OPEN * length, np.inf, found)


def confidence(found: Found) -> Confidence:
    """Return the confidence of a minimum."""
    from scipy.special import stdtrit

    changes = found.changes
    lengths = np.linalg.norm(changes, axis=0)
    sizes = 1.0 / np.where(lengths > 0.0, lengths, 1.0)
    _, values, rows = np.linalg.svd(changes * sizes, full_matrices=False)
    known = values > SINGULAR * values[0]
    free = changes.shape[0] - int(known.sum())
    factor = float(stdtrit(free, 0.5 + 0.5 * COVERAGE)) * np.sqrt(found.cost / free)
    root = sizes[:, None] * (rows[known] / values[known, None]).T * factor
    return Confidence(root, rows[~known].T, sizes)
