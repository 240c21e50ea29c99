"""Optuna's storage: what others find in it, how it follows the journal, and what is refused."""

import time
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from arcless.errors import ArclessError, OutputError, StorageError, StudyError
from arcless.study import Progress, Study, StudyFolder, run
from arcless.study.database import Database, hidden
from arcless.study.rows import Row
from arcless.study.storage import Storage
from arcless.study.variants import variant
from tests.support.studies import rows, study

FORCE = {"field": "pantographs.0.static_force", "range": ["60 N", "100 N"]}
LAW = {"field": "contact.law", "values": ["rigid", "compliant"]}
SCHEME = {"field": "solver.scheme", "values": [{"name": "trapezoidal"}]}
DESIGN = {
    "kind": "optimise", "trials": 6, "at_once": 3, "objectives": {"sigma": "minimise"},
    "constraints": [{"output": "mean", "at_least": 70}],
}  # fmt: skip
SECRET = "pa ss"


def search(**design: Any) -> Study:
    return study(
        variables={"force": FORCE, "law": LAW, "scheme": SCHEME},
        outputs={"sigma": "std_force_N", "mean": "mean_force_N"},
        design=DESIGN | design,
    )


def begun(folder: Path, made: Study | None = None) -> StudyFolder:
    place = StudyFolder(made or search(), folder)
    place.make()
    place.write_state()
    return place


def row(number: int, status: str = "done", **more: Any) -> Row:
    values = {"force": 60.0 + number, "law": "rigid", "scheme": {"name": "trapezoidal"}}
    outputs = {"sigma": float(number), "mean": 69.0 + number} if status == "done" else {}
    return Row(number, f"key {number}", values, status, outputs, "", 1.5, "v", **more)  # type: ignore[arg-type]


ROWS = [
    row(1, so_far={"sigma": [3.0, 2.0], "mean": [69.0, 70.0]}),
    replace(row(2, "pruned", so_far={"sigma": [9.0], "mean": [65.0]}, stopped_at_m=80.0),
            error="too far behind"),
    replace(row(3, "failed"), error="no contact"),
    row(4),
]  # fmt: skip


def trials(where: str | Path, name: str = "small") -> list[Any]:
    import optuna

    url = where if isinstance(where, str) else f"sqlite:///{where}"
    return optuna.load_study(study_name=name, storage=url).get_trials()


def kept(place: StudyFolder, given: list[Row], url: str | None = None, *, anew: bool) -> None:
    storage = Storage(place.study, place, url)
    try:
        storage.begin(anew=anew)
        for one in given:
            storage.take(one)
    finally:
        storage.close()


def test_what_others_find(tmp_path: Path) -> None:
    import optuna

    place = begun(tmp_path)
    kept(place, [ROWS[2], ROWS[0], ROWS[3], ROWS[1]], anew=True)  # as workers end, in any order
    one, pruned, failed, last = trials(tmp_path / "optuna.db")
    assert [t.state.name for t in (one, pruned, failed, last)] == [
        "COMPLETE", "PRUNED", "FAIL", "COMPLETE",
    ]  # fmt: skip
    assert one.params == {"force": 61.0, "law": "rigid", "scheme": '{"name": "trapezoidal"}'}
    assert one.distributions["force"] == optuna.distributions.FloatDistribution(60.0, 100.0)
    assert one.distributions["law"].choices == ("rigid", "compliant")
    assert (one.values, one.constraints) == ([1.0], {"0": 0.0})
    assert one.intermediate_values == {1: 3.0, 2: 2.0}
    assert one.user_attrs["outputs"] == {"sigma": 1.0, "mean": 70.0}
    # A database keeps microseconds.
    assert one.duration.total_seconds() == pytest.approx(1.5, abs=1e-5)
    assert (pruned.intermediate_values, pruned.constraints) == ({1: 9.0}, {"0": 5.0})
    assert pruned.user_attrs["row"]["reason"] == "too far behind"
    assert pruned.user_attrs["row"]["stopped_at_m"] == 80.0
    assert failed.user_attrs["row"]["reason"] == "no contact"
    made = optuna.load_study(study_name="small", storage=f"sqlite:///{tmp_path}/optuna.db")
    assert (made.metric_names, made.best_trial.number) == (["sigma"], 0)


