"""Optimisation: known optima, fronts, constraints, going on, and what is refused."""

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from arcless.errors import ModelError, StudyError
from arcless.study import Execution, Optimise, Progress, Study, StudyFolder, run
from arcless.study.evaluation.evaluate import Take, evaluate
from arcless.study.evaluation.variants import variant
from arcless.study.journal.row import Row
from tests.support.studies import rows, study
from tests.support.wear import wear_data

FORCE = {"force": {"field": "pantographs.0.static_force", "range": ["40 N", "200 N"]}}
# Friction grows with the force and the current wears at low force: one least value between.
WEAR = wear_data(mechanical__force_exponent=1.0, joule__factor=2.2e-7)
GRID_COUNT = 81  # 2 N apart


def search(**changes: Any) -> Study:
    """Return a search for the force of least wear."""
    base = study().to_dict()["set"]
    design = {"kind": "optimise", "trials": 40, "objectives": {"wear": "minimise"}}
    given: dict[str, Any] = {
        "set": base | {"wear": WEAR},
        "variables": FORCE,
        "outputs": {"wear": "wear_total_mm3_km", "mean": "mean_force_N"},
        "design": design | changes.pop("design", {}),
    }
    return study(**given | changes)


@pytest.fixture(scope="module")
def found(tmp_path_factory: pytest.TempPathFactory) -> tuple[Study, Path]:
    """Return that search with its folder."""
    folder = tmp_path_factory.mktemp("search")
    made = search()
    run(made, folder)
    return made, folder


def best(made: Study, folder: Path) -> list[Row]:
    assert isinstance(made.design, Optimise)
    return made.design.best(StudyFolder(made, folder).rows())


def test_finds_the_optimum_of_a_fine_grid(found: tuple[Study, Path], tmp_path: Path) -> None:
    fine = {"force": {**FORCE["force"], "count": GRID_COUNT}}
    grid = search(variables=fine).to_dict() | {"design": {"kind": "grid"}}
    run(study(**{key: grid[key] for key in ("set", "variables", "outputs", "design")}), tmp_path)
    table = rows(tmp_path / "table.parquet")
    known = min(table, key=lambda row: row["wear"])
    assert 40.0 < known["force"] < 200.0  # inside, so there is something to be found
    (row,) = best(*found)
    # Forty of a continuous range: within four steps of the grid, whose wear hardly differs there.
    assert row.values["force"] == pytest.approx(known["force"], abs=8.0)
    # Nothing is better than the least value by more than the grid is coarse: a flat minimum.
    assert row.outputs["wear"] == pytest.approx(known["wear"], rel=5e-3)


def test_the_search_closes_in(found: tuple[Study, Path]) -> None:
    table = rows(found[1] / "table.parquet")
    (row,) = best(*found)
    mean = [
        sum(abs(item["force"] - row.values["force"]) for item in part) / len(part)
        for part in (table[:12], table[-12:])
    ]
    assert mean[1] < mean[0]


@pytest.mark.parametrize("stop", [3, 9])
def test_cut_off_and_resumed_it_is_the_same_table(
    found: tuple[Study, Path], tmp_path: Path, stop: int
) -> None:
    seen: list[Progress] = []
    with pytest.raises(KeyboardInterrupt):
        run(search(), tmp_path, tell=seen.append, cancel=lambda: len(seen) > stop)
    again = run(search(), tmp_path, resume=True, executor=Execution(workers=1))
    assert 0 < again.computed < 40
    assert rows(tmp_path / "table.parquet") == rows(found[1] / "table.parquet")


