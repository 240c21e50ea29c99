"""Functions of worker processes: a run, its report on paper, its explanation."""

from contextlib import ExitStack
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from arcless.model import Scenario, scenario_warnings
from arcless.results import Result
from arcless.results import open as open_result
from arcless.results.kept_runs.places import RESULT_NAME
from arcless.results.kept_runs.reading import read
from arcless.results.run_folder import files
from arcless.results.run_folder.run_folder import for_run
from arcless.storage import hidden_files
from arcless.studio.at_rest.of_run import geometry_of_run
from arcless.studio.jobs.spooling import spooled
from arcless.studio.motion.watching import Watching
from arcless.studio.processes.talk import Talk
from arcless.studio.runs.order import Order

# A file as it was: when it was changed, how large it is, and which one it is on the disk.
Identity = tuple[int, int, int]


def run(talk: Talk, order: Order) -> dict[str, Any]:
    """Run a scenario into its folder, as `arcless run` does; return what a list of runs has of it.

    Raises
    ------
    ArclessError
        As `arcless.run`, and where the folder cannot be written.
    """
    from arcless.validate import reference_rows

    for warning in scenario_warnings(order.scenario):
        talk.note(warning)
    with for_run(order.folder, overwrite=order.replace) as folder:
        result = _simulate(talk, order.scenario, folder.file(RESULT_NAME), order.command)
        _note_others(talk, result, order)
        if talk.cancel():
            raise KeyboardInterrupt
        files.write(result, folder, reference_rows, lambda doing: talk.progress(1.0, doing))
    return described(order.folder)


def motion(talk: Talk, file: Path) -> bool:
    """Run a stored scenario again to see its line move; return whether forces are the same bits.

    Nothing is written but the spool.
    """
    stored = open_result(file)
    with hidden_files.temporary_folder() as folder:
        again = _simulate(talk, stored.scenario, folder / RESULT_NAME, None)
        before, now = (one.recorded["contact_force"].values for one in (stored, again))
        same = bool(np.array_equal(before, now))
    if not same:
        talk.note(
            "The forces of this motion differ from those that are stored, which Arcless"
            f" {stored.metadata['arcless_version']} computed: it is not the motion of that run."
        )
    return same


def _simulate(talk: Talk, scenario: Scenario, to: Path, command: str | None) -> Result:
    """Run a scenario that may be watched; a long one is written to a file while it steps."""
    from arcless import simulate

    with ExitStack() as stack:
        watching = Watching(scenario, partial(spooled, talk)) if talk.shows() else None
        result = simulate.run(
            scenario,
            to=to if simulate.is_long(scenario) else None,
            command=command,
            progress=talk.progress,
            cancel=talk.cancel,
            watch=None if watching is None else stack.enter_context(watching),
        )
    if watching is not None and watching.full:
        talk.note(
            "The disk of temporary files has no room: the motion that is shown ends before the run,"
            " whose result is whole."
        )
    return result


def _note_others(talk: Talk, result: Result, order: Order) -> None:
    """Tell the warnings that only the run could give."""
    known = set(scenario_warnings(order.scenario))
    for warning in result.metadata["warnings"] or []:
        if warning not in known:
            talk.note(warning)


def described(folder: Path) -> dict[str, Any]:
    """Return a run in a few words, without its path, which the page knows."""
    file = folder / RESULT_NAME
    found = read(file).to_dict()
    del found["path"]
    return found | {"identity": identity_of(file)}


def identity_of(file: Path) -> Identity:
    """Return what tells a file from the one that takes its name later."""
    state = file.stat()
    return state.st_mtime_ns, state.st_size, state.st_ino


def told(_talk: Talk, file: Path) -> dict[str, Any]:
    """Return all that the page shows of a run: scenario, assessment, what was set for it."""
    import yaml

    result = open_result(file)
    facts = result.metadata
    return {
        "name": facts["scenario_name"],
        "scenario": yaml.safe_dump(facts["scenario"], sort_keys=False, allow_unicode=True),
        "changes": result.scenario.changes,
        "created": facts["created"],
        "arcless_version": facts["arcless_version"],
        "command": facts["command"],
        "warnings": facts["warnings"] or [],
        "speed_m_s": result.scenario.speed,
        "simulated_time_s": facts["simulated_time_s"],
        "section_m": facts["section_m"],
        "wave_speed_m_s": facts["wave_speed_m_s"],
        "complete": result.is_complete,
        "assessment": result.assessment.to_dict() if result.is_complete else None,
    }


def line(_talk: Talk, file: Path) -> dict[str, Any]:
    """Return the geometry of the line of a run."""
    return dict(geometry_of_run(open_result(file)))


def write_report(talk: Talk, file: Path, to: Path) -> str:
    """Write the report of a run, by the ending of `to` on paper or as a page; return its name."""
    from arcless.validate import reference_rows

    result = open_result(file)
    talk.progress(0.1, "assessing")
    rows = reference_rows(result.scenario, result.assessment.to_dict())
    if talk.cancel():
        raise KeyboardInterrupt
    talk.progress(0.3, "writing the report")
    write = result.write_pdf if to.suffix == ".pdf" else result.write_report
    write(to, reference_rows=rows)
    return to.name
