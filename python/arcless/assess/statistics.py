"""Indicators of one pantograph over the analysis section."""
# ruff: noqa: N815 - the names carry their units

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from arcless.assess.signals.filter import low_pass
from arcless.assess.signals.loss_of_contact import (
    arcing_percent,
    contact_loss_percent,
    longest_loss_s,
)
from arcless.display.numbers import number

Array = NDArray[np.float64]


@dataclass(frozen=True)
class PantographAssessment:
    """Indicators of one pantograph; the names carry the units.

    Forces are after the low-pass unless the name says otherwise. Standard deviations are those
    of the samples themselves (divided by their number).
    """

    name: str
    mean_force_N: float
    std_force_N: float
    std_force_0_5Hz_N: float
    std_force_5_20Hz_N: float
    max_force_N: float
    min_force_N: float
    statistical_max_N: float
    statistical_min_N: float
    contact_loss_percent: float
    NQ_percent: float
    longest_loss_s: float
    max_gap_mm: float | None
    """None of a measurement, as is the next one where heights were not measured."""
    contact_point_range_mm: float | None
    unfiltered_max_force_N: float
    unfiltered_min_force_N: float
    max_lateral_position_mm: float | None = None
    """Distance of the contact wire from the middle of the head, sway included; None if planar."""
    wear_mechanical_mm3_km: float | None = None
    """Wear rates: None, as are the next three, of a scenario without coefficients of wear."""
    wear_joule_mm3_km: float | None = None
    wear_arc_mm3_km: float | None = None
    wear_total_mm3_km: float | None = None
    certainty: dict[str, dict[str, float | None]] | None = None
    """Spread and discretisation by key; None where nobody asked."""

    def __repr__(self) -> str:
        forces = f"F_m {number(self.mean_force_N)} N, σ {number(self.std_force_N)} N"
        return f"<PantographAssessment {self.name}: {forces}>"


@dataclass(frozen=True)
class ForceBands:
    """Contact force split by frequency; the bands add up to the total."""

    total: Array
    low: Array
    high: Array

    def of(self, pantograph: int) -> "ForceBands":
        """Return the bands of one pantograph."""
        return ForceBands(*(band[:, pantograph] for band in (self.total, self.low, self.high)))


def force_bands(
    force: Array,
    rate_Hz: float,
    low_pass_Hz: float,
    band_split_Hz: float,
    pieces: Sequence[slice] = (slice(None),),
) -> ForceBands:
    """Split a whole record of the contact force into its two bands.

    Parameters
    ----------
    force
        Unfiltered contact force in N, first axis time; the whole record, so that what the filter
        makes up at its ends lies outside the analysis section.
    rate_Hz
        Recording rate in Hz.
    low_pass_Hz, band_split_Hz
        Upper end of the upper band, and the frequency between the two bands.
    pieces
        Stretches without a gap, which are filtered one by one; one behind the other they are the
        whole record.

    Notes
    -----
    The upper band is the total minus the lower band: with zero phase and Butterworth gains this
    is the band-pass, and nothing is counted twice.
    """
    total, low = (
        np.concatenate([low_pass(force[piece], rate_Hz, cutoff) for piece in pieces])
        for cutoff in (low_pass_Hz, min(band_split_Hz, low_pass_Hz))
    )
    return ForceBands(total, low, total - low)


def pantograph_assessment(
    name: str,
    inside: NDArray[np.bool_],
    *,
    force: Array,
    bands: ForceBands,
    gap: Array | None,
    height: Array | None,
    step_s: float,
    lateral_mm: float | None = None,
    cuts: Sequence[int] = (),
) -> PantographAssessment:
    """Return the indicators of one pantograph.

    Parameters
    ----------
    name
        Name of the pantograph.
    inside
        Samples at which it is inside the analysis section; at least one.
    force, bands
        Unfiltered and filtered contact force in N, whole record.
    gap, height
        Contact gap and height of the contact point in m, whole record; None where there is none. A
        height that is missing is NaN.
    step_s
        Recording step in s.
    lateral_mm
        Largest lateral position of the contact wire, sway included; None of a planar run.
    cuts
        Samples at which a new piece begins, of a record with gaps.
    """
    total = bands.total[inside]
    mean, std = float(np.mean(total)), float(np.std(total))
    values: dict[str, Any] = {
        "mean_force_N": mean,
        "std_force_N": std,
        "std_force_0_5Hz_N": np.std(bands.low[inside]),
        "std_force_5_20Hz_N": np.std(bands.high[inside]),
        "max_force_N": np.max(total),
        "min_force_N": np.min(total),
        "statistical_max_N": mean + 3.0 * std,
        "statistical_min_N": mean - 3.0 * std,
        "contact_loss_percent": contact_loss_percent(force[inside]),
        "NQ_percent": arcing_percent(force, inside, step_s, cuts),
        "longest_loss_s": longest_loss_s(force, step_s, inside, cuts),
        "max_gap_mm": None if gap is None else 1e3 * np.max(gap[inside]),
        "contact_point_range_mm": None if height is None else _range_mm(height[inside]),
        "unfiltered_max_force_N": np.max(force[inside]),
        "unfiltered_min_force_N": np.min(force[inside]),
    }
    numbers: dict[str, Any] = {
        key: None if value is None else float(value) for key, value in values.items()
    }
    return PantographAssessment(name, **numbers, max_lateral_position_mm=lateral_mm)


def _range_mm(height: Array) -> float | None:
    """Return the range of the heights that are known, in mm."""
    known = height[~np.isnan(height)]
    return 1e3 * float(np.ptp(known)) if known.size else None
