"""Pruning: what a run is compared with, where it stops, and that nothing else depends on it."""

from collections import Counter
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from arcless.errors import ModelError
from arcless.study import Execution, Optimise, Progress, Study, StudyFolder, run, status
from arcless.study.evaluation.evaluate import Task, evaluate
from arcless.study.evaluation.run_monitor import RunMonitor
from arcless.study.evaluation.variants import scenario, variants
from arcless.study.journal.row import Row
from arcless.study.optimisation.constraints import Constraint
from arcless.study.optimisation.pruning import (
    Monitoring,
    OutOfReach,
    Percentile,
    Saving,
    comparisons,
)
from arcless.study.report import html
from tests.support.studies import QUICK, rows, study
from tests.support.wear import wear_data

FORCE = {"force": {"field": "pantographs.0.static_force", "range": ["40 N", "200 N"]}}
# The core hands its record on every 256 steps: six times in runs of 1600.
FINE = {**QUICK, "solver.time_step": "1 ms", "wear": wear_data(mechanical__force_exponent=1.0)}
TRIALS = 20


def search(**design: Any) -> Study:
    """Return a search for the least wear, or what the design says."""
    plain = {"kind": "optimise", "trials": TRIALS, "objectives": {"wear": "minimise"}}
    outputs = {
        "wear": "wear_total_mm3_km",
        "mean": "mean_force_N",
        "peak": "unfiltered_max_force_N",
    }
    return study(set=FINE, variables=FORCE, outputs=outputs, design=plain | design)


REACH = {"pruning": {"kind": "out-of-reach", "after": 4}}
MEDIAN = {"pruning": {"kind": "percentile", "after": 4}}
HARD = {"constraints": [{"output": "peak", "at_most": 180, "hard": True}]}


@pytest.fixture(scope="module")
def pruned(tmp_path_factory: pytest.TempPathFactory) -> tuple[Study, Path]:
    """Return a search whose runs may be stopped, with its folder."""
    folder = tmp_path_factory.mktemp("pruned")
    made = search(**REACH)
    run(made, folder)
    return made, folder


def kept(folder: Path, made: Study) -> list[Row]:
    return list(StudyFolder(made, folder).rows())


def test_a_pruned_row_says_where_and_why(pruned: tuple[Study, Path]) -> None:
    made, folder = pruned
    found = kept(folder, made)
    counts = Counter(row.status for row in found)
    assert counts["pruned"] > 2 and counts["done"] >= 4
    assert counts["pruned"] + counts["done"] == TRIALS
    for row in found:
        looks = row.so_far["wear"]
        if row.status == "pruned":
            assert row.outputs == {}
            assert 0 < row.steps < row.steps_of_run
            assert row.stopped_after_s == pytest.approx(1e-3 * row.steps)
            assert row.stopped_at_m is not None and 50.0 < row.stopped_at_m < 120.0
            assert f"wear so far {looks[-1]:.6g}; the best has" in row.error
            assert f"({'at'} {row.stopped_at_m:.6g} m, {row.stopped_after_s:.6g} s)" in row.error
        else:
            assert row.steps == row.steps_of_run and len(looks) == 9
            assert row.stopped_at_m is None


def test_the_table_has_it(pruned: tuple[Study, Path]) -> None:
    found = rows(pruned[1] / "table.parquet")
    for row in found:
        assert (row["wear"] is None) == (row["status"] == "pruned") == (row["error"] != "")
        assert (row["pruned_at_m"] is None) == (row["status"] == "done")
        assert row["steps_taken"] > 0
        assert dict(row["so_far"])["wear"]


def test_pruned_variants_are_never_the_best(pruned: tuple[Study, Path]) -> None:
    made, folder = pruned
    assert isinstance(made.design, Optimise)
    (best,) = made.design.best(kept(folder, made))
    assert best.status == "done"


