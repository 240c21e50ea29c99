"""Part of a record inside the analysis section."""
# ruff: noqa: N815 - the names carry their units

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from arcless.assess.signals.filter import sample_rate_Hz
from arcless.assess.statistics import ForceBands, force_bands
from arcless.errors import ModelError
from arcless.model.fields.extremes import LEAST_FREQUENCY

if TYPE_CHECKING:
    from arcless.dataset.plain_dataset import Dataset

Section = tuple[float, float]

# Sampling that EN 50317 asks of a measurement (from memory, not verified).
MEASUREMENT_RATE_HZ = 200.0


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
        notes += part_notes(str(name), (path[0], path[-1]), section)
        samples = np.flatnonzero(inside)
        margin = min(time[samples[0]] - time[0], time[-1] - time[samples[-1]])
        filtered, force = record.bands.total[samples, column], record.force[samples, column]
        notes += undershoot_notes(str(name), filtered, force)
        if margin < 1.0 / band_split_Hz:
            notes.append(
                f"the section of pantograph {name} begins or ends {margin:.3g} s from an end of "
                "the record, where a filter without phase shift makes numbers up"
            )
    return notes


def part_notes(name: str, path: Section, section: Section) -> list[str]:
    """Say that a pantograph ran over a part of the section only; its path from and to in m."""
    if path[0] <= section[0] and path[1] >= section[1]:
        return []
    begin, end = max(path[0], section[0]), min(path[1], section[1])
    return [f"pantograph {name} ran over {begin:g} to {end:g} m of the section only"]


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
