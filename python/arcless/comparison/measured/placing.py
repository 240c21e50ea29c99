"""Measured pantographs → their places on the line of a run, or of another measurement.

Sensors below the strips show F_s = F_c + m z̈ (`results/instrument/head.py`). Without the inertia
taken off that is the force of the suspension of the strips, which lags behind the contact force:
the place at which the two correlate best is metres off. The height of the strips is that of the
wire wherever they touch it, so it is taken where the file has it.
"""
# ruff: noqa: N815 - the names carry their units

import math
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from arcless.assess.signals.gapped import stretches
from arcless.comparison.alignment import (
    Alignment,
    Search,
    Trace,
    aligned,
    correlation_at,
    repeated,
)
from arcless.comparison.measured.signal import Signal, settled
from arcless.errors import ComparisonError
from arcless.measurements import MeasuredPantograph

Floats = NDArray[np.float64]
METHODS = ("correlation", "supports", "none")
CHANNELS = ("force", "height")
# Scale of an odometer that is searched without being told to: worn wheels are some 0.1 % smaller
# than they were taken for. More would let a wrong speed pass for a drift.
SCALE_WITHIN = 0.005
# Share of the samples that must have a height for heights to be taken without being asked for.
# Lower would align by a few stretches of a sensor that failed; higher gives up for a few gaps.
LEAST_HEIGHTS = 0.5


@dataclass(frozen=True)
class Aligning:
    """Method and limits by which measurements are aligned.

    Attributes
    ----------
    method
        ``correlation`` of the filtered channel with that of the run; ``supports``, with the part of
        it that all spans have in common; ``none``, as the positions stand.
    channel
        ``force``, or ``height`` of the contact point, which inertia of the strips does not change.
        None for the force where it is the contact force, and for the height where it is that of
        sensors below the strips, not corrected; for the force where there are no heights either.
    offset_m
        What is added to the first position, in m; nothing is searched then. None to search.
    scale
        Metres on the line for one of the odometer, for an offset that is given.
    search_m
        How far from zero the offset is searched, in m. None for half of the longest span where the
        positions lie on the line, and for everything where they do not, or where the file has none.
    scale_within
        How far the scale may be from 1.
    """

    method: str = "correlation"
    channel: str | None = None
    offset_m: float | None = None
    scale: float = 1.0
    search_m: float | None = None
    scale_within: float = SCALE_WITHIN

    def __post_init__(self) -> None:
        if self.method not in METHODS:
            expected = f"one of {', '.join(METHODS)}"
            raise ComparisonError("method of alignment", got=f'"{self.method}"', expected=expected)
        if self.channel not in (None, *CHANNELS):
            expected = f"one of {', '.join(CHANNELS)}"
            raise ComparisonError("channel to align by", got=f'"{self.channel}"', expected=expected)
        if self.search_m is not None and not self.search_m > 0.0:
            raise ComparisonError("search", got=f"{self.search_m:g} m", expected="above 0 m")
        if not self.scale > 0.0:
            raise ComparisonError("scale", got=f"{self.scale:g}", expected="above 0")
        if not 0.0 <= self.scale_within < 1.0:
            got = f"{self.scale_within:g}"
            raise ComparisonError("limit of the scale", got=got, expected="0 up to below 1")

    def channel_of(self, *pantographs: MeasuredPantograph) -> str:
        """Return the channel to align by: the one given, or the one that the samples allow.

        Parameters
        ----------
        *pantographs
            Samples of the measured ones, of what is aligned and of what it is aligned with.
        """
        if self.channel is not None:
            return self.channel
        if all(one.is_contact_force for one in pantographs):
            return "force"
        return "height" if all(map(_has_heights, pantographs)) else "force"


def _has_heights(measured: MeasuredPantograph) -> bool:
    """Return whether enough samples have a height, and heights change."""
    if measured.height is None:
        return False
    known = measured.height[np.isfinite(measured.height)]
    return known.size >= LEAST_HEIGHTS * measured.height.size and bool(np.ptp(known) > 0.0)


@dataclass(frozen=True, eq=False)
class Reference:
    """Filtered channel of a pantograph over its position, with which measurements are aligned.

    Attributes
    ----------
    trace
        The channel.
    supports_m
        Positions of the supports in m; empty where they are not known.
    low_pass_Hz
        Cut-off of its filter.
    margin_s
        Time at the ends of a record at which it does not count.
    channel
        ``force`` or ``height``.
    """

    trace: Trace
    supports_m: Floats
    low_pass_Hz: float
    margin_s: float
    channel: str


