"""Sentences on what is doubtful about a measurement that was put on the line of a run."""

from arcless.assess import Assessment
from arcless.comparison.alignment import Alignment
from arcless.comparison.alignment.place import POOR_CORRELATION
from arcless.comparison.measured.placed import Placed
from arcless.display.numbers import number, signed
from arcless.measurements.samples.left_out import JUMP, WORDS

# Parts of the reader's notes that hold for every file, or say that all is as it should be.
USUAL = ("read as CSV", "columns that are not used", "is taken off")
# Share of the section in % that may be left out without a word: the ends of a record or so.
UNTOLD_PERCENT = 0.05
# Speeds that differ by less than this part are those of one test: the wire moves the force by as
# little. More is told.
SAME_SPEED = 0.02


def remarks(name: str, placed: Placed, assessment: Assessment, speed_m_s: float) -> list[str]:
    """Return the sentences on one measurement.

    Parameters
    ----------
    name
        What it is called.
    placed
        The measurement on the line.
    assessment
        Its numbers.
    speed_m_s
        Speed in m/s of what it is compared with.
    """
    found = []
    several = len(placed.alignments) > 1
    for one, by in zip(placed.measurement.pantographs, placed.alignments, strict=True):
        whose = f"{name}, {one.name}" if several else name
        found += [f"{whose}: {text}" for text in _doubts(by)]
        searched = by.method in ("correlation", "supports")
        if searched and by.channel == "force" and not one.is_contact_force:
            found.append(
                f"{whose}: placed by a force that misses the inertia of what is above the sensors,"
                " and lags behind the contact force: the offset may be wrong by some metres"
            )
        jumps = sum(part.kind == JUMP for part in one.left_out)
        if jumps:
            found.append(
                f"{whose}: the odometer jumps {jumps} time{'s' * (jumps > 1)}, and one offset"
                " cannot fit both sides of a jump"
            )
    apart = assessment.speed_m_s / speed_m_s - 1.0
    if abs(apart) > SAME_SPEED:
        found.append(
            f"{name}: measured at {3.6 * assessment.speed_m_s:.1f} km/h,"
            f" {signed(100.0 * apart)} % from {3.6 * speed_m_s:.1f} km/h: forces grow with the"
            " speed, and the same frequency is another wavelength"
        )
    notes = [note for note in placed.measurement.notes if not any(usual in note for usual in USUAL)]
    told = (assessment.measurement or {}).get("pantographs", [])
    notes += [text for each in told for text in each["doubts"]]
    return found + [f"{name}: {note}" for note in [*notes, *_left_out(placed, assessment)]]


def _left_out(placed: Placed, assessment: Assessment) -> list[str]:
    """Return how much of the section was left out, and why."""
    found = []
    shares = (assessment.measurement or {}).get("pantographs", [])
    for one, share in zip(placed.measurement.pantographs, shares, strict=True):
        if share["left_out_percent"] <= UNTOLD_PERCENT:
            continue
        begin, end = assessment.section_m
        counts: dict[str, int] = {}
        for part in one.left_out:
            counts[part.kind] = counts.get(part.kind, 0) + max(part.samples, 1)
        why = "; ".join(f"{WORDS[kind]}, {count} of the file" for kind, count in counts.items())
        found.append(
            f"{share['left_out_percent']:.1f} % of the time from {begin:.0f} to {end:.0f} m is left"
            f" out{f' ({why})' if why else ''}"
        )
    return found


def _doubts(by: Alignment) -> list[str]:
    found = []
    if by.falling:
        found.append(
            "its positions fall, so the distance run is taken: the line is modelled in the"
            " direction of travel"
        )
    if by.ambiguous:
        found.append(
            "the offset is not sure: noise alone can make the difference between the two best"
            " correlations, as where spans are alike; limit the search, or give the offset by hand"
        )
    # The part that all spans have in common is a part of the channel only, and correlates less.
    if by.correlation is not None and by.correlation < POOR_CORRELATION and by.method != "supports":
        found.append(
            f"the correlation is poor: {number(by.correlation, 3)}, and below {POOR_CORRELATION:g}"
            f" less than half of the variance of the {by.channel} is that of the run: the place or"
            " the model may be wrong"
        )
    if by.beyond_offset_m is not None and by.beyond_correlation is not None:
        found.append(
            f"an offset of {signed(by.beyond_offset_m)} m, out of the search, fits better"
            f" (correlation {number(by.beyond_correlation, 3)}): check the positions, or widen the"
            " search (`--search`)"
        )
    return found
