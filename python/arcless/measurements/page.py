"""Measurement → its page."""

from pathlib import Path

from arcless.assess import Assessment
from arcless.measurements.measurement import Measurement
from arcless.measurements.samples.left_out import WORDS
from arcless.measurements.samples.settled import bands, counted


def write_report(measurement: Measurement, assessment: Assessment, path: str | Path) -> None:
    """Write the page of a measured run: one HTML file that opens without a network.

    Parameters
    ----------
    measurement
        The measured run.
    assessment
        Its assessment, as `assess` returns it.
    path
        The file to write; its folder must exist.

    Raises
    ------
    OutputError
        The file cannot be written; nothing half-written stays behind.
    """
    from arcless.figures.measured import Kept, MeasuredData
    from arcless.report.measured_page import Facts, write

    begin, end = assessment.section_m
    low_pass, split = assessment.low_pass_Hz, assessment.band_split_Hz
    kept = [
        Kept(each, bands(each, low_pass, split), counted(each, (begin, end), low_pass, split))
        for each in measurement.pantographs
    ]
    facts = Facts(measurement.name, measurement.path.name, WORDS)
    write(MeasuredData(kept, assessment), facts, path)
