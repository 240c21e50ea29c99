"""Record → Dataset: building, saving and opening results."""

from arcless.dataset.metadata import metadata
from arcless.dataset.netcdf.store import open_dataset, save
from arcless.dataset.plain_dataset import dataset_from
from arcless.results.instrument.instrument import Instrument
from arcless.results.instrument.readings import Readings
from arcless.results.result import RESULT_NAME, Result, result_file
from arcless.results.result import open_result as open

__all__ = [
    "RESULT_NAME",
    "Instrument",
    "Readings",
    "Result",
    "dataset_from",
    "metadata",
    "open",
    "open_dataset",
    "result_file",
    "save",
]
