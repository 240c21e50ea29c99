"""A small study: a short line, runs of some ten milliseconds each."""

import sqlite3
from collections.abc import Callable
from contextlib import closing
from pathlib import Path
from typing import Any

from arcless.study import Study, StudyFolder, load
from arcless.study.evaluation.variants import variant
from arcless.study.journal.row import Row, Status

SHORT = Path(__file__).parents[1] / "interface" / "data" / "short.yaml"
# Four spans in 4 ms steps.
QUICK = {
    "line.spans": [{"type": "span", "count": 4}],
    "travel": {"start": "50 m", "end": "120 m"},
    "analysis": {"from": "55 m", "to": "115 m"},
    "solver.time_step": "4 ms",
}
# The last force is none: such variants are rows with the reason.
VARIABLES = {
    "tension": {"field": "line.contact_wire.tension", "range": ["18 kN", "26 kN"], "count": 2},
    "force": {"field": "pantographs.0.static_force", "values": ["70 N", "90 N", "-5 N"]},
}
OUTPUTS = {"sigma": "std_force_N", "ratio": "std_force_N / mean_force_N"}
# What depends on the machine, not on the study.
TIMES = ["wall_time_s"]


def data(**changes: Any) -> dict[str, Any]:
    """Return the data of a study of six variants, two of them invalid."""
    return {
        "format": "arcless-study/1",
        "name": "small",
        "scenario": str(SHORT),
        "set": QUICK,
        "variables": VARIABLES,
        "design": {"kind": "grid"},
        "outputs": OUTPUTS,
        **changes,
    }


def study(**changes: Any) -> Study:
    """Return that study."""
    return load(data(**changes))


def written(folder: Path, **changes: Any) -> Path:
    """Write that study as a file."""
    import json

    file = folder / "small.yaml"
    file.write_text(json.dumps(data(**changes), indent=1))
    return file


def rows(table: Path) -> list[dict[str, Any]]:
    """Return the rows of a table without times."""
    import pyarrow.parquet

    found: list[dict[str, Any]] = pyarrow.parquet.read_table(table).drop(TIMES).to_pylist()
    return found


def filled(folder: Path, *, of: int | None = None, error: str = "", **changes: Any) -> Study:
    """Return a study whose rows are made up, not computed: sigma is a plain sum."""
    made = study(**changes)
    place = StudyFolder(made, folder)
    with place.open_journal() as journal:
        place.write_state(journal.mode)
        for number in range(1, (made.plan.count if of is None else of) + 1):
            one = variant(made, number)
            numbers = [value for value in one.values.values() if isinstance(value, float)]
            outputs: dict[str, float | None] = dict.fromkeys(made.outputs, 1e-3 * sum(numbers))
            status: Status = "failed" if error else "done"
            journal.append(
                Row(number, one.key, one.values, status, {} if error else outputs, error, 0.1, "v")
            )
    return made


def filled_by(
    folder: Path, outputs_of: Callable[[dict[str, Any]], dict[str, Any]], **changes: Any
) -> Study:
    """Return a study whose outputs are made up from the values of each variant, in SI."""
    made = study(**changes)
    place = StudyFolder(made, folder)
    with place.open_journal() as journal:
        place.write_state(journal.mode)
        for number in range(1, made.plan.count + 1):
            one = variant(made, number)
            outputs = outputs_of(one.values)
            error = outputs.pop("error", "")
            journal.append(Row(number, one.key, one.values, "done", outputs, str(error), 0.1, "v"))
    return made


def journal_of(folder: Path, name: str = "small") -> StudyFolder:
    """Return the folder of a study that a command line began below a folder."""
    return StudyFolder(load(folder / f"{name}.yaml"), folder / "runs" / "studies" / name)


def rows_in(journal: Path) -> int:
    """Return how many rows a journal has, also while it is written; 0 of none."""
    try:
        with closing(sqlite3.connect(f"{journal.absolute().as_uri()}?mode=ro", uri=True)) as base:
            return int(base.execute("SELECT count(*) FROM rows").fetchone()[0])
    except sqlite3.OperationalError:  # not made yet
        return 0


def made_up(made: Study, number: int) -> Row:
    """Return a row that follows from its variant, without computing; some are long, some fail."""
    one = variant(made, number)
    sigma = sum(value for value in one.values.values() if isinstance(value, float)) / 7.0
    long = "no contact " * (600 if number % 50 == 0 else number % 9)  # beyond a page of the file
    if number % 10 == 0:
        return Row(number, one.key, one.values, "failed", {}, long, 0.25, "v")
    outputs = {"sigma": sigma, "ratio": None}
    return Row(number, one.key, one.values, "done", outputs, "", 0.25, "v")