@pytest.mark.parametrize("there", [0, 1, 3])
def test_who_goes_on_adds_what_is_missing(tmp_path: Path, there: int) -> None:
    place = begun(tmp_path)
    kept(place, ROWS[:there], anew=True)
    kept(place, ROWS, anew=False)
    kept(place, ROWS, anew=False)
    found = trials(tmp_path / "optuna.db")
    assert [trial.user_attrs["row"]["key"] for trial in found] == [one.key for one in ROWS]


def test_other_trials_in_its_place_are_refused(tmp_path: Path) -> None:
    place = begun(tmp_path)
    kept(place, ROWS[:2], anew=True)
    with pytest.raises(StudyError, match="other trials under the name of this study"):
        kept(place, [replace(ROWS[0], key="another")], anew=False)


def test_another_study_of_the_name_is_refused(tmp_path: Path) -> None:
    url = f"sqlite:///{tmp_path}/shared.db"
    kept(begun(tmp_path / "one"), ROWS, url, anew=True)
    for anew in (True, False):
        with pytest.raises(StudyError) as refused:
            kept(begun(tmp_path / "other"), ROWS, url, anew=anew)
        assert f"study `small`, begun in {tmp_path}/one on " in str(refused.value)
    renamed = search().to_dict() | {"name": "another"}
    kept(begun(tmp_path / "other", study(**renamed)), ROWS[:1], url, anew=True)
    assert (len(trials(url)), len(trials(url, "another"))) == (4, 1)


def test_killed_before_its_first_row_it_may_begin_again(tmp_path: Path) -> None:
    url = f"sqlite:///{tmp_path}/shared.db"
    for _ in range(2):
        kept(begun(tmp_path / "one"), [], url, anew=True)
    with pytest.raises(StudyError, match="other trials"):
        kept(begun(tmp_path / "other"), [], url, anew=True)


def test_another_process_that_writes_is_noticed(tmp_path: Path) -> None:
    import optuna

    place = begun(tmp_path)
    storage = Storage(place.study, place, None)
    storage.begin(anew=True)
    storage.take(ROWS[0])
    optuna.load_study(study_name="small", storage=f"sqlite:///{tmp_path}/optuna.db").ask()
    with pytest.raises(StudyError, match="other trials"):
        storage.take(ROWS[1])
    storage.close()


def test_a_run_and_its_storage(tmp_path: Path) -> None:
    made, seen = search(), list[Progress]()
    with pytest.raises(KeyboardInterrupt):
        run(made, tmp_path / "one", tell=seen.append, cancel=lambda: len(seen) > 2)
    (tmp_path / "one" / "optuna.db").unlink()  # it is made again from the journal
    run(search(), tmp_path / "one", resume=True)
    url = f"sqlite:///{tmp_path}/shared.db"
    run(search(), tmp_path / "other", storage=url)
    assert not (tmp_path / "other" / "optuna.db").exists()
    table = rows(tmp_path / "one" / "table.parquet")
    assert table == rows(tmp_path / "other" / "table.parquet")
    for found in (trials(tmp_path / "one" / "optuna.db"), trials(url)):
        assert [trial.values for trial in found] == [[item["sigma"]] for item in table]
        assert [trial.params["force"] for trial in found] == [item["force"] for item in table]
        keys = [variant(search_known(tmp_path / "one"), n + 1).key for n in range(6)]
        assert [trial.user_attrs["row"]["key"] for trial in found] == keys


def search_known(folder: Path) -> Study:
    made = search()
    StudyFolder(made, folder).recall()
    return made


