"""Remarks on a measured record: what makes its numbers less than they seem, what was left out."""

from collections.abc import Sequence

import numpy as np

from arcless.assess.section import MEASUREMENT_RATE_HZ, Section, part_notes, undershoot_notes
from arcless.assess.statistics import ForceBands
from arcless.measurements.samples.left_out import EMPTY, WORDS, LeftOut
from arcless.measurements.samples.pantograph import MeasuredPantograph
from arcless.measurements.samples.pieces import interpolation_loss
from arcless.measurements.samples.settled import Mask

# Largest distance of two samples in m (EN 50317, from memory: mark C).
MEASUREMENT_SPACING_M = 0.40
# Range of the speed, as a share of its mean, from which it is told: limits are those of one speed.
STEADY_SHARE = 0.1
WITHOUT_ARCS = (
    "loss of contact is where the unfiltered force is zero or less: arcs were not observed, and"
    " noise of the sensors hides short losses or makes some up"
)
WITHOUT_INERTIA = (
    "the sensors are below the strips, and the inertia of what is above them is not taken off:"
    " give `--head-mass`, or call the column contact_force where the recorder took it off"
)


def about_record(
    each: MeasuredPantograph, kept: Mask, filtered: ForceBands, section: Section, low_pass_Hz: float
) -> list[str]:
    """Say what makes numbers of a record less than they seem: path, sampling, heights, speed.

    Parameters
    ----------
    each, kept, filtered
        Samples, those that count, and their filtered force.
    section
        From and to in m.
    low_pass_Hz
        Cut-off of the low-pass.
    """
    begin, end = sorted((each.first_m, each.last_m))
    notes = part_notes(each.name, (begin, end), section)
    notes += undershoot_notes(each.name, filtered.total[kept], each.force[kept])
    rate = each.true_rate_Hz
    if rate <= MEASUREMENT_RATE_HZ and each.spacing_m > MEASUREMENT_SPACING_M:
        notes.append(
            f"pantograph {each.name} was sampled at {rate:.4g} Hz, every {each.spacing_m:.2f} m:"
            f" EN 50317 requires more than {MEASUREMENT_RATE_HZ:g} Hz or every"
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


def about_share(
    each: MeasuredPantograph, share: float, section: Section, edge_s: float
) -> list[str]:
    """Say what was left out in a section, and why.

    Parameters
    ----------
    each
        The samples.
    share
        Share of the time in the section that is left.
    section
        From and to in m.
    edge_s
        Time left out at each end of a piece.
    """
    notes = []
    inside = [one for one in each.left_out if touches(one, section)]
    for kind in dict.fromkeys(one.kind for one in inside):
        ones = [one for one in inside if one.kind == kind]
        first, count = ones[0], sum(one.samples for one in ones)
        place = "" if np.isnan(first.begin_m) else f" at {first.begin_m:.1f} m"
        where = f"line {first.line}{place}" if len(ones) == 1 else (
            f"{len(ones)} places, the first one line {first.line}{place}"
        )  # fmt: skip
        samples = f", {count} sample{'s' * (count > 1)}" if count else ""
        notes.append(f"pantograph {each.name}, left out because {WORDS[kind]}: {where}{samples}")
    if share == 1.0:
        return [*notes, f"pantograph {each.name}: nothing in the section is left out"]
    ranges = [sorted(each.position[[piece.start, piece.stop - 1]]) for piece in each.pieces]
    pieces = sum(low <= section[1] and high >= section[0] for low, high in ranges)
    ends = "its ends" if pieces == 1 else f"the ends of {pieces} pieces without a gap"
    notes.append(
        f"pantograph {each.name}: {100 * (1 - share):.1f} % of the time in the section is left out,"
        f" {edge_s:g} s at {ends} with it, where a filter without phase shift makes numbers up"
    )
    return notes


def touches(one: LeftOut, section: Section) -> bool:
    """Return whether a stretch lies in a section, at least with a part; True where nobody knows."""
    low, high = sorted((one.begin_m, one.end_m))
    return not (low > section[1] or high < section[0])


def too_little_hint(left_out: Sequence[LeftOut], edge_s: float) -> str:
    """Return what was left out where and why too little remains, and what to do about it.

    Parameters
    ----------
    left_out
        The stretches in the section.
    edge_s
        Time in s left out at each end of a piece.
    """
    if not left_out:
        return f"choose a longer section: {edge_s:g} s at each of its ends do not count"
    places: dict[str, list[LeftOut]] = {}
    for one in left_out:
        places.setdefault(one.kind, []).append(one)
    told = ", ".join(
        f"{kind} in {len(ones)} place{'s' * (len(ones) > 1)}"
        f" ({sum(one.samples for one in ones)} samples)"
        for kind, ones in places.items()
    )
    advice = (
        f": each place costs {2.0 * edge_s:g} s more, for the ends of the pieces next to it"
        " do not count"
    )
    if EMPTY in places:
        advice += "; fill single empty cells in the recorder's software, or choose another section"
    return f"left out: {told}{advice}"
