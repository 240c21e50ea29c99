"""Interface of a run that a report is written of."""

from typing import Any, Protocol

from arcless.assess import Assessment
from arcless.dataset.plain_dataset import Dataset
from arcless.model import Scenario


class ReportedRun(Protocol):
    """A run with its assessment; `arcless.Result` is one."""

    @property
    def scenario(self) -> Scenario:
        """The scenario that was run."""

    @property
    def latest(self) -> Dataset:
        """Everything that was recorded."""

    @property
    def assessment(self) -> Assessment:
        """Indicators and criteria over the scenario's own section."""

    @property
    def metadata(self) -> dict[str, Any]:
        """The attributes of the dataset."""
