"""Sentences that pages and paper have in common."""

from arcless.assess import Assessment

MARKS_MEAN = (
    "The mark says how well a number is known. A limit that was not checked in a source (marks C,"
    " C*, assumed) does not count."
)
CERTAINTY_READS = (
    "A run that begins elsewhere within a span gives other numbers. The pantograph is the same at"
    " every start; the static force is that of the run, carried over by the base spring. A"
    " criterion is too close to tell where the distance between value and limit is smaller than"
    " their uncertainty; it then does not count."
)


def numbers_of(assessment: Assessment) -> str:
    """Return what the numbers of an assessment are of: section, filter, loss of contact."""
    begin, end = assessment.section_m
    return (
        f"Over the analysis section, {begin:.0f} to {end:.0f} m. Forces are after the"
        f" {assessment.low_pass_Hz:g} Hz low-pass, without phase shift, unless they are called"
        " unfiltered. Loss of contact is that of the unfiltered force."
    )