@pytest.mark.parametrize("stop", [7, 13])
@pytest.mark.parametrize("workers", [1, 3])
def test_cut_off_and_resumed_it_is_the_same_table(
    pruned: tuple[Study, Path], tmp_path: Path, stop: int, workers: int
) -> None:
    seen: list[Progress] = []
    how = Execution(workers=workers)
    with pytest.raises(KeyboardInterrupt):
        run(search(**REACH), tmp_path, executor=how, tell=seen.append,
            cancel=lambda: len(seen) > stop)  # fmt: skip
    assert 0 < run(search(**REACH), tmp_path, resume=True).computed < TRIALS
    assert rows(tmp_path / "table.parquet") == rows(pruned[1] / "table.parquet")


def test_what_is_not_stopped_has_the_bits_of_a_run_alone(pruned: tuple[Study, Path]) -> None:
    import arcless

    made, folder = pruned
    done = [row for row in kept(folder, made) if row.status == "done"]
    for row in (done[0], done[-1]):
        force = arcless.run(scenario(made, row.variant)).assessment.pantographs[0]
        assert row.outputs["wear"] == force.wear_total_mm3_km
        assert row.outputs["mean"] == force.mean_force_N


def test_status_and_report_tell_what_was_saved(pruned: tuple[Study, Path]) -> None:
    made, folder = pruned
    found = status(made, folder)
    known = kept(folder, made)
    saved = sum(row.steps_of_run - row.steps for row in known)
    assert (found.steps_saved, found.steps_taken) == (saved, sum(row.steps for row in known))
    assert found.pruned > 0 and found.errors == {}
    page = html(made, folder)
    assert "Stopped early" in page and "steps saved by pruning" in page
    assert f"{found.done} of {TRIALS} variants computed, {found.pruned} pruned" in page


# Twenty periods of 60 Hz, a third of a second, fit into the section.
FAST = {"analysis": {**QUICK["analysis"], "low_pass": 60}}


@pytest.mark.parametrize(
    ("key", "bound", "forces", "settings"),
    [
        ("unfiltered_max_force_N", {"at_most": 180}, [80, 200], {}),
        ("max_force_N", {"at_most": 180}, [80, 250], FAST),
        ("min_force_N", {"at_least": 30}, [30, 120], FAST),
        ("contact_loss_percent", {"at_most": 0.01}, [20, 80], {}),
    ],
)
def test_a_hard_constraint_is_sound(
    key: str, bound: dict[str, Any], forces: list[float], settings: dict[str, Any]
) -> None:
    import arcless

    made = study(
        set={**FINE, **settings},
        variables={"force": {"field": "pantographs.0.static_force", "values": forces}},
        outputs={"looked": key},
    )
    limit = Constraint(output="looked", hard=True, **bound)
    task = replace(Task.of(made, None), watch=Monitoring(10, ("looked",), (), (limit,)))
    found: list[Row] = []
    evaluate(task, variants(made, [1, 2]), found.append)
    good, broken = sorted(found, key=lambda row: row.status)
    assert (good.status, broken.status) == ("done", "pruned")
    whole = arcless.run(scenario(made, broken.variant)).assessment.pantographs[0]
    known = limit.excess(broken.so_far["looked"][-1] or 0.0)
    assert limit.excess(getattr(whole, key)) >= known > 0.0
    assert "is allowed: it can only get worse" in broken.error


def test_several_objectives_know_hard_constraints_only(tmp_path: Path) -> None:
    two = {"objectives": {"wear": "minimise", "mean": "minimise"}}
    made = search(trials=8, sampler="random", **two, **HARD)
    done = run(made, tmp_path)
    assert done.counts["pruned"] > 0
    with pytest.raises(ModelError, match="pruning compares one objective"):
        search(**two, **REACH)


def row(number: int, so_far: list[float], end: float | None, mean: float = 0.0) -> Row:
    outputs = {} if end is None else {"wear": end, "mean": mean}
    state: Any = "pruned" if end is None else "done"
    return Row(number, "", {}, state, outputs, "", 0.0, "", {"wear": so_far})


ROWS = [row(1, [9, 8], 7), row(2, [5, 6], 5), row(3, [7, 4], 6, mean=-1), row(4, [1], None)]


def feasible(one: Row) -> bool:
    return (one.outputs.get("mean") or 0.0) >= 0.0


