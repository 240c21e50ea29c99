"""Measurement → Assessment, by the filter, the statistics and the criteria of runs.

A quantity that was not measured is None, and its criterion is not judged. Sampling that EN 50317
asks for: more than 200 samples a second, or one every 0.40 m (from memory, mark C).
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from arcless.assess.assessment import Assessment
from arcless.assess.criteria import OF_MEASUREMENT, Reasons, evaluate
from arcless.assess.facts import speed_notes, supply_notes, uplift_notes
from arcless.assess.rules import ANY_SUPPLY, MEASURED_SPEED_KM_H, Facts
from arcless.assess.section import (
    MEASUREMENT_RATE_HZ,
    Section,
    checked_cutoff,
    checked_section,
    short_reasons,
    spans_between,
)
from arcless.assess.statistics import ForceBands, PantographAssessment, pantograph_assessment
from arcless.errors import MeasurementError
from arcless.measurements.doubts import Doubts, doubts
from arcless.measurements.measurement import Measurement
from arcless.measurements.remarks import (
    MEASUREMENT_SPACING_M,
    WITHOUT_ARCS,
    about_record,
    about_share,
    too_little_hint,
    touches,
)
from arcless.measurements.samples.pantograph import MeasuredPantograph
from arcless.measurements.samples.settled import (
    BAND_SPLIT_HZ,
    LOW_PASS_HZ,
    Mask,
    bands,
    counted,
    edge_s,
    time_between_s,
)
from arcless.model.line.parts.geometry import ASSUMED_SUPPLY
from arcless.units import show

# Share of the time in the section that must be left. Less, and the numbers are those of another
# section than the one they are given for; more would refuse records with many short gaps.
LEAST_SHARE = 0.5


@dataclass(frozen=True)
class _Part:
    """Samples of a pantograph, those that count, its filtered force, share of time that is left."""

    track: MeasuredPantograph
    inside: Mask
    bands: ForceBands
    share: float


def assess(
    measurement: Measurement,
    *,
    supply: str | None = None,
    section: tuple[float | None, float | None] | None = None,
    low_pass_Hz: float = LOW_PASS_HZ,
    supports_m: NDArray[np.float64] | None = None,
) -> Assessment:
    """Assess a measurement.

    Parameters
    ----------
    measurement
        As `read` returns it.
    supply
        Electrical supply, whose limits decide, such as ``"AC 25 kV"``. Without it limits that
        depend on it are those of AC 25 kV, and decide nothing.
    section
        From and to in m along the track; without one, or with None for an end, the track that all
        pantographs ran over.
    low_pass_Hz
        Cut-off of the low-pass in Hz.
    supports_m
        Positions of the supports in m, where the measurement lies on a line that is known:
        deviations over less than two spans are then not judged.

    Raises
    ------
    MeasurementError
        Less than half of the section is left, the supply is unknown, or the record is too coarse
        for the low-pass.
    ModelError
        The section or the cut-off is none.
    """
    if supply is not None and supply not in ANY_SUPPLY:
        raise MeasurementError("supply", got=show(supply), expected=", ".join(ANY_SUPPLY))
    low_pass_Hz = checked_cutoff(low_pass_Hz)
    limits = _section(measurement, section)
    parts = [_part(measurement, each, limits, low_pass_Hz) for each in measurement.pantographs]
    pantographs = [_of_pantograph(part) for part in parts]
    doubtful = [
        doubts(part.track, part.inside, found, limits)
        for part, found in zip(parts, pantographs, strict=True)
    ]
    speed = float(np.mean(parts[0].track.speed[parts[0].inside]))
    facts = Facts(
        supply=supply or ASSUMED_SUPPLY,
        supply_given=supply is not None,
        speed_km_h=3.6 * speed,
        speed_known_to_km_h=MEASURED_SPEED_KM_H,
        uplift_mm=_uplift_mm(measurement, limits),
    )
    spans = None if supports_m is None else spans_between(supports_m, *limits)
    return Assessment(
        scenario=measurement.name,
        version=_version(),
        speed_m_s=speed,
        section_m=list(limits),
        low_pass_Hz=low_pass_Hz,
        band_split_Hz=BAND_SPLIT_HZ,
        pantographs=pantographs,
        max_uplift_at_support_mm=facts.uplift_mm,
        slack_droppers_max=None,
        min_dropper_force_N=None,
        energy_residual_relative=None,
        steps=None,
        setup_time_s=None,
        wall_time_s=None,
        real_time_factor=None,
        supply=facts.supply,
        criteria=evaluate(facts, pantographs, reasons=_reasons(parts, doubtful, spans)),
        notes=[
            *(text for each in doubtful for text in each.told),
            *_notes(measurement, parts, facts, limits, low_pass_Hz),
        ],
        measurement=_sampling(measurement, parts, doubtful, edge_s(low_pass_Hz, BAND_SPLIT_HZ)),
    )


def _reasons(parts: Sequence[_Part], doubtful: Sequence[Doubts], spans: float | None) -> Reasons:
    """Return why criteria are not judged: what is doubtful about the forces, too few spans."""
    short = short_reasons({part.track.name: spans for part in parts})
    named = [(part.track.name, one) for part, one in zip(parts, doubtful, strict=True)]
    return replace(
        OF_MEASUREMENT,
        of_pantograph={
            name: one.of_pantograph for name, one in named if one.of_pantograph is not None
        },
        of_verdict=short
        | {(name, *verdict): why for name, one in named for verdict, why in one.of_verdict.items()},
    )


def _section(measurement: Measurement, given: tuple[float | None, float | None] | None) -> Section:
    """Complete a section: where one end is not given, it is that of the track that all ran over."""
    ends = [sorted((each.first_m, each.last_m)) for each in measurement.pantographs]
    begin, end = (None, None) if given is None else given
    return checked_section((
        max(low for low, _ in ends) if begin is None else begin,
        min(high for _, high in ends) if end is None else end,
    ))  # fmt: skip


def _part(
    measurement: Measurement, each: MeasuredPantograph, section: Section, low_pass_Hz: float
) -> _Part:
    _check_rate(measurement, each, low_pass_Hz)
    inside = counted(each, section, low_pass_Hz, BAND_SPLIT_HZ)
    share = _share(measurement, each, section, inside, edge_s(low_pass_Hz, BAND_SPLIT_HZ))
    return _Part(each, inside, bands(each, low_pass_Hz, BAND_SPLIT_HZ), share)


def _notes(
    measurement: Measurement,
    parts: Sequence[_Part],
    facts: Facts,
    section: Section,
    low_pass_Hz: float,
) -> list[str]:
    notes = list(measurement.notes)
    for part in parts:
        notes += about_record(part.track, part.inside, part.bands, section, low_pass_Hz)
        notes += about_share(part.track, part.share, section, edge_s(low_pass_Hz, BAND_SPLIT_HZ))
    return [
        *notes,
        WITHOUT_ARCS,
        *supply_notes(facts, "the supply"),
        *speed_notes(facts),
        *uplift_notes(facts.uplift_mm),
    ]


def _inside(each: MeasuredPantograph, section: Section) -> Mask:
    inside: Mask = (each.position >= section[0]) & (each.position <= section[1])
    return inside


def _check_rate(measurement: Measurement, each: MeasuredPantograph, low_pass_Hz: float) -> None:
    """Refuse a low-pass that the record has no samples for."""
    if low_pass_Hz < 0.5 * each.true_rate_Hz:
        return
    raise MeasurementError(
        "too few samples for the low-pass",
        where=f"{measurement.path}: pantograph {each.name}",
        got=f"{each.true_rate_Hz:.4g} samples a second, one every {each.spacing_m:.3g} m",
        expected=f"more than twice the cut-off of {low_pass_Hz:g} Hz",
        hint=f"EN 50317 requires more than {MEASUREMENT_RATE_HZ:g} samples a second, or one every"
        f" {MEASUREMENT_SPACING_M:g} m (from memory)",
    )


def _share(
    measurement: Measurement, each: MeasuredPantograph, section: Section, kept: Mask, edge: float
) -> float:
    """Return the share of the time in the section that is left; refuse too little."""
    time, known = time_between_s(each, *section), np.count_nonzero(kept) * each.step_s
    # The ends of a section lie between samples: one step is no loss.
    whole = known > 0.0 and time - known <= each.step_s
    share = 1.0 if whole else float(known / max(time, each.step_s))
    if share >= LEAST_SHARE:
        return share
    if not _inside(each, section).any():
        got, low, high = "no sample", *sorted((each.first_m, each.last_m))
        hint = f"the record goes from {low:g} to {high:g} m"
    else:
        got = f"{100 * share:.1f} % of the time from {section[0]:g} to {section[1]:g} m"
        left_out = [one for one in each.left_out if touches(one, section)]
        hint = too_little_hint(left_out, edge)
    raise MeasurementError(
        "too little is left of the record",
        where=f"{measurement.path}: pantograph {each.name}",
        got=got,
        expected=f"at least {100 * LEAST_SHARE:g} %",
        hint=hint,
    )


def _of_pantograph(part: _Part) -> PantographAssessment:
    track = part.track
    return pantograph_assessment(
        track.name,
        part.inside,
        force=track.force,
        bands=part.bands,
        gap=None,
        height=track.height,
        step_s=track.step_s,
        cuts=[piece.start for piece in track.pieces[1:]],
    )


def _uplift_mm(measurement: Measurement, section: Section) -> float | None:
    """Return the largest uplift that was measured in the section, in mm."""
    found = [
        1e3 * each.uplift[_inside(each, section) & np.isfinite(each.uplift)].max(initial=-np.inf)
        for each in measurement.pantographs
        if each.uplift is not None
    ]
    largest = max(found, default=-np.inf)
    return float(largest) if np.isfinite(largest) else None


def _sampling(
    measurement: Measurement, parts: Sequence[_Part], doubtful: Sequence[Doubts], edge: float
) -> dict[str, Any]:
    """Return as plain data how it was sampled, and what was left out of the whole file."""
    return {
        "file": measurement.path.name,
        "edge_s": edge,
        "pantographs": [
            {
                "name": part.track.name,
                "rate_Hz": part.track.true_rate_Hz,
                "spacing_m": part.track.spacing_m,
                "interpolated": part.track.interpolated,
                "pieces": len(part.track.pieces),
                "left_out_percent": 100.0 * (1.0 - part.share),
                "left_out": [one.to_dict() for one in part.track.left_out],
                "doubts": list(doubt.told),
            }
            for part, doubt in zip(parts, doubtful, strict=True)
        ],
    }


def _version() -> str:
    from importlib.metadata import version

    return version("arcless")
