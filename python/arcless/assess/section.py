"""Part of a record inside the analysis section."""
# ruff: noqa: N815 - the names carry their units

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from arcless.assess.criteria import telling_decimals
from arcless.assess.rules import OF_DEVIATION
from arcless.assess.signals.filter import sample_rate_Hz
from arcless.assess.statistics import ForceBands, force_bands
from arcless.errors import ModelError
from arcless.model.fields.extremes import LEAST_FREQUENCY

if TYPE_CHECKING:
    from arcless.dataset.plain_dataset import Dataset

Section = tuple[float, float]

# Sampling that EN 50317 asks of a measurement (from memory, not verified).
MEASUREMENT_RATE_HZ = 200.0
# Section below which numbers are those of one place: two passages of the longest repeating wave,
# the span, and a second where spans are short or none. Longer, good short sections are doubted.
FEWEST_SPANS, SHORTEST_S = 2, 1.0
# Part of a span by which a section may fall short of them: some millimetres of typed ends. Less,
# ends that are typed rounded are refused; more, "2.0000 spans" are told to be fewer than 2.
ROUNDING_SPANS = 1e-4
# Time after the start of a run that still swings from it: about a period of the pantograph's lowest
# mode (assumed). Longer, whole sections are doubted; shorter, the start counts as the line.
START_UP_S = 1.0


@dataclass(frozen=True)
class ForceRecord:
    """Contact forces of a whole record, and when each pantograph is inside the section.

    Attributes
    ----------
    rate_Hz
        Recording rate.
    force, bands
        Unfiltered and filtered contact force in N, (time, pantograph).
    inside
        Samples at which the pantograph is inside the section, (time, pantograph).
    """

    rate_Hz: float
    force: NDArray[np.float64]
    bands: ForceBands
    inside: NDArray[np.bool_]


def checked_section(section: Any) -> Section:
    """Return a section whose begin lies before its end.

    Raises
    ------
    ModelError
        It is none.
    """
    begin, end = (float(x) for x in section)
    if not (math.isfinite(begin) and math.isfinite(end) and begin < end):
        raise ModelError("analysis section", got=f"{begin:g} to {end:g} m", expected="from < to")
    return begin, end


def checked_cutoff(cutoff_Hz: float) -> float:
    """Return a frequency in Hz that a low-pass can have.

    Raises
    ------
    ModelError
        It is too low.
    """
    if not cutoff_Hz >= LEAST_FREQUENCY:
        raise ModelError(
            "the low-pass frequency is too low",
            where="analysis.low_pass",
            got=f"{cutoff_Hz:g} Hz",
            expected=f"at least {LEAST_FREQUENCY:g} Hz",
            hint="give a frequency with its unit, such as 20 Hz",
        )
    return float(cutoff_Hz)


def force_record(
    dataset: "Dataset", section: Section, low_pass_Hz: float, band_split_Hz: float
) -> ForceRecord:
    """Filter the whole record, then mark the samples inside the section.

    Raises
    ------
    ModelError
        The section is empty, or a pantograph was never inside it.
    """
    rate = sample_rate_Hz(dataset["time"].values)
    position, force = dataset["position"].values, dataset["contact_force"].values
    inside = (position >= section[0]) & (position <= section[1])
    for column, name in enumerate(dataset["pantograph"].values):
        if not inside[:, column].any():
            first, last = position[0, column], position[-1, column]
            raise ModelError(
                "analysis section",
                got=f"{section[0]:g} to {section[1]:g} m",
                expected=f"a part of {first:g} to {last:g} m, where pantograph {name} ran",
            )
    bands = force_bands(force, rate, low_pass_Hz, band_split_Hz)
    return ForceRecord(rate, force, bands, inside)


def extreme_inside(
    dataset: "Dataset", value: str, position: str, section: Section, *, largest: bool
) -> float | None:
    """Return the extreme of a per-place variable over the places inside the section."""
    if value not in dataset or position not in dataset:
        return None
    x = dataset[position].values
    inside = dataset[value].values[(x >= section[0]) & (x <= section[1])]
    if inside.size == 0:
        return None
    return float(inside.max() if largest else inside.min())


def spans_between(supports_m: NDArray[np.float64], begin: float, end: float) -> float | None:
    """Return the spans between two places in m, parts of them counted; None without spans.

    Parameters
    ----------
    supports_m
        Positions of the supports in m.
    begin, end
        The places; what lies beyond the outermost supports counts nothing.
    """
    supports = np.unique(supports_m)
    if supports.size < 2:  # noqa: PLR2004 - a span has two ends
        return None
    return float(np.ptp(np.interp([begin, end], supports, np.arange(float(supports.size)))))


def too_short(spans: float | None) -> bool:
    """Return whether a section has fewer spans than tell of a line."""
    return spans is not None and spans < FEWEST_SPANS - ROUNDING_SPANS


def counted_spans(spans: float) -> str:
    """Return a number of spans as text, with as many decimals as tell it from the fewest."""
    decimals = telling_decimals(spans, [FEWEST_SPANS], 1)
    return f"{spans:.{decimals}f} spans"


def spans_run_over(dataset: "Dataset", section: Section, column: int) -> float | None:
    """Return the spans of the section that a pantograph ran over; None without spans."""
    if "support_x" not in dataset:
        return None
    ends = run_over(dataset["position"].values, column, section)
    return spans_between(dataset["support_x"].values, *ends)


