"""Orders of spans and droppers in the contact force, by least squares in sequence.

The deviation of the filtered force from its mean in the samples i of the section is written as

    F_i − F_m = Σ_k [a_k cos 2πθ_k(x_i) + b_k sin 2πθ_k(x_i)] + r_i

with the phases θ = k ξ of span order k, and θ = m ψ + j ξ of dropper order m with its side orders j
(`line_coordinate`). The columns are made orthogonal one after the other (Gram-Schmidt), so that
each takes only what the columns before it left:

    σ² = Σ_c z_c²/n + Σ_i r_i²/n,      R z = Xᵀ(F − F_m),  R Rᵀ = XᵀX,  R lower triangular

which holds to rounding for any length of the section and any speed. Over whole equal spans at
constant speed the columns are orthogonal from the start, z_c are Fourier coefficients, and this is
Parseval's theorem; what a section with a part of a span shares between two orders belongs to the
lower one.

A random force of the density of the remainder r would give an order the variance b(f), that
of one free spectral line; an order of the amplitude A then varies by 2 A² b + b² about A² + b.

Sources, from memory (C): G. H. Golub & C. F. Van Loan, Matrix Computations, 5.2 (Gram-Schmidt);
J. S. Bendat & A. G. Piersol, Random Data, 8.5 (variance of spectral lines).
"""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from arcless.explanation.signals.line_coordinate import LineCoordinate

Floats = NDArray[np.float64]
Source = Literal["span", "droppers"]

# Frequencies up to this multiple of the low-pass are looked at; it leaves 6 % of an amplitude
# there, and what is above belongs to the rest. Smaller, repeated parts would pass for rest.
ABOVE_LOW_PASS = 1.25
# Most orders of the span, of very slow runs; each costs time with its square.
MOST_ORDERS = 150
# Least part of a column's square that the columns before it do not have. Smaller, rounding would
# be taken for a direction of its own; larger, one would be left out.
LEAST_NEW = 1e-6
# Samples whose columns are in memory at a time.
PIECE = 8192


@dataclass(frozen=True)
class Order:
    """A phase that the line repeats: `waves` times ξ plus `carrier` times ψ.

    Attributes
    ----------
    source
        The group it belongs to.
    of_span
        Waves in a mean span.
    waves, carrier
        Multiples of the coordinates in spans and in dropper intervals.
    """

    source: Source
    of_span: float
    waves: int
    carrier: int = 0


@dataclass(frozen=True)
class Fit:
    """A force split into orders and a remainder.

    Attributes
    ----------
    orders
        The orders, in the sequence in which they were taken.
    columns
        Variance in N² that each column of an order took, (order, 2); NaN for one that is no
        direction of its own.
    remainder
        What does not repeat, N at each sample.
    """

    orders: tuple[Order, ...]
    columns: Floats
    remainder: Floats

    @property
    def variances(self) -> Floats:
        """Variance of each order in N²."""
        found: Floats = np.nansum(self.columns, axis=1)
        return found


def orders(
    line: LineCoordinate, begin: float, end: float, most_of_span: float
) -> tuple[Order, ...]:
    """Return the orders of a stretch of line, in the sequence in which they are taken.

    An order of the span belongs to what it is nearest to: the span itself, order 0 of the
    droppers, or one of their orders m; half way between, to the span. Where droppers do not
    stand at the same parts of all spans, their own phase comes first.

    Parameters
    ----------
    line
        Its supports and droppers.
    begin, end
        Ends of the stretch in m.
    most_of_span
        Waves in a mean span up to which orders are looked at.
    """
    most = int(min(most_of_span, MOST_ORDERS))
    per_span = line.intervals_per_span(begin, end)
    if per_span is None:
        return tuple(Order("span", k, k) for k in range(1, most + 1))
    half = max(1, int(per_span / 2.0))
    found = [Order("span", k, k) for k in range(1, min(half, most) + 1)]
    if not line.hangs_alike(begin, end):
        found += _carried(per_span, half, most)
    found += [Order("droppers", k, k) for k in range(half + 1, most + 1)]
    return tuple(found)


def _carried(per_span: float, half: int, most: int) -> Iterator[Order]:
    """Yield dropper orders with their side orders, those without any first."""
    sides = sorted(range(-half, half + 1), key=lambda j: (abs(j), -j))
    carriers = range(1, int(most / per_span + 0.5) + 1)
    for side in sides:
        for carrier in carriers:
            of_span = carrier * per_span + side
            if 0.0 < of_span <= most:
                yield Order("droppers", of_span, side, carrier)


def fit(deviation: Floats, spans: Floats, intervals: Floats, taken: tuple[Order, ...]) -> Fit:
    """Split a force by the orders of the line.

    Parameters
    ----------
    deviation
        Deviation of the force from its mean in N, at each sample.
    spans, intervals
        Coordinates ξ and ψ of the samples.
    taken
        Orders in sequence.
    """
    count = deviation.size
    width = 1 + 2 * len(taken)
    gram, moments = np.zeros((width, width)), np.zeros(width)
    pieces = [slice(first, first + PIECE) for first in range(0, count, PIECE)]
    for piece in pieces:
        columns = _columns(taken, spans[piece], intervals[piece])
        gram += columns.T @ columns
        moments += columns.T @ deviation[piece]
    squares = _in_sequence(gram, moments)
    kept = np.flatnonzero(~np.isnan(squares))
    amplitudes = np.linalg.solve(gram[np.ix_(kept, kept)], moments[kept])
    remainder = np.empty(count)
    for piece in pieces:
        columns = _columns(taken, spans[piece], intervals[piece])
        remainder[piece] = deviation[piece] - columns[:, kept] @ amplitudes
    return Fit(taken, squares[1:].reshape(-1, 2) / count, remainder)


def _columns(taken: tuple[Order, ...], spans: Floats, intervals: Floats) -> Floats:
    """Return a column of ones, then cosine and sine of each order, (sample, column)."""
    of_spans = _powers(spans, max((abs(one.waves) for one in taken), default=0))
    of_intervals = _powers(intervals, max((one.carrier for one in taken), default=0))
    found = np.ones((spans.size, 1 + 2 * len(taken)))
    for place, one in enumerate(taken):
        wave = of_spans[abs(one.waves)]
        wave = wave.conj() if one.waves < 0 else wave
        if one.carrier:
            wave = wave * of_intervals[one.carrier]
        found[:, 1 + 2 * place], found[:, 2 + 2 * place] = wave.real, wave.imag
    return found


def _powers(coordinate: Floats, most: int) -> list[NDArray[np.complex128]]:
    """Return exp(2πi k θ) for k from 0 by products: an exponential for each takes longer."""
    found = [np.ones(coordinate.size, dtype=np.complex128)]
    first = np.exp(2j * np.pi * coordinate)
    for _ in range(most):
        found.append(found[-1] * first)
    return found


def _in_sequence(gram: Floats, moments: Floats) -> Floats:
    """Return z² of each column, NaN for one that those before it nearly contain."""
    left, moment = gram.copy(), moments.copy()
    squares = np.full(moments.size, np.nan)
    for j in range(moments.size):
        if left[j, j] <= LEAST_NEW * gram[j, j]:
            continue
        row = left[j, j:] / np.sqrt(left[j, j])
        z = moment[j] / np.sqrt(left[j, j])
        squares[j] = z**2
        left[j:, j:] -= np.outer(row, row)
        moment[j:] -= row * z
    return squares
