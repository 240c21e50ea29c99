"""Doubts about a record: verdicts on clipped forces, and on forces that no wire has.

A clipped sample says that the force was at the end of the sensor's range or beyond. Left out, it
takes the extremes away, and with them a part of the standard deviation: what is computed of the
rest is a bound, and meets limits that the force itself may not meet.
"""

from collections import defaultdict
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from arcless.assess.section import Section
from arcless.assess.statistics import PantographAssessment
from arcless.display.numbers import real_minus
from arcless.measurements.remarks import WITHOUT_INERTIA, touches
from arcless.measurements.samples.left_out import CLIPPED, LOWER, UPPER, LeftOut
from arcless.measurements.samples.pantograph import MeasuredPantograph
from arcless.measurements.samples.settled import Mask

# Mean contact forces in N that a pantograph may have. The static force is some 50 to 140 N, and the
# laws of the mean force give 300 N at 400 km/h: mark assumed. A narrower range would refuse trials;
# a wider one lets pass forces in kN that the header calls N, or the other way round.
PLAUSIBLE_MEAN_N = (10.0, 1000.0)
# Share of samples below zero from which the sign is doubted: a lost contact has zero, and the noise
# of sensors about it half of its samples below.
NEGATIVE_SHARE = 0.5

# Criteria whose value is a bound where an end of the range was reached, and the verdict that the
# bound cannot give. σ rises whichever end is missing, and F_m ± 3σ with it.
_SPREAD = (("standard_deviation", True), ("statistical_max", True), ("statistical_min", True))
UNSURE = {
    UPPER: (*_SPREAD, ("mean_force", True), ("mean_force_lower", False)),
    LOWER: (*_SPREAD, ("mean_force", False), ("mean_force_lower", True), ("contact_loss", True)),
}
_BEYOND = {UPPER: ("above", "at least"), LOWER: ("below", "at most")}


@dataclass(frozen=True)
class Doubts:
    """Doubts about one pantograph.

    Attributes
    ----------
    of_pantograph
        Why nothing of it is judged; None where it is.
    of_verdict
        Why one verdict cannot be given, by criterion and whether it would be met.
    told
        The doubts as sentences.
    """

    of_pantograph: str | None
    of_verdict: dict[tuple[str, bool], str]
    told: tuple[str, ...]


def doubts(
    each: MeasuredPantograph, kept: Mask, found: PantographAssessment, section: Section
) -> Doubts:
    """Return what is doubtful about the forces of a pantograph.

    Parameters
    ----------
    each, kept
        Its samples, and those that count.
    found
        Its numbers.
    section
        From and to in m.
    """
    implausible = _implausible(each, kept, found.mean_force_N)
    clips = {end: ones for end in (UPPER, LOWER) if (ones := _clips(each, section, end))}
    verdicts = {
        verdict: f"{_where(clips[end])}, and what is computed of the others is a bound only"
        for end in clips
        for verdict in UNSURE[end]
    }
    told = [] if implausible is None else [f"pantograph {each.name}: {implausible}"]
    for ones in clips.values():
        told += _sentences(each.name, ones)
    return Doubts(implausible if each.is_contact_force else WITHOUT_INERTIA, verdicts, tuple(told))


def _implausible(each: MeasuredPantograph, kept: Mask, mean_N: float) -> str | None:
    low, high = PLAUSIBLE_MEAN_N
    below = float(np.mean(each.force[kept] < 0.0))
    if below > NEGATIVE_SHARE:
        return f"{100.0 * below:.0f} % of the contact forces are below zero: is the sign right?"
    if low <= mean_N <= high:
        return None
    return (
        f"a mean contact force of {mean_N:.4g} N is beyond the {low:g} to {high:g} N of pantographs"
        " (assumed): are sign and unit right?"
    )


def _clips(each: MeasuredPantograph, section: Section, end: str) -> list[LeftOut]:
    """Return stretches at an end of a sensor's range in the section.

    Either end of an acceleration leaves the force unknown on both sides.
    """
    return [
        one
        for one in each.left_out
        if one.kind == CLIPPED
        and (one.end == end or "acceleration" in one.channel.lower())
        and touches(one, section)
    ]


def _where(ones: list[LeftOut]) -> str:
    places = f"{len(ones)} place{'s' * (len(ones) > 1)}"
    return (
        f"a sensor was at the {' and '.join(sorted({one.end for one in ones}))} end of its"
        f" range in {places}"
    )


def _sentences(name: str, ones: list[LeftOut]) -> Iterator[str]:
    """Say for each column what its true extreme is."""
    columns: dict[tuple[str, str, float], int] = defaultdict(int)
    for one in ones:
        columns[one.channel, one.end, one.rail] += 1
    for (channel, end, rail), count in columns.items():
        side, bound = _BEYOND[end]
        extreme = "maximum" if end == UPPER else "minimum"
        is_force = "acceleration" not in channel.lower()
        unit = "N" if is_force else "m/s²"
        true = f"{bound} {real_minus(f'{rail:.4g}')} {unit}"
        yield (
            f"pantograph {name}: {channel} was at the {end} end of its range in {count}"
            f" place{'s' * (count > 1)}, and may have been {side} it: its {extreme} is"
            f" {true}, and σ is larger than computed; criteria on them are not"
            " met or not judged"
        )