def test_worker_processes_are_started_once(
    found: tuple[Study, Path], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    told: list[str] = []

    @contextmanager
    def local(_workers: int | None) -> Iterator[str]:
        told.append("started")
        yield "client"
        told.append("stopped")

    class Chunks:
        def __init__(self, _client: str, *what: Any) -> None:
            self.task, self.variants, *_ = what

        def compute(self, take: Take, _cancel: object) -> None:
            told.append("a round")
            evaluate(self.task, self.variants, take, workers=1)

    monkeypatch.setattr("arcless.study.executors.dask._local", local)
    monkeypatch.setattr("arcless.study.executors.dask.Chunks", Chunks)
    run(search(design={"trials": 12}), tmp_path, executor=Execution(kind="dask"))
    assert told == ["started", *["a round"] * 3, "stopped"]
    assert rows(tmp_path / "table.parquet") == rows(found[1] / "table.parquet")[:12]


def test_a_front_of_two_objectives_under_a_constraint(tmp_path: Path) -> None:
    # Least force and least wear pull apart below the optimum; above it both get worse.
    design = {"trials": 24, "objectives": {"wear": "minimise", "mean": "minimise"},
              "constraints": [{"output": "mean", "at_least": 60}]}  # fmt: skip
    made = search(design=design)
    run(made, tmp_path)
    front = best(made, tmp_path)
    assert len(front) > 1
    wear = [row.outputs["wear"] for row in front]
    mean = [row.outputs["mean"] for row in front]
    assert wear == sorted(wear) and mean == sorted(mean, key=lambda force: -(force or 0.0))
    assert min(force for force in mean if force) >= 60


def row(number: int, status: str = "done", **outputs: float | None) -> Row:
    return Row(number, "", {}, status, outputs, "", 0.0, "")  # type: ignore[arg-type]


def test_best_by_hand() -> None:
    design = Optimise.model_validate(
        {"kind": "optimise", "trials": 9, "objectives": {"a": "minimise", "b": "maximise"},
         "constraints": [{"output": "c", "at_most": 1, "at_least": 0}]}
    )  # fmt: skip
    given = [
        row(1, a=1, b=1, c=0), row(2, a=2, b=2, c=1), row(3, a=2, b=1, c=0), row(4, a=0, b=9, c=2),
        row(5, a=1, b=1, c=0), row(6, a=None, b=5, c=0), row(7, "failed"), row(8, a=0, b=9, c=-1),
    ]  # fmt: skip
    assert [one.variant for one in design.best(given)] == [1, 2]


def test_values_that_are_words_or_counted(tmp_path: Path) -> None:
    variables = {
        "force": {"field": "pantographs.0.static_force", "values": [60, 90, 120]},
        "law": {"field": "contact.law", "values": ["rigid", "compliant"]},
    }
    run(search(variables=variables, design={"trials": 6, "sampler": "random"}), tmp_path)
    table = rows(tmp_path / "table.parquet")
    assert {row["status"] for row in table} == {"done"}
    assert {row["force"] for row in table} <= {60.0, 90.0, 120.0}


def test_variants_that_fail_do_not_end_the_search(tmp_path: Path) -> None:
    variables = {"force": {"field": "pantographs.0.static_force", "range": [-100, 100]}}
    done = run(search(variables=variables, design={"trials": 16}), tmp_path)
    assert done.counts["invalid"] > 0 and done.counts["done"] > 0


@pytest.mark.parametrize(
    ("design", "message"),
    [
        ({"objectives": {"waer": "minimise"}}, "did you mean wear"),
        ({"objectives": {}}, "objectives"),
        ({"objectives": {"wear": "least"}}, "minimise"),
        ({"constraints": [{"output": "mean"}]}, "at_most or at_least"),
        ({"constraints": [{"output": "men", "at_most": 1}]}, "did you mean mean"),
        ({"trials": 0}, "design.trials"),
        ({"sampler": "grid"}, "sampler"),
    ],
)
def test_refused(design: dict[str, Any], message: str) -> None:
    with pytest.raises(ModelError) as refused:
        search(design=design)
    assert message in str(refused.value)


def test_a_variant_is_known_once_the_search_has_come_to_it(found: tuple[Study, Path]) -> None:
    fresh = search()
    with pytest.raises(StudyError, match="not chosen yet"):
        variant(fresh, 5)
    place = StudyFolder(fresh, found[1])
    place.recall()
    assert [variant(fresh, row.variant).key for row in place.rows()] == [
        row.key for row in place.rows()
    ]


def test_failed_variants_are_not_computed_again(tmp_path: Path) -> None:
    made = search(design={"trials": 4})
    run(made, tmp_path)
    place = StudyFolder(made, tmp_path)
    one = next(place.rows())
    with place.open_journal() as journal:
        journal.append(replace(one, status="failed"))
    with pytest.raises(StudyError, match="optimisation does not"):
        run(made, tmp_path, resume=True, retry_failed=True)
