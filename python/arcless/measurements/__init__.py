"""Measured test runs: read from CSV files, with what is wrong in them left out and told."""

from arcless.measurements.assessed import assess
from arcless.measurements.measurement import Measurement
from arcless.measurements.page import write_report
from arcless.measurements.read import is_measured, read
from arcless.measurements.samples.inertia import Head
from arcless.measurements.samples.left_out import LeftOut
from arcless.measurements.samples.pantograph import MeasuredPantograph

__all__ = [
    "Head",
    "LeftOut",
    "MeasuredPantograph",
    "Measurement",
    "assess",
    "is_measured",
    "read",
    "write_report",
]
