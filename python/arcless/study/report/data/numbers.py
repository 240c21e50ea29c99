"""Numbers as people read them: four significant digits, columns with one number of decimals."""

from math import floor, log10
from typing import Any

import numpy as np
from numpy.typing import NDArray

from arcless.display.numbers import real_minus

# More are noise: two runs that begin elsewhere in a span differ in the third digit already.
DIGITS = 4
# Beyond these, zeros would say nothing but a size, which an exponent says better.
_SMALLEST, _LARGEST = -4, 7
NONE = "–"


def digits(value: float | None) -> str:
    """Return a number with four significant digits and a real minus sign; a dash for none."""
    if value is None or not np.isfinite(value):
        return NONE
    size = 0 if value == 0.0 else floor(log10(abs(value)))
    if not _SMALLEST <= size < _LARGEST:
        return real_minus(f"{value:.{DIGITS - 1}e}")
    text = f"{value:.{max(0, DIGITS - 1 - size)}f}"
    return real_minus(text.rstrip("0").rstrip(".") if "." in text else text)


def decimals(values: NDArray[np.floating[Any]]) -> int | None:
    """Return the decimals of a column: four digits of its largest number, fewer if these say all.

    None where a number would be written as zero, or needs an exponent.
    """
    known = np.unique(np.abs(values[np.isfinite(values)]))
    known = known[known > 0.0]
    if not known.size:
        return 0
    size = floor(log10(float(known[-1])))
    most = max(0, DIGITS - 1 - size)
    if size >= _LARGEST or float(known[0]) < 0.5 * 10.0**-most:
        return None
    rounded = np.round(known, most)
    return next(d for d in range(most + 1) if np.array_equal(np.round(known, d), rounded))


def column_texts(values: NDArray[np.floating[Any]]) -> list[str]:
    """Return the numbers of a column, all with the same decimals where that can be."""
    places = decimals(values)
    if places is None:
        return [digits(float(value)) for value in values]
    return [real_minus(f"{v:.{places}f}") if np.isfinite(v) else NONE for v in values.tolist()]


def form(values: NDArray[np.floating[Any]]) -> str:
    """Return the format of a column's numbers under the pointer."""
    places = decimals(values)
    if places is None:
        return "0.000e+0"
    return "0." + "0" * places if places else "0"