@pytest.mark.parametrize(("sign", "bars"), [(1.0, [5 + 2, 5 + 1]), (-1.0, [-7 + 0, -7 + 2])])
def test_out_of_reach_by_hand(sign: float, bars: list[float]) -> None:
    rule = OutOfReach(kind="out-of-reach", after=3, looks=3)
    (test,) = comparisons(rule, ("wear", sign), (), ROWS, feasible)
    assert [bar.limit for bar in test.bars] == bars
    (none,) = comparisons(rule, ("wear", sign), (), ROWS[:2], feasible)
    assert [bar.limit for bar in none.bars] == [float("inf")] * 2


def test_percentile_is_that_of_optuna() -> None:
    import numpy as np
    import optuna

    random = np.random.default_rng(5)
    values = random.random((12, 5))
    known = [row(i + 1, list(map(float, v[:4])), float(v[4])) for i, v in enumerate(values)]
    rule = Percentile(kind="percentile", percentile=40, after=6, looks=5)
    (test,) = comparisons(rule, ("wear", -1.0), (), known, feasible)
    made = optuna.create_study(direction="maximize")
    for one in known:
        steps = dict(enumerate(one.so_far["wear"]))
        made.add_trial(optuna.trial.create_trial(value=one.outputs["wear"],
                                                 intermediate_values=steps))  # fmt: skip
    theirs = optuna.pruners.PercentilePruner(40.0, n_startup_trials=6)
    watch = Monitoring(5, ("wear",), (test,), ())
    for so_far in random.random((40, 4)):
        trial = made.ask()
        watcher = RunMonitor(watch, {}, {}, searches=False)
        for step, value in enumerate(map(float, so_far)):
            trial.report(value, step)
            watcher.so_far["wear"].append(value)
            frozen = made.get_trials(deepcopy=False)[trial.number]
            assert (watcher._behind(test) is not None) == theirs.prune(made, frozen)
        made.tell(trial, state=optuna.trial.TrialState.FAIL)


def test_saving_counts_the_runs_of_a_search() -> None:
    made = [row(1, [1], 1), row(2, [1], 1), row(3, [1], None)]
    taken = [(200, 100), (300, 100), (40, 100)]
    known = [Row(**(one.to_dict() | {"steps": s, "steps_of_run": n}))
             for one, (s, n) in zip(made, taken, strict=True)]  # fmt: skip
    # Two and a half runs a variant: 250 steps, of which 40 were taken.
    assert Saving.of(known) == Saving(540, 210.0)
    assert Saving.of(known).percent == pytest.approx(28.0)
    assert Saving.of([]).percent == 0.0


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"pruning": {"kind": "median"}}, "percentile"),
        ({"pruning": {"kind": "percentile", "percentile": 100}}, "design.pruning"),
        ({"pruning": {"kind": "out-of-reach", "looks": 1}}, "looks"),
        ({"constraints": [{"output": "mean", "at_most": 9, "hard": True}]}, "may still get better"),
        (
            {"constraints": [{"output": "peak", "at_least": 9, "hard": True}]},
            "may still get better",
        ),
    ],
)
def test_refused(changes: dict[str, Any], message: str) -> None:
    with pytest.raises(ModelError) as refused:
        search(**changes)
    assert message in str(refused.value)


def test_a_hard_constraint_needs_a_force_that_is_given() -> None:
    at = {"pantographs.0.mean_force": "90 N", "pantographs.0.static_force": None}
    hard = {"kind": "optimise", "trials": 2, "objectives": {"mean": "minimise"}, **HARD}
    given: dict[str, Any] = {
        "outputs": {"peak": "max_force_N", "mean": "mean_force_N"}, "design": hard,
    }  # fmt: skip
    tension = {"t": {"field": "line.contact_wire.tension", "range": ["20 kN", "21 kN"]}}
    with pytest.raises(ModelError, match="in a search for a mean force"):
        study(set=QUICK | at, variables=tension, **given)
    study(set=QUICK | {"pantographs.0.mean_force": "90 N"}, variables=FORCE, **given)