def run_over(position: NDArray[np.float64], column: int, section: Section) -> Section:
    """Return the part of the section that a pantograph ran over, from and to in m.

    An end of the section lies between two samples: a path that ends a stride before it reaches it.

    Parameters
    ----------
    position
        Of all pantographs in m, (time, pantograph).
    column
        Number of the pantograph.
    section
        From and to in m.
    """
    first, last, stride = position[0, column], position[-1, column], _stride_m(position)
    begin = section[0] if first <= section[0] + stride else float(first)
    end = section[1] if last >= section[1] - stride else float(last)
    return begin, end


def short_reasons(spans: Mapping[str, float | None]) -> dict[tuple[str, str, bool], str]:
    """Return why deviations over few spans are not judged, as `Reasons.of_verdict` has it.

    Parameters
    ----------
    spans
        Spans that each pantograph ran over in the section, by its name; None without spans.
    """
    return {
        (name, rule, passed): f"too short: {counted_spans(count)}, and fewer than {FEWEST_SPANS}"
        " tell of one place, not of the line"
        for name, count in spans.items() if count is not None and too_short(count)
        for rule in OF_DEVIATION for passed in (False, True)
    }  # fmt: skip


def section_notes(
    dataset: "Dataset", section: Section, record: ForceRecord, band_split_Hz: float
) -> list[str]:
    """Say in sentences why the numbers of this section cover less than they should."""
    position, time = dataset["position"].values, dataset["time"].values
    notes = []
    if record.rate_Hz < MEASUREMENT_RATE_HZ:
        notes.append(
            f"contact channels were recorded at {record.rate_Hz:g} Hz, below the "
            f"{MEASUREMENT_RATE_HZ:g} Hz that a measurement needs (from memory of EN 50317)"
        )
    for column, name in enumerate(dataset["pantograph"].values):
        path, inside = position[:, column], record.inside[:, column]
        notes += part_notes(str(name), (path[0], path[-1]), section, _stride_m(position))
        samples = np.flatnonzero(inside)
        first, last = samples[0], samples[-1]
        length = float(path[last] - path[first])
        spans = spans_run_over(dataset, section, column)
        notes += short_notes(str(name), samples.size / record.rate_Hz, length, spans)
        notes += start_notes(str(name), float(time[first] - time[0]))
        margin = min(time[samples[0]] - time[0], time[-1] - time[samples[-1]])
        filtered, force = record.bands.total[samples, column], record.force[samples, column]
        notes += undershoot_notes(str(name), filtered, force)
        if margin < 1.0 / band_split_Hz:
            notes.append(
                f"the section of pantograph {name} begins or ends {margin:.3g} s from an end of "
                "the record, where a filter without phase shift makes numbers up"
            )
    return notes


def ran_over(dataset: "Dataset", section: Section) -> list[float] | None:
    """Return the part of the section that the pantographs ran over; None if it is the whole."""
    position = dataset["position"].values
    path = float(position[0].min()), float(position[-1].max())
    begin, end = max(path[0], section[0]), min(path[1], section[1])
    missing = max(begin - section[0], section[1] - end)
    return None if missing <= _stride_m(position) else [begin, end]


def _stride_m(position: NDArray[np.float64]) -> float:
    """Return the longest way between two samples in m: the ends of a section lie between two."""
    return float(np.diff(position, axis=0).max(initial=0.0))


def start_notes(name: str, until_s: float) -> list[str]:
    """Say that the assessed samples begin with the start of the run; `until_s` after it."""
    if until_s >= START_UP_S:
        return []
    return [
        f"pantograph {name} is assessed from {until_s:.3g} s after its start on: the first"
        f" {START_UP_S:g} s of the run hold the oscillation of starting, which the line has not"
    ]


def short_notes(name: str, time_s: float, length_m: float, spans: float | None) -> list[str]:
    """Say that a pantograph was in the section for too short to tell how it runs on the line."""
    if not too_short(spans) and time_s >= SHORTEST_S:
        return []
    counted = "" if spans is None else f", {counted_spans(spans)}"
    return [
        f"pantograph {name} is in the section for {length_m:.4g} m{counted}, {time_s:.3g} s:"
        f" numbers of less than {FEWEST_SPANS} spans or {SHORTEST_S:g} s are those of one place,"
        " not of the line"
    ]


def part_notes(name: str, path: Section, section: Section, stride_m: float = 0.0) -> list[str]:
    """Say that a pantograph ran over a part of the section only; its path from and to in m.

    Less than the stride, the way in m between two samples, is not missing.
    """
    if path[0] <= section[0] + stride_m and path[1] >= section[1] - stride_m:
        return []
    begin, end = max(path[0], section[0]), min(path[1], section[1])
    return [
        f"of the section, {section[0]:g} to {section[1]:g} m, pantograph {name} ran over"
        f" {begin:g} to {end:g} m only"
    ]


def undershoot_notes(
    name: str, filtered: NDArray[np.float64], force: NDArray[np.float64]
) -> list[str]:
    """Say that a minimum below zero is made by the filter; forces inside the section in N."""
    lowest = float(filtered.min())
    if not lowest < 0.0 <= float(force.min()):
        return []
    return [
        f"the minimum contact force of pantograph {name}, {lowest:.1f} N, is an undershoot "
        "of the low-pass where contact is lost: the unfiltered force is never below zero"
    ]
