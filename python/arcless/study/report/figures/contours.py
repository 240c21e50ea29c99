"""The line along which values on a grid are zero, by marching squares."""

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


def contour(values: Floats) -> Floats:
    """Return pieces of the line along which a grid of values is zero.

    Parameters
    ----------
    values
        By row and column, at places 0, 1, …; between them the values are taken as linear along
        the edges. NaN for none: squares with such a corner have no line.

    Returns
    -------
    numpy.ndarray
        A row ``x0, y0, x1, y1`` for each piece, x along the columns.
    """
    rows, columns = values.shape
    pieces = []
    for row in range(rows - 1):
        for column in range(columns - 1):
            square = values[row : row + 2, column : column + 2]
            if np.isfinite(square).all():
                pieces += _pieces(square, column, row)
    return np.array(pieces, dtype=float).reshape(-1, 4)


# Corners of a square as (row, column), around it.
_AROUND = ((0, 0), (0, 1), (1, 1), (1, 0))


def _pieces(square: Floats, x: int, y: int) -> list[tuple[float, float, float, float]]:
    """Return the pieces in a square: one, or two where opposite corners are on the same side."""
    crossed = []
    for start, end in zip(_AROUND, (*_AROUND[1:], _AROUND[0]), strict=True):
        a, b = float(square[start]), float(square[end])
        if (a > 0.0) != (b > 0.0):
            part = a / (a - b)
            crossed.append(
                (x + start[1] + part * (end[1] - start[1]),
                 y + start[0] + part * (end[0] - start[0]))
            )  # fmt: skip
    if len(crossed) == 4 and (square.mean() > 0.0) == (square[0, 0] > 0.0):  # noqa: PLR2004
        crossed = crossed[1:] + crossed[:1]  # the middle is on the side of the first corner
    return [(*a, *b) for a, b in zip(crossed[::2], crossed[1::2], strict=True)]
