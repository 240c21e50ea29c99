"""The trials of a search as a file of Optuna: what others find in it, and what is refused."""

from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from arcless.errors import ModelError, OutputError, StudyError
from arcless.study import Study, StudyFolder, load, run
from arcless.study.folder.optuna_trials import write
from arcless.study.journal.row import Row
from tests.support.studies import data, study

FORCE = {"field": "pantographs.0.static_force", "range": ["60 N", "100 N"]}
LAW = {"field": "contact.law", "values": ["rigid", "compliant"]}
SCHEME = {"field": "solver.scheme", "values": [{"name": "trapezoidal"}]}
DESIGN = {
    "kind": "optimise", "trials": 6, "at_once": 3, "objectives": {"sigma": "minimise"},
    "constraints": [{"output": "mean", "at_least": 70}],
}  # fmt: skip


def search(**design: Any) -> Study:
    return study(
        variables={"force": FORCE, "law": LAW, "scheme": SCHEME},
        outputs={"sigma": "std_force_N", "mean": "mean_force_N"},
        design=DESIGN | design,
    )


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
    row(6),
]  # fmt: skip


def begun(folder: Path, rows: list[Row]) -> StudyFolder:
    place = StudyFolder(search(), folder)
    with place.open_journal() as journal:
        place.write_state(journal.mode)
        for one in rows:
            journal.append(one)
    return place


def trials(file: Path) -> list[Any]:
    import optuna

    return optuna.load_study(study_name="small", storage=f"sqlite:///{file}").get_trials()


def test_what_others_find(tmp_path: Path) -> None:
    import optuna

    begun(tmp_path, [ROWS[2], ROWS[0], ROWS[4], ROWS[3], ROWS[1]])  # as workers end, in any order
    # Trial n is variant n + 1: the sixth waits for the fifth.
    assert write(search(), tmp_path) == (tmp_path / "trials.db", 4)
    one, pruned, failed, last = trials(tmp_path / "trials.db")
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
    made = optuna.load_study(study_name="small", storage=f"sqlite:///{tmp_path}/trials.db")
    assert (made.metric_names, made.best_trial.number) == (["sigma"], 0)
    assert [path for path in tmp_path.iterdir() if path.name.startswith(".")] == []


def test_it_is_replaced_as_a_whole(tmp_path: Path) -> None:
    place = begun(tmp_path / "study", ROWS[:2])
    file = tmp_path / "of the team.db"
    assert write(place.study, place.path, file) == (file, 2)
    with place.open_journal() as journal:
        journal.append(ROWS[2])
        assert write(place.study, place.path, file) == (file, 3)  # while it is computed
    assert [one.user_attrs["row"]["key"] for one in trials(file)] == ["key 1", "key 2", "key 3"]


def test_trials_of_a_real_search(tmp_path: Path) -> None:
    run(search(), tmp_path)
    path, count = write(search(), tmp_path)
    assert count == 6
    there = list(StudyFolder(search(), tmp_path).rows())
    assert [one.values for one in trials(path)] == [[one.outputs["sigma"]] for one in there]


def test_what_is_refused(tmp_path: Path) -> None:
    with pytest.raises(StudyError, match="does not optimise has no trials"):
        write(study(), tmp_path)
    with pytest.raises(StudyError, match="no study was begun here"):
        write(search(), tmp_path / "none")
    place = begun(tmp_path / "study", ROWS)
    with pytest.raises(OutputError, match="no folder"):
        write(place.study, place.path, tmp_path / "none" / "trials.db")
    with pytest.raises(ModelError, match="storage"):
        load(data(**{"design": DESIGN | {"storage": "sqlite:///x.db"}}))
