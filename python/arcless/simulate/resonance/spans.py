"""Effect of a span on a pantograph that passes it: its swing, its elasticity, its path.

**Swing.** A force of 1 N in the middle of a span raises the wire there by e = Σ (φᵀb)²/ω², a sum
over the natural modes of the whole line. The modes with the largest shares are those in which each
span swings as one half wave, one mode a span, all in a narrow band of frequencies; of a string
between fixed supports they have 8/π² = 81 %. Modes across or along the track have none. The shares
come from Lanczos' process begun there (Golub & Meurant, Matrices, Moments and Quadrature, chapters
6 and 7).

**Path.** A strip that passes slowly under a force F runs on z(x) = h(x) + e(x) F, with the height h
of the wire at rest. The part of z with k waves in a span shakes a pantograph at k v/L.
"""

from collections import Counter
from dataclasses import dataclass
from itertools import pairwise
from math import pi

import numpy as np
from numpy.typing import NDArray

from arcless.equilibrium.equilibrium import Equilibrium, named
from arcless.model.line.parts.spans import SpanType
from arcless.pantograph.natural_modes import Band

Floats = NDArray[np.float64]

# Lanczos steps: on the shipped lines 40 give the band to five digits or more and the mean frequency
# to ten; its share is some 0.5 % too large, as high modes are lumped together. The cost grows with
# the square.
STEPS = 40
# Modes below this multiple of the strongest one's frequency are those of its band: the next
# that the middle of a span takes part in has three half waves a span.
NEXT_BAND = 1.5
# Shares of the elasticity below this make no edge of a band.
LEAST_SHARE = 0.01
# Distinct lengths of spans that are told: of more, the shortest, the most frequent, the longest.
MOST_LENGTHS = 3
# Waves of the path in a span that are looked at: shorter ones are those between droppers.
ORDERS = range(1, 4)


@dataclass(frozen=True)
class Span:
    """A span as a pantograph meets it.

    Attributes
    ----------
    number
        Its number from 1.
    length
        In m.
    elasticity
        Lowest, mean and highest over the span, m/N.
    path
        Amplitude in m of the slow strip's path with k waves in the span, by k from 1.
    swing
        Natural frequencies in Hz of the band in which a span swings as one half wave: lowest, mean
        weighted by what they have of the elasticity in the middle, highest.
    swing_share
        Share of that elasticity.
    dropper_spacing
        Least, mean and largest distance in m of the droppers (hangers) in the span; None with
        fewer than two.
    """

    number: int
    length: float
    elasticity: Band
    path: dict[int, float]
    swing: Band
    swing_share: float
    dropper_spacing: Band | None


def spans(found: Equilibrium, types: list[SpanType], force: float) -> list[Span]:
    """Return a span of each length, the one nearest to the middle of the line.

    Parameters
    ----------
    found
        The line at rest.
    types
        Its spans in order.
    force
        Contact force in N that the path is taken at.
    """
    counted = Counter(round(one.length, 3) for one in types)
    lengths = sorted(counted)
    if len(lengths) > MOST_LENGTHS:
        lengths = [lengths[0], counted.most_common(1)[0][0], lengths[-1]]
    made = []
    for length in dict.fromkeys(lengths):
        left, right = found.middle_span(length)
        number = found.support_places().index(left)
        made.append(_span(found, number, (left, right), types[number], force))
    return made


def _span(
    found: Equilibrium, number: int, ends: tuple[float, float], kind: SpanType, force: float
) -> Span:
    left, right = ends
    x = found.elasticity_positions(left, right)
    elasticity = found.elasticity(x)
    frequency, share = modes_moved(found, float(x[len(x) // 2]))
    swing, swing_share = _swing(frequency, share)
    return Span(
        number + 1,
        right - left,
        Band(float(elasticity.min()), _mean(elasticity), float(elasticity.max())),
        _waves(found.lowest_heights(x) + elasticity * force),
        swing,
        swing_share,
        _spacing(kind.holders.positions),
    )


def modes_moved(found: Equilibrium, x: float, steps: int = STEPS) -> tuple[Floats, Floats]:
    """Return the modes that a vertical force at a place moves: frequencies and shares of e there.

    Parameters
    ----------
    found
        The line at rest.
    x
        Place in m. Of wires side by side those that hang at one height share the force alike.
    steps
        Of Lanczos' process: at most so many frequencies; those too close to one another to be told
        apart are one, with the share of all.

    Returns
    -------
    tuple of arrays
        Hz, ascending, and shares, whose sum is 1.
    """
    with named(found.mesh):
        squared, diagonal, off = found.core.modes_moved(found.lanes_at(x), x, steps)
    beside = np.array(off[: len(diagonal) - 1])
    matrix = np.diag(diagonal) + np.diag(beside, 1) + np.diag(beside, -1)
    inverse_squares, vectors = np.linalg.eigh(matrix)
    is_mode = inverse_squares > 0.0
    share = squared * vectors[0, is_mode] ** 2 / inverse_squares[is_mode]
    frequency = 1.0 / (2.0 * pi * np.sqrt(inverse_squares[is_mode]))
    return frequency[::-1], share[::-1] / share.sum()


def _swing(frequency: Floats, share: Floats) -> tuple[Band, float]:
    """Return the band of the strongest mode, and its share."""
    strongest = frequency[np.argmax(share)]
    inside = frequency < NEXT_BAND * strongest
    edges = frequency[inside & (share >= LEAST_SHARE)]
    part = float(share[inside].sum())
    middle = float(frequency[inside] @ share[inside]) / part
    return Band(float(edges.min()), middle, float(edges.max())), part


def _waves(path: Floats) -> dict[int, float]:
    """Return amplitudes of a Fourier series over points evenly spaced, both ends included."""
    series = np.fft.rfft(path[:-1] - path[:-1].mean()) / (len(path) - 1)
    return {k: 2.0 * float(abs(series[k])) for k in ORDERS if k < len(series) - 1}


def _mean(values: Floats) -> float:
    """Return the mean by the trapezoidal rule over points evenly spaced."""
    return float(values[1:-1].sum() + 0.5 * (values[0] + values[-1])) / (len(values) - 1)


def _spacing(positions: tuple[float, ...]) -> Band | None:
    gaps = [right - left for left, right in pairwise(positions)]
    return Band(min(gaps), sum(gaps) / len(gaps), max(gaps)) if gaps else None