def test_cut_off_between_journal_and_storage(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    run(search(), tmp_path / "whole")
    real, left = Storage._add, [2]

    def cut(self: Storage, storage: Any, one: Row) -> None:
        if not left[0]:
            raise KeyboardInterrupt  # its line is in the journal by now
        left[0] -= 1
        real(self, storage, one)

    with monkeypatch.context() as patch:
        patch.setattr(Storage, "_add", cut)
        with pytest.raises(KeyboardInterrupt):
            run(search(), tmp_path / "cut")
    assert len(trials(tmp_path / "cut" / "optuna.db")) == 2
    assert len(list(StudyFolder(search(), tmp_path / "cut").rows())) >= 3
    run(search(), tmp_path / "cut", resume=True)
    tables = [rows(tmp_path / name / "table.parquet") for name in ("whole", "cut")]
    assert tables[0] == tables[1]
    assert len(trials(tmp_path / "cut" / "optuna.db")) == 6


def refused(url: str, file: Path | None = None) -> ArclessError:
    with pytest.raises(ArclessError) as caught:
        Database(url, file)
    assert SECRET not in str(caught.value) and "pa%20ss" not in str(caught.value)
    return caught.value


@pytest.mark.parametrize(
    ("url", "message"),
    [
        ("postgresql+pg0://me:pa%20ss@h/db", "no database that can be opened"),
        ("nosuch://me:pa%20ss@h/db", "no database that can be opened"),
        ("sqlite+none://me:pa%20ss@h", "no database that can be opened"),
        ("mssql+pymssql://me:pa%20ss@h/db", "a package that is not installed"),
    ],
)
def test_urls_that_open_nothing(url: str, message: str) -> None:
    error = refused(url)
    assert isinstance(error, StudyError)
    assert message in str(error) and "me:***@h" in str(error)


def test_files_that_are_none(tmp_path: Path) -> None:
    damaged = tmp_path / "damaged.db"
    damaged.write_bytes(b"no database, but long enough to be taken for one" * 40)
    for file in (damaged, tmp_path, tmp_path / "none" / "x.db"):
        error = refused("sqlite://", file)
        assert isinstance(error, OutputError)
        assert "made again from the journal" in str(error) and str(file) in str(error)
    assert damaged.read_bytes().startswith(b"no database")


def test_a_database_that_does_not_answer(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("arcless.study.database.CONNECTS_WITHIN_S", 0.1)
    with monkeypatch.context() as patch:
        patch.setattr(Database, "_connect", lambda _self: time.sleep(30))
        error = refused("postgresql://me:pa%20ss@h/db?password=pa%20ss")
    assert isinstance(error, StorageError)
    assert "got nothing for 0.1 s" in str(error)


def test_a_server_that_refuses(monkeypatch: pytest.MonkeyPatch) -> None:
    from sqlalchemy.exc import OperationalError

    def fails(_self: Database) -> None:
        told = Exception(f"connection to h failed for me:{SECRET} (pa%20ss)\nmore")
        raise OperationalError("SELECT 1", {}, told)

    monkeypatch.setattr(Database, "_connect", fails)
    error = refused("postgresql://me:pa%20ss@h/db")
    assert isinstance(error, StorageError)
    assert "connection to h failed for me:*** (***)" in str(error)


def test_passwords_are_hidden(tmp_path: Path) -> None:
    assert hidden("sqlite:////a/b.db") == "sqlite:////a/b.db"
    assert hidden("mysql+pymysql://u:s@h:33/d?x=1&password=s&y=2") == (
        "mysql+pymysql://u:***@h:33/d?x=1&password=***&y=2"
    )
    file = tmp_path / "small.yaml"
    file.write_text(_text("postgresql+pg0://me:pa%20ss@h/db"))
    from arcless.study import load

    made = load(file)
    place = begun(tmp_path / "out", made)
    with pytest.raises(StudyError):
        run(made, tmp_path / "new")
    assert not (tmp_path / "new").exists()
    for path in place.path.iterdir():
        assert "pa%20ss" not in path.read_text("utf-8")
    assert "me:***@h" in (place.path / "study.yaml").read_text("utf-8")


def test_where_the_trials_go_may_change(tmp_path: Path) -> None:
    place = begun(tmp_path)
    other = search(storage=f"sqlite:///{tmp_path}/elsewhere.db")
    assert StudyFolder(other, place.path).check_same()["id"]


def _text(url: str) -> str:
    import json

    from tests.support.studies import data

    return json.dumps(data(variables={"force": FORCE}, design={**DESIGN, "constraints": [],
                                                               "storage": url}))  # fmt: skip


@pytest.mark.parametrize("url", ["me:pa ss@h/db", "here.db"])
def test_no_url_is_refused_without_showing_it(url: str) -> None:
    with pytest.raises(ArclessError) as caught:
        search(storage=url)
    assert "no URL of a database" in str(caught.value) and url not in str(caught.value)


def test_only_an_optimisation_has_a_storage(tmp_path: Path) -> None:
    with pytest.raises(StudyError, match="does not optimise has no storage"):
        run(study(), tmp_path / "new", storage="sqlite:///x.db")
    assert not (tmp_path / "new").exists()
