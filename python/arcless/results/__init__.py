"""Record → Dataset: building, saving and opening results."""

from arcless.dataset.metadata import metadata
from arcless.dataset.netcdf.store import open_dataset, save
from arcless.dataset.plain_dataset import dataset_from
from arcless.results.instrument.instrument import Instrument
from arcless.results.instrument.readings import Readings
from arcless.results.kept_runs.kept_run import KeptRun, MainNumbers
from arcless.results.kept_runs.places import RESULT_NAME, result_file, run_file
from arcless.results.kept_runs.search import runs
from arcless.results.result import Result, explain
from arcless.results.result import open_result as open

__all__ = [
    "RESULT_NAME",
    "Instrument",
    "KeptRun",
    "MainNumbers",
    "Readings",
    "Result",
    "dataset_from",
    "explain",
    "metadata",
    "open",
    "open_dataset",
    "result_file",
    "run_file",
    "runs",
    "save",
]
