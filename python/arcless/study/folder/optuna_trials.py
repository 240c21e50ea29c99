"""The trials of an optimisation as a file of Optuna, for its dashboard and `optuna.load_study`.

Made from the journal when it is asked for, and replaced as a whole; nothing of a study depends on
it.
"""

import json
import shutil
import sqlite3
import warnings
from contextlib import closing
from datetime import timedelta
from itertools import takewhile
from pathlib import Path
from typing import TYPE_CHECKING, Any

from arcless.errors import OutputError, StudyError
from arcless.platforms.moving import move
from arcless.storage import hidden_files
from arcless.storage.whole_files import check_writable, sync_folder
from arcless.study.definition.study import Study
from arcless.study.folder import table
from arcless.study.folder.folder import StudyFolder
from arcless.study.journal.database import words
from arcless.study.journal.row import Row
from arcless.study.optimisation.search import DIRECTIONS, EDGE, Search, frozen
from arcless.study.variables.variables import Axis

if TYPE_CHECKING:
    import optuna
    from optuna.distributions import BaseDistribution

NAME = "trials.db"


def write(study: Study, folder: Path | None = None, path: Path | None = None) -> tuple[Path, int]:
    """Write the trials of a study that optimises, as many as there are; also while it is computed.

    Parameters
    ----------
    study
        From `arcless.study.load`.
    folder
        Its folder; ``runs/studies/NAME`` without.
    path
        The SQLite file to write; ``trials.db`` in the folder without. One that exists is replaced.

    Returns
    -------
    pathlib.Path, int
        The file, and how many trials it has. Trial n is variant n + 1, so those after the first
        variant that is missing wait for it.

    Raises
    ------
    StudyError
        The study does not optimise, none was begun there, or another one; a package is missing.
    OutputError
        The file cannot be written.
    """
    if not isinstance(study.plan, Search):
        raise StudyError(
            "a study that does not optimise has no trials",
            got=f"design `{study.design.kind}`",
            expected="design `optimise`",
        )
    table.needs("optuna", "a study that optimises")
    place = StudyFolder(study, folder)
    place.check_same()
    target = place.path / NAME if path is None else path
    check_writable(target)
    counted = takewhile(lambda pair: pair[0] == pair[1].variant, enumerate(place.rows(), start=1))
    return target, _write(target, study, study.plan, [row for _, row in counted])


def _write(target: Path, study: Study, search: Search, rows: list[Row]) -> int:
    hidden = target.with_name(hidden_files.new_name())
    try:
        hidden_files.sweep(target.parent)
        claim = hidden_files.create_folder(hidden)
    except OSError as error:
        raise _not_written(error, target) from error
    try:
        _fill(hidden / NAME, study, search, rows)
        move(hidden / NAME, target)
        sync_folder(target.parent)
    except (OSError, sqlite3.Error) as error:
        raise _not_written(error, target) from error
    finally:
        shutil.rmtree(hidden, ignore_errors=True)
        claim.close()
    return len(rows)


def _not_written(error: OSError | sqlite3.Error, target: Path) -> OutputError:
    what, hint = "the trials cannot be written", "choose another file with `--to`"
    if isinstance(error, OSError):
        return OutputError.of(error, what, target, hint)
    return OutputError(what, where=str(target), got=words(error), hint=hint)


def _fill(file: Path, study: Study, search: Search, rows: list[Row]) -> None:
    import optuna
    from sqlalchemy.exc import DBAPIError
    from sqlalchemy.pool import StaticPool

    optuna.logging.set_verbosity(optuna.logging.ERROR)
    aims = search.design.objectives
    with closing(sqlite3.connect(file, check_same_thread=False)) as base:
        base.execute("PRAGMA synchronous = OFF")  # the whole file takes its place when it is done
        base.execute("PRAGMA journal_mode = MEMORY")
        kwargs = {"creator": lambda: base, "poolclass": StaticPool}
        try:
            storage = optuna.storages.RDBStorage("sqlite://", engine_kwargs=kwargs)
            made = optuna.create_study(
                storage=storage,
                study_name=study.name,
                directions=[DIRECTIONS[goal] for goal in aims.values()],
            )
            with warnings.catch_warnings():
                warnings.simplefilter("ignore", optuna.exceptions.ExperimentalWarning)
                made.set_metric_names(list(aims))
            made.add_trials([_trial(study, search, row) for row in rows])
            storage.remove_session()
        except DBAPIError as error:
            if isinstance(error.orig, sqlite3.Error):
                raise error.orig from None
            raise


def _trial(study: Study, search: Search, row: Row) -> "optuna.trial.FrozenTrial":
    """Return a row as a trial, with the values of the variables as the table has them."""
    distributions = {axis.name: _distribution(study, axis) for axis in search.axes}
    params = {axis.name: _param(axis, row.values[axis.name]) for axis in search.axes}
    about = {
        "key": row.key,
        "status": row.status,
        "reason": row.error,
        "stopped_at_m": row.stopped_at_m,
        "stopped_after_s": row.stopped_after_s,
        "arcless_version": row.arcless_version,
    }
    kept: dict[str, Any] = {}
    kept["row"] = {name: value for name, value in about.items() if value not in (None, "")}
    if row.outputs:
        kept["outputs"] = row.outputs
    trial = frozen(search.design, row, params, distributions, user_attrs=kept)
    assert trial.datetime_complete is not None
    trial.datetime_start = trial.datetime_complete - timedelta(seconds=row.wall_time_s)
    return trial


def _distribution(study: Study, axis: Axis) -> "BaseDistribution":
    """Return what values a variable has, in SI; groups as JSON."""
    from optuna.distributions import CategoricalDistribution, FloatDistribution

    if axis.levels is not None:
        return CategoricalDistribution(list(dict.fromkeys(_param(axis, v) for v in axis.levels)))
    edge = EDGE if study.variables[axis.name].range is None else 0.0
    return FloatDistribution(axis.quantile(edge), axis.quantile(1.0 - edge))


def _param(axis: Axis, value: Any) -> Any:
    plain = axis.levels is None or value is None or isinstance(value, bool | int | float | str)
    return value if plain else json.dumps(value, ensure_ascii=False)
