"""Record → Dataset: building, saving and opening results."""

from arcless.results.build import dataset_from
from arcless.results.result import RESULT_NAME, Result, result_file
from arcless.results.result import open_result as open
from arcless.results.store import metadata, open_dataset, save

__all__ = [
    "RESULT_NAME",
    "Result",
    "dataset_from",
    "metadata",
    "open",
    "open_dataset",
    "result_file",
    "save",
]