def signal_of(measured: MeasuredPantograph, channel: str, margin_s: float, label: str) -> Signal:
    """Return a channel of a measured pantograph over the distance run.

    Parameters
    ----------
    measured
        Its samples; the distance begins at the first position of the file.
    channel
        ``force`` or ``height``.
    margin_s
        Samples count that are further from the ends of their piece than this, in s.
    label
        The file, for messages.

    Raises
    ------
    ComparisonError
        The file has no heights.
    """
    values = measured.force if channel == "force" else measured.height
    if values is None:
        raise ComparisonError(
            "no heights to align by",
            where=f"{label}: pantograph {measured.name}",
            expected="a column contact_height [m]",
            hint="align by the force",
        )
    pieces = stretches(np.isfinite(values), measured.pieces)
    run = measured.first_m + np.abs(measured.position - measured.first_m)
    counted = settled(values.size, pieces, measured.rate_Hz, margin_s)
    return Signal(run, values, measured.rate_Hz, pieces, counted, float(measured.speed.mean()))


def trace_of(signal: Signal, low_pass_Hz: float) -> Trace:
    """Return the filtered channel of a pantograph along the line."""
    return signal.trace(signal.low_passed(low_pass_Hz), signal.speed_m_s / low_pass_Hz)


def place(
    measured: MeasuredPantograph, on: Reference, how: Aligning, label: str, *, counted: bool
) -> Alignment:
    """Return where a measured pantograph lies on the line of a reference.

    Parameters
    ----------
    measured
        Its samples.
    on
        What it is aligned with.
    how
        By which method and within which limits.
    label
        The file, for messages.
    counted
        Whether its positions are counted by the speed, from the first sample of the file.

    Raises
    ------
    ComparisonError
        Nothing overlaps, or there is nothing to align by.
    """
    falls = measured.last_m < measured.first_m
    _check_order(measured, label)
    signal = signal_of(measured, on.channel, on.margin_s, label)
    mine = _from_origin(trace_of(signal, on.low_pass_Hz), measured)
    try:
        if how.offset_m is not None or how.method == "none":
            found = _given(mine, on, how, falls=falls)
        elif how.method == "supports":
            found = _by_supports(mine, on, how)
        else:
            found = aligned(on.trace, mine, _search(mine, on, how, counted=counted))
    except ComparisonError as error:
        error.where = error.where or f"{label}: pantograph {measured.name}"
        raise
    return replace(found, origin_m=measured.first_m, falling=falls, channel=on.channel)


def _check_order(measured: MeasuredPantograph, label: str) -> None:
    """Refuse an odometer that jumps back: places between would be there twice."""
    run = np.abs(measured.position - measured.first_m)
    back = np.flatnonzero(np.diff(run) < 0.0)
    if not back.size:
        return
    before, here = measured.position[back[0]], measured.position[back[0] + 1]
    raise ComparisonError(
        "the odometer jumps back",
        where=f"{label}: pantograph {measured.name}",
        got=f"{here:.1f} m after {before:.1f} m",
        expected="positions that go one way",
        hint="cut the file there, or leave its column of positions out: they are then counted by"
        " the speed",
    )


def _from_origin(mine: Trace, measured: MeasuredPantograph) -> Trace:
    """Return the trace with the first position of the file as its first, where none counts."""
    if mine.position_m[0] == measured.first_m:
        return mine
    return Trace(
        np.concatenate([[measured.first_m], mine.position_m]),
        np.concatenate([[0.0], mine.values]),
        np.concatenate([[False], mine.valid]),
        mine.shortest_m,
    )


def _given(mine: Trace, on: Reference, how: Aligning, *, falls: bool) -> Alignment:
    """Return an alignment that is given, with the correlation that it has."""
    if falls and how.offset_m is None:
        raise ComparisonError(
            "positions fall: the train ran towards their beginning",
            got="--align none",
            expected="positions that rise along the run",
            hint="align by correlation, or give the offset of the first sample (--offset)",
        )
    offset = 0.0 if how.offset_m is None else how.offset_m
    name = "none" if how.offset_m is None else "given"
    return correlation_at(on.trace, mine, offset, how.scale, method=name)


def _by_supports(mine: Trace, on: Reference, how: Aligning) -> Alignment:
    if on.supports_m.size == 0:
        raise ComparisonError(
            "no supports to align by", expected="a run among those that are compared",
            hint="use --align correlation, or --offset",
        )  # fmt: skip
    template = repeated(on.trace, on.supports_m)
    half = 0.5 * float(np.diff(on.supports_m).max())
    limit = half if how.search_m is None else how.search_m
    search = Search(-limit, limit, how.scale_within)
    return aligned(template, mine, search, "supports")


def _search(mine: Trace, on: Reference, how: Aligning, *, counted: bool) -> Search:
    """Return the limits of a search by correlation."""
    if how.search_m is not None:
        return Search(-how.search_m, how.search_m, how.scale_within)
    begin, end = (float(mine.position_m[place]) for place in (0, -1))
    on_line = min(end, float(on.trace.position_m[-1])) - max(begin, float(on.trace.position_m[0]))
    known = (
        not counted
        and on.supports_m.size > 1
        and on_line >= 0.5 * min(mine.length_m, on.trace.length_m)
    )
    if not known:
        return Search(-math.inf, math.inf, how.scale_within)
    half = 0.5 * float(np.diff(on.supports_m).max())
    return Search(-half, half, how.scale_within)
