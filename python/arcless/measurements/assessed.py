"""Measurement → Assessment, by the filter, the statistics and the criteria of runs.

A quantity that was not measured is None, and its criterion is not judged. Sampling that EN 50317
asks for: more than 200 samples a second, or one every 0.40 m (from memory, mark C).
"""

from typing import Any

import numpy as np

from arcless.assess.assessment import Assessment, checked_cutoff, checked_section
from arcless.assess.criteria import OF_MEASUREMENT, evaluate
from arcless.assess.facts import supply_notes, uplift_notes
from arcless.assess.rules import ANY_SUPPLY, Facts
from arcless.assess.section import MEASUREMENT_RATE_HZ, Section, part_notes, undershoot_notes
from arcless.assess.statistics import ForceBands, PantographAssessment, pantograph_assessment
from arcless.errors import MeasurementError
from arcless.measurements.measurement import Measurement
from arcless.measurements.samples.left_out import WORDS, LeftOut
from arcless.measurements.samples.pantograph import MeasuredPantograph
from arcless.measurements.samples.pieces import interpolation_loss
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

# Largest distance of two samples in m (EN 50317, from memory: mark C).
MEASUREMENT_SPACING_M = 0.40
# Share of the time in the section that must be left. Less, and the numbers are those of another
# section than the one they are given for; more would refuse records with many short gaps.
LEAST_SHARE = 0.5
# Range of the speed, as a share of its mean, from which it is told: limits are those of one speed.
STEADY_SHARE = 0.1
WITHOUT_ARCS = (
    "loss of contact is where the unfiltered force is zero or less: arcs were not observed, and"
    " noise of the sensors hides short losses or makes some up"
)


