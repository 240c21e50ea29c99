"""Optuna's storage of a study: a database that others may look into while it is computed.

The journal is the truth of what was computed, and what is chosen follows from it alone. The
storage follows the journal: a trial for each row, in the order of the variants, each in one
transaction, after its line is in the journal. So whatever was killed when, the storage holds the
first rows of the journal; whoever goes on compares these and adds the rest.
"""

import json
import socket
import warnings
from collections.abc import Callable
from datetime import timedelta
from pathlib import Path
from typing import TYPE_CHECKING, Any

from arcless.errors import StudyError
from arcless.study.database import Database
from arcless.study.folder import StudyFolder
from arcless.study.model import Study
from arcless.study.rows import Row
from arcless.study.search import DIRECTIONS, EDGE, Search, frozen
from arcless.study.variables import Axis

if TYPE_CHECKING:
    import optuna
    from optuna.distributions import BaseDistribution

FILE = "optuna.db"
_MARK = "arcless"


class Storage:
    """The trials of a study in a database.

    Parameters
    ----------
    study, place
        The study and its folder.
    url
        Of the database; None for a file in the folder.

    Raises
    ------
    StudyError
        The URL names no database, or a package is missing.
    StorageError
        The database does not answer.
    """

    def __init__(self, study: Study, place: StudyFolder, url: str | None) -> None:
        assert isinstance(study.plan, Search)
        self._study, self._place, self._search = study, place, study.plan
        self._file = place.path / FILE if url is None else None
        self._database: Database | None = None if url is None else Database(url)
        self._waiting: dict[int, Row] = {}
        self._keys: list[str] = []
        self._study_id = 0

    def begin(self, *, anew: bool) -> None:
        """Make the study in the database, or find it there; the folder knows which one it is.

        Raises
        ------
        StudyError
            The database holds another study of this name.
        OutputError
            The file cannot be written.
        StorageError
            The database does not answer.
        """
        if self._file is not None:
            if anew:  # a file without rows beside it tells of nothing
                for path in (self._file, Path(f"{self._file}-journal")):
                    path.unlink(missing_ok=True)
            self._database = Database.file(self._file)
        self._keys = self._call(self._begin)

    def take(self, row: Row) -> None:
        """Keep the trial of a row; it waits for those of lower numbers.

        Raises
        ------
        StudyError
            The database has another trial in its place.
        OutputError, StorageError
            As `begin`.
        """
        self._waiting[row.variant] = row
        while (number := len(self._keys) + 1) in self._waiting:
            self._call(self._add, self._waiting[number])
            self._keys.append(self._waiting[number].key)
        for number in [n for n in self._waiting if n <= len(self._keys)]:
            self._check_key(self._waiting.pop(number))

    def close(self) -> None:
        """Let go of the database."""
        if self._database is not None:
            self._database.close()

    def _call(self, what: Callable[..., Any], *given: Any) -> Any:
        assert self._database is not None
        return self._database.call(what, *given)

    def _begin(self, storage: "optuna.storages.RDBStorage") -> list[str]:
        """Return the keys of the trials that are there."""
        import optuna

        own = self._identity()
        try:
            made = optuna.load_study(study_name=self._study.name, storage=storage)
        except KeyError:
            made = self._make(storage)
        theirs = made.user_attrs.get(_MARK)
        trials = made.get_trials(deepcopy=False)
        # Whoever was killed before its first row may begin again.
        here = theirs is None or all(theirs[name] == own[name] for name in ("host", "folder"))
        if (theirs is None or theirs["id"] != own["id"]) and (trials or not here):
            raise self._another(theirs)
        made.set_user_attr(_MARK, own)
        self._study_id = storage.get_study_id_from_name(self._study.name)
        return [str(trial.user_attrs.get("row", {}).get("key")) for trial in trials]

    def _identity(self) -> dict[str, str]:
        state = self._place.state()
        assert state is not None
        return {
            "id": state.get("id", state["begun"]),
            "hash": state["hash"],
            "host": socket.gethostname(),
            "folder": str(self._place.path.absolute()),
            "arcless_version": state["arcless_version"],
        }

    def _make(self, storage: "optuna.storages.RDBStorage") -> "optuna.Study":
        import optuna

        aims = self._search.design.objectives
        directions = [DIRECTIONS[goal] for goal in aims.values()]
        try:
            made = optuna.create_study(
                storage=storage, study_name=self._study.name, directions=directions
            )
        except optuna.exceptions.DuplicatedStudyError:  # another process was faster
            raise self._another(None) from None
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", optuna.exceptions.ExperimentalWarning)
            made.set_metric_names(list(aims))
        return made

    def _add(self, storage: "optuna.storages.RDBStorage", row: Row) -> None:
        made = storage.create_new_trial(self._study_id, template_trial=self._trial(row))
        number = storage.get_trial_number_from_id(made)
        if number != row.variant - 1:
            raise self._another(None)

    def _trial(self, row: Row) -> "optuna.trial.FrozenTrial":
        """Return a row as a trial, with the values of the variables as the table has them."""
        distributions = {axis.name: self._distribution(axis) for axis in self._search.axes}
        params = {axis.name: _param(axis, row.values[axis.name]) for axis in self._search.axes}
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
        trial = frozen(self._search.design, row, params, distributions, user_attrs=kept)
        assert trial.datetime_complete is not None
        trial.datetime_start = trial.datetime_complete - timedelta(seconds=row.wall_time_s)
        return trial

    def _distribution(self, axis: Axis) -> "BaseDistribution":
        """Return what values a variable has, in SI; groups as JSON."""
        from optuna.distributions import CategoricalDistribution, FloatDistribution

        if axis.levels is not None:
            return CategoricalDistribution(
                list(dict.fromkeys(_param(axis, v) for v in axis.levels))
            )
        edge = EDGE if self._study.variables[axis.name].range is None else 0.0
        return FloatDistribution(axis.quantile(edge), axis.quantile(1.0 - edge))

    def _check_key(self, row: Row) -> None:
        if self._keys[row.variant - 1] != row.key:
            raise self._another(None)

    def _another(self, theirs: dict[str, str] | None) -> StudyError:
        assert self._database is not None
        begun = "" if theirs is None else f", begun in {theirs['folder']} on {theirs['host']}"
        return StudyError(
            "the storage holds other trials under the name of this study",
            where=self._database.shown,
            got=f"study `{self._study.name}`{begun}",
            expected="no study of that name, or the one that was begun in this folder",
            hint="give this study another `name`, another database with `--storage`, or delete"
            " the old one with `optuna delete-study`",
        )


def _param(axis: Axis, value: Any) -> Any:
    plain = axis.levels is None or value is None or isinstance(value, bool | int | float | str)
    return value if plain else json.dumps(value, ensure_ascii=False)
