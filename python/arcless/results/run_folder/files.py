"""Files of a run in its folder."""

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

from arcless.results.kept_runs.places import ASSESSMENT_NAME, REPORT_NAME, RESULT_NAME
from arcless.results.result import Result
from arcless.storage.output_folder import OutputFolder
from arcless.storage.whole_files import write_bytes

if TYPE_CHECKING:
    from arcless.model import Scenario

# Published ranges for the report, from a scenario and its assessment as plain values.
Ranges = Callable[["Scenario", dict[str, Any]], list[dict[str, Any]]]


def write(
    result: Result,
    folder: OutputFolder,
    report: Ranges | None,
    tell: Callable[[str], None] = lambda _doing: None,
) -> list[Path]:
    """Write the files of a run; of one that stopped early, the result alone.

    Parameters
    ----------
    result
        The run.
    folder
        Its folder, as `run_folder.for_run` gives it. A long run has written its result there
        already.
    report
        Published ranges for the report; without them none is written.
    tell
        Told what is being done.

    Returns
    -------
    list of Path
        The files, at their final names.

    Raises
    ------
    OutputError
        The folder cannot be written.
    """
    if not folder.file(RESULT_NAME).exists():
        tell("writing the result")
        result.save(folder.file(RESULT_NAME))
    if result.is_complete:
        tell("assessing")
        write_bytes(folder.file(ASSESSMENT_NAME), result.assessment.to_json().encode())
        if report is not None:
            tell("writing the report")
            rows = report(result.scenario, result.assessment.to_dict())
            result.write_report(folder.file(REPORT_NAME), reference_rows=rows)
    return folder.publish()
