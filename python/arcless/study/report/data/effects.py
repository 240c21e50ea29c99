"""Effect of one variable on an output: means of the variants at each value, or in each part."""

from dataclasses import dataclass

import numpy as np

from arcless.study.report.data.record import Column, Floats

# More different values than this are put together into parts with equally many variants.
MOST_LEVELS = 12
PARTS, LEAST_IN_PART = 10, 5


@dataclass(frozen=True)
class Effect:
    """Means of an output.

    Attributes
    ----------
    x, mean, error
        Value of the variable (mean of the part), mean of the output, and standard error of that
        mean; NaN for an error of one variant alone.
    share
        Variance between the means over all variance, the correlation ratio η² = SS_between/SS:
        how much one variable alone explains. Of parts with few variants it is too high.
    """

    x: Floats
    mean: Floats
    error: Floats
    share: float


def effect(variable: Column, output: Column) -> Effect | None:
    """Return the means of an output over a variable; None where there are too few variants."""
    known = np.isfinite(variable.values) & np.isfinite(output.values)
    x, y = variable.values[known], output.values[known]
    owners = _owners(x)
    if owners is None:
        return None
    count = np.bincount(owners)
    centre = np.bincount(owners, x) / count
    mean = np.bincount(owners, y) / count
    within = np.bincount(owners, (y - mean[owners]) ** 2)
    with np.errstate(divide="ignore", invalid="ignore"):
        error = np.where(count > 1, np.sqrt(within / (count - 1.0) / count), np.nan)
    between = float(np.sum(count * (mean - y.mean()) ** 2))
    total = between + float(within.sum())
    return Effect(centre, mean, error, between / total if total > 0.0 else 0.0)


def _owners(x: Floats) -> "np.ndarray[tuple[int], np.dtype[np.intp]] | None":
    """Return the number of the part that each variant belongs to."""
    if not x.size:
        return None
    levels, places = np.unique(x, return_inverse=True)
    if levels.size <= MOST_LEVELS:
        return places if levels.size > 1 and x.size > levels.size else None
    parts = min(PARTS, x.size // LEAST_IN_PART)
    if parts < 2:  # noqa: PLR2004 - one mean shows no effect
        return None
    order = np.empty(x.size, dtype=np.intp)
    order[np.argsort(x, kind="stable")] = np.arange(x.size)
    return order * parts // x.size
