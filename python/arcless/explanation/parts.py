"""Parts of an explanation, as data; the names of numbers carry their units."""
# ruff: noqa: N815 - the names carry their units

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
GroupKey = Literal["span", "droppers", "pantograph", "rest"]

# Names of the groups, in the sequence in which they take their part of the variance.
GROUPS: dict[GroupKey, str] = {
    "span": "span passing",
    "droppers": "dropper passing",
    "pantograph": "pantograph modes",
    "rest": "rest",
}


@dataclass(frozen=True)
class Strongest:
    """Strongest order or spectral line of a group.

    Attributes
    ----------
    frequency_Hz, wavelength_m
        Where it is; at 0 Hz it has no wavelength.
    share_percent
        Its share of σ².
    mode
        Number of the pantograph mode, from 1, in whose band it lies; None for none.
    """

    frequency_Hz: float
    wavelength_m: float | None
    share_percent: float
    mode: int | None


@dataclass(frozen=True)
class Group:
    """A part of the variance of the contact force; the four of a pantograph add up to σ².

    Attributes
    ----------
    key, name
        ``"span"``, ``"droppers"``, ``"pantograph"`` or ``"rest"``, and in words.
    variance_N2, share_percent
        Its variance, and as a share of σ².
    std_N
        Root of the variance: σ of the force if this part were all of it.
    uncertainty_percent
        Standard uncertainty of the share, which follows from the length of the section; None where
        the section is too short to tell.
    chance_percent
        Share that the orders of the group would take of a force that repeats nothing, of the
        density of the rest; None likewise, and for groups without orders.
    strongest
        Its strongest order or spectral line; None for a group without variance.
    """

    key: GroupKey
    name: str
    variance_N2: float
    share_percent: float
    std_N: float
    uncertainty_percent: float | None
    chance_percent: float | None
    strongest: Strongest | None


@dataclass(frozen=True)
class OrderShare:
    """An order of the span, or a side order of the droppers, with its share of the variance.

    Attributes
    ----------
    group
        Group that it belongs to.
    of_span, of_droppers
        Waves in a mean span, and in a mean interval between droppers (None without droppers).
    wavelength_m, frequency_Hz
        At the mean span and the mean speed.
    variance_N2, share_percent
        Its variance, and as a share of σ².
    uncertainty_percent
        Standard uncertainty of the share; None where the section is too short to tell.
    mode
        Number of the pantograph mode, from 1, in whose band it lies; None for none.
    """

    group: GroupKey
    of_span: float
    of_droppers: float | None
    wavelength_m: float
    frequency_Hz: float
    variance_N2: float
    share_percent: float
    uncertainty_percent: float | None
    mode: int | None


@dataclass(frozen=True)
class Mode:
    """A natural mode of the pantograph on the elasticity of the line.

    Attributes
    ----------
    number
        From 1, the slowest first.
    frequency_Hz
        At the mean elasticity.
    band_Hz
        Ends of the band that it answers in.
    damping_ratio
        Of the pantograph's linear dampers.
    share_percent
        Share of σ² that lies in the band and does not repeat with spans or droppers.
    in_band_percent
        Share of σ² in the band, orders of spans and droppers included: they are amplified there.
    """

    number: int
    frequency_Hz: float
    band_Hz: tuple[float, float]
    damping_ratio: float
    share_percent: float
    in_band_percent: float


@dataclass(frozen=True)
class SpanDeviation:
    """Standard deviation of the filtered force in one span."""

    span: int
    begin_m: float
    end_m: float
    std_N: float


@dataclass(frozen=True)
class Place:
    """A place with a large deviation of the force.

    Attributes
    ----------
    position_m, span
        Along the track, and number of the span; None beyond the line.
    force_N, deviation_N
        Filtered force, and its deviation: from the mean, or from what repeats.
    nearest, distance_m
        Part of the line that is nearest, and how far behind it in the direction of travel the place
        is (negative: in front of it).
    where
        The same in words, with the overlap that it is in.
    as_built
        Part near it that is not as designed, in words; None where there is none.
    stands_out
        Whether a random force would hardly reach the deviation; None where that was not asked.
    """

    position_m: float
    span: int | None
    force_N: float
    deviation_N: float
    nearest: str
    distance_m: float
    where: str
    as_built: str | None
    stands_out: bool | None = None


@dataclass(frozen=True, eq=False)
class Trace:
    """Signals behind the numbers, at the samples of the section.

    Attributes
    ----------
    position_m, remainder_N
        Position, and the part of the force that does not repeat.
    line_Hz, line_variance_N2, line_mode
        Spectral lines of that part: frequency, variance, number of the mode from 0 or -1.
    """

    position_m: Floats
    remainder_N: Floats
    line_Hz: Floats
    line_variance_N2: Floats
    line_mode: NDArray[np.intp]