def assess(
    measurement: Measurement,
    *,
    supply: str | None = None,
    section: tuple[float | None, float | None] | None = None,
    low_pass_Hz: float = LOW_PASS_HZ,
) -> Assessment:
    """Assess a measurement.

    Parameters
    ----------
    measurement
        As `read` returns it.
    supply
        Electrical supply, whose limits decide, such as ``"AC 25 kV"``. Without it those of AC 25 kV
        are shown, and decide nothing.
    section
        From and to in m along the track; without one, or with None for an end, all that was
        measured.
    low_pass_Hz
        Cut-off of the low-pass in Hz.

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
    edge = edge_s(low_pass_Hz, BAND_SPLIT_HZ)
    kept, shares, filtered = [], [], []
    for each in measurement.pantographs:
        _check_rate(measurement, each, low_pass_Hz)
        inside = counted(each, limits, low_pass_Hz, BAND_SPLIT_HZ)
        shares.append(_share(measurement, each, limits, inside))
        kept.append(inside)
        filtered.append(bands(each, low_pass_Hz, BAND_SPLIT_HZ))
    pantographs = [
        _of_pantograph(*one) for one in zip(measurement.pantographs, kept, filtered, strict=True)
    ]
    speed = measurement.pantographs[0].speed[kept[0]]
    facts = Facts(
        supply=supply or ASSUMED_SUPPLY,
        supply_given=supply is not None,
        speed_km_h=3.6 * float(np.mean(speed)),
        uplift_mm=_uplift_mm(measurement, limits),
    )
    notes = list(measurement.notes)
    for row in zip(measurement.pantographs, kept, filtered, shares, strict=True):
        notes += _notes(*row[:3], limits, low_pass_Hz) + _about_share(row[0], row[3], edge)
    notes += [WITHOUT_ARCS, *supply_notes(facts, "the supply"), *uplift_notes(facts.uplift_mm)]
    return Assessment(
        scenario=measurement.name,
        version=_version(),
        speed_m_s=float(np.mean(speed)),
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
        criteria=evaluate(facts, pantographs, reasons=OF_MEASUREMENT),
        notes=notes,
        measurement=_sampling(measurement, shares, edge),
    )


def _section(measurement: Measurement, given: tuple[float | None, float | None] | None) -> Section:
    ends = [(each.first_m, each.last_m) for each in measurement.pantographs]
    begin, end = (None, None) if given is None else given
    return checked_section((
        min(map(min, ends)) if begin is None else begin,
        max(map(max, ends)) if end is None else end,
    ))  # fmt: skip


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
        hint=f"EN 50317 asks for more than {MEASUREMENT_RATE_HZ:g} samples a second, or one every"
        f" {MEASUREMENT_SPACING_M:g} m (from memory)",
    )


def _share(
    measurement: Measurement, each: MeasuredPantograph, section: Section, kept: Mask
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
        hint = _counted(each.left_out) or "choose a longer section"
    raise MeasurementError(
        "too little is left of the record",
        where=f"{measurement.path}: pantograph {each.name}",
        got=got,
        expected=f"at least {100 * LEAST_SHARE:g} %",
        hint=hint,
    )


def _of_pantograph(
    each: MeasuredPantograph, inside: Mask, filtered: ForceBands
) -> PantographAssessment:
    return pantograph_assessment(
        each.name,
        inside,
        force=each.force,
        bands=filtered,
        gap=None,
        height=each.height,
        step_s=each.step_s,
        cuts=[piece.start for piece in each.pieces[1:]],
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


def _notes(
    each: MeasuredPantograph, kept: Mask, filtered: ForceBands, section: Section, low_pass_Hz: float
) -> list[str]:
    begin, end = sorted((each.first_m, each.last_m))
    notes = part_notes(each.name, (begin, end), section)
    notes += undershoot_notes(each.name, filtered.total[kept], each.force[kept])
    rate = each.true_rate_Hz
    if rate <= MEASUREMENT_RATE_HZ and each.spacing_m > MEASUREMENT_SPACING_M:
        notes.append(
            f"pantograph {each.name} was sampled at {rate:.4g} Hz, every {each.spacing_m:.2f} m:"
            f" EN 50317 asks for more than {MEASUREMENT_RATE_HZ:g} Hz or every"
            f" {MEASUREMENT_SPACING_M:.2f} m (from memory); what the sensors had above"
            f" {rate - low_pass_Hz:.4g} Hz is folded below {low_pass_Hz:g} Hz, unless a filter"
            " stood before the recorder"
        )
    if each.interpolated:
        loss = interpolation_loss(low_pass_Hz, each.step_s)
        notes.append(
            f"pantograph {each.name}: interpolation takes {100 * loss:.1f} % off a wave at"
            f" {low_pass_Hz:g} Hz, and less below"
        )
    if each.height is not None and (missing := np.isnan(each.height[kept]).mean()):
        notes.append(
            f"pantograph {each.name}: {100 * missing:.1f} % of the heights are missing, and their"
            " range is that of the others"
        )
    speed = each.speed[kept]
    low, high = 3.6 * float(speed.min()), 3.6 * float(speed.max())
    if high - low > STEADY_SHARE * 3.6 * float(speed.mean()):
        notes.append(
            f"the speed of pantograph {each.name} went from {low:.0f} to {high:.0f} km/h; limits"
            " are those of the mean speed"
        )
    return notes


def _about_share(each: MeasuredPantograph, share: float, edge: float) -> list[str]:
    """Say what was left out, and why."""
    notes = []
    for kind in dict.fromkeys(one.kind for one in each.left_out):
        ones = [one for one in each.left_out if one.kind == kind]
        first, count = ones[0], sum(one.samples for one in ones)
        place = "" if np.isnan(first.begin_m) else f" at {first.begin_m:.1f} m"
        where = f"line {first.line}{place}" if len(ones) == 1 else (
            f"{len(ones)} places, the first one line {first.line}{place}"
        )  # fmt: skip
        samples = f", {count} sample{'s' * (count > 1)}" if count else ""
        notes.append(f"pantograph {each.name}, left out because {WORDS[kind]}: {where}{samples}")
    if share == 1.0:
        return [*notes, f"pantograph {each.name}: nothing in the section is left out"]
    pieces = len(each.pieces)
    ends = "its ends" if pieces == 1 else f"the ends of {pieces} pieces without a gap"
    notes.append(
        f"pantograph {each.name}: {100 * (1 - share):.1f} % of the time in the section is left out,"
        f" {edge:g} s at {ends} with it, where a filter without phase shift makes numbers up"
    )
    return notes


def _counted(left_out: tuple[LeftOut, ...]) -> str:
    counts: dict[str, int] = {}
    for one in left_out:
        counts[one.kind] = counts.get(one.kind, 0) + max(1, one.samples)
    return "left out: " + ", ".join(f"{n} × {kind}" for kind, n in counts.items()) if counts else ""


def _sampling(measurement: Measurement, shares: list[float], edge: float) -> dict[str, Any]:
    """Return as plain data how it was sampled, and what was left out."""
    return {
        "file": measurement.path.name,
        "edge_s": edge,
        "pantographs": [
            {
                "name": each.name,
                "rate_Hz": each.true_rate_Hz,
                "spacing_m": each.spacing_m,
                "interpolated": each.interpolated,
                "pieces": len(each.pieces),
                "left_out_percent": 100.0 * (1.0 - share),
                "left_out": [one.to_dict() for one in each.left_out],
            }
            for each, share in zip(measurement.pantographs, shares, strict=True)
        ],
    }


def _version() -> str:
    from importlib.metadata import version

    return version("arcless")
