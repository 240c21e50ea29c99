"""A study as a whole: its table, rows of every kind, going on, and what is refused."""

from collections import Counter
from pathlib import Path
from typing import Any

import pytest

import arcless
from arcless.errors import OutputError, StudyError
from arcless.study import Execution, Progress, Study, StudyFolder, run, status
from arcless.study.evaluation import evaluate as evaluating
from arcless.study.evaluation.variants import variant
from tests.support.studies import OUTPUTS, QUICK, VARIABLES, filled, rows, study


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return the folder of the small study, computed in one go."""
    folder = tmp_path_factory.mktemp("whole") / "small"
    run(study(), folder)
    return folder


def stopped_after(count: int, made: Study, folder: Path, **options: Any) -> None:
    """Compute until so many rows are there, then press Ctrl-C."""
    seen: list[Progress] = []
    stop = lambda: len(seen) > count  # noqa: E731 - the first call is that of the start
    with pytest.raises(KeyboardInterrupt):
        run(made, folder, executor=Execution(workers=1), tell=seen.append, cancel=stop, **options)


def test_the_table(whole: Path) -> None:
    found = rows(whole / "table.parquet")
    assert [row["variant"] for row in found] == [1, 2, 3, 4, 5, 6]
    assert [row["tension"] for row in found] == [18e3] * 3 + [26e3] * 3
    assert Counter(row["status"] for row in found) == {"done": 4, "invalid": 2}
    for row in found:
        if row["status"] == "done":
            assert row["error"] == ""
            alone = arcless.run(study().base.with_(**variant(study(), row["variant"]).changes))
            force = alone.assessment.pantographs[0]
            assert row["sigma"] == force.std_force_N  # bit for bit what `arcless run` gives
            assert row["ratio"] == force.std_force_N / force.mean_force_N
        else:
            assert "pantographs.0.static_force: got -5.0, expected a force" in row["error"]
            assert row["sigma"] is None
        assert row["arcless_version"].startswith(arcless.__version__ + "+")


def test_columns_carry_their_units(whole: Path) -> None:
    import pyarrow.parquet

    schema = pyarrow.parquet.read_schema(whole / "table.parquet")
    units = {field.name: field.metadata[b"unit"].decode() for field in schema}
    assert units == {
        "variant": "", "tension": "N", "force": "N", "sigma": "N", "ratio": "",
        "status": "", "error": "", "wall_time_s": "s", "arcless_version": "",
    }  # fmt: skip


def test_workers_change_nothing(whole: Path, tmp_path: Path) -> None:
    run(study(), tmp_path, executor=Execution(workers=3))
    assert rows(tmp_path / "table.parquet") == rows(whole / "table.parquet")


@pytest.mark.parametrize("count", [1, 3])
def test_going_on_gives_the_same_table(whole: Path, tmp_path: Path, count: int) -> None:
    stopped_after(count, study(), tmp_path)
    there = rows(tmp_path / "table.parquet")
    assert count <= len(there) < 6
    done = run(study(), tmp_path, resume=True)
    assert done.computed == 6 - len(there)
    assert rows(tmp_path / "table.parquet") == rows(whole / "table.parquet")
    assert run(study(), tmp_path, resume=True).computed == 0


def test_beginning_twice_is_refused(whole: Path) -> None:
    with pytest.raises(StudyError, match=r"complete already: got all 6 variants.*study report"):
        run(study(), whole)


def test_beginning_what_was_begun_says_how_far_it_is(tmp_path: Path) -> None:
    stopped_after(3, study(), tmp_path)
    count = len(rows(tmp_path / "table.parquet"))
    with pytest.raises(StudyError) as caught:
        run(study(), tmp_path)
    assert f"was begun here already: got {count} of 6 variants" in str(caught.value)
    assert f"continue with `arcless study resume FILE --out {tmp_path}`" in str(caught.value)
    with pytest.raises(StudyError, match="another study was begun here"):
        run(study(outputs={"sigma": "max_force_N"}), tmp_path)


def test_going_on_with_nothing_is_refused(tmp_path: Path) -> None:
    with pytest.raises(StudyError, match="no study was begun here"):
        run(study(), tmp_path / "none", resume=True)
    assert not (tmp_path / "none").exists()


def test_another_study_is_refused_with_the_difference(whole: Path) -> None:
    forces = {**VARIABLES["force"], "values": [70, 95]}
    other = study(variables={**VARIABLES, "force": forces}, outputs={"sigma": "max_force_N"})
    with pytest.raises(StudyError) as caught:
        run(other, whole, resume=True)
    said = str(caught.value)
    assert 'variables.force.values.0: "70 N" → 70' in said
    assert 'variables.force.values.1: "90 N" → 95' in said
    assert 'variables.force.values.2: "-5 N" → absent' in said
    assert 'outputs.sigma.expression: "std_force_N" → "max_force_N"' in said
    with pytest.raises(StudyError, match="another one"):
        status(other, whole)


def test_words_and_executor_may_change(whole: Path) -> None:
    told = study(description="told anew", executor={"kind": "threads", "workers": 1})
    assert run(told, whole, resume=True).computed == 0


def test_a_failure_is_a_row_and_can_be_retried(
    whole: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def unreachable(scenario: Any) -> Any:
        forces = [placement.static_force for placement in scenario.pantographs]
        raise_it = forces == [90.0]
        placements = [
            {**scenario.to_dict()["pantographs"][0], "static_force": None, "mean_force": 90}
        ]
        # A mean force over one step of a record as short as this is never reached.
        return scenario.with_(pantographs=placements) if raise_it else scenario

    real = evaluating._Work.scenario
    with monkeypatch.context() as patch:
        patch.setattr(evaluating._Work, "scenario", lambda s, v: unreachable(real(s, v)))
        patch.setattr("arcless.simulate.runs.mean_force.MOST_RUNS", 1)
        run(study(), tmp_path)
    found = rows(tmp_path / "table.parquet")
    failed = [row for row in found if row["status"] == "failed"]
    assert [row["variant"] for row in failed] == [2, 5]
    assert all("the mean force of pantograph P1 was not reached" in row["error"] for row in failed)
    assert run(study(), tmp_path, resume=True).computed == 0
    assert run(study(), tmp_path, resume=True, retry_failed=True).computed == 2
    assert rows(tmp_path / "table.parquet") == rows(whole / "table.parquet")


def test_an_undefined_output_is_said(tmp_path: Path) -> None:
    made = study(outputs={**OUTPUTS, "odd": "1 / (force - 70)"}, design={"kind": "list"},
                 variables={"force": {**VARIABLES["force"], "values": [70, 80]}})  # fmt: skip
    run(made, tmp_path)
    one, other = rows(tmp_path / "table.parquet")
    assert (one["odd"], one["error"]) == (None, "odd: division by zero")
    assert (other["odd"], other["error"]) == (0.1, "")


def test_results_are_kept_when_asked(tmp_path: Path) -> None:
    made = study(keep="results")
    run(made, tmp_path)
    files = sorted(path.name for path in (tmp_path / "results").iterdir())
    assert files == ["0000001.nc", "0000002.nc", "0000004.nc", "0000005.nc"]
    sigma = rows(tmp_path / "table.parquet")[4]["sigma"]
    kept = arcless.open(tmp_path / "results" / "0000005.nc")
    assert kept.assessment.pantographs[0].std_force_N == sigma


def test_another_version_is_said_and_stands_in_the_rows(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    with monkeypatch.context() as patch:
        patch.setattr(evaluating, "code_version", lambda: "0.0.9+old")
        patch.setattr("arcless.study.folder.folder.code_version", lambda: "0.0.9+old")
        patch.setattr("arcless.study.folder.row_writer.code_version", lambda: "0.0.9+old")
        stopped_after(2, study(), tmp_path)
    told: list[str] = []
    run(study(), tmp_path, resume=True, note=told.append)
    assert len(told) == 1
    assert "begun with version 0.0.9+old" in told[0]
    versions = Counter(row["arcless_version"] for row in rows(tmp_path / "table.parquet"))
    assert len(versions) == 2
    assert versions["0.0.9+old"] >= 2
    assert dict(versions) == status(study(), tmp_path).versions


def test_one_process_at_a_time(tmp_path: Path) -> None:
    stopped_after(1, study(), tmp_path)
    with StudyFolder(study(), tmp_path).open_journal():
        assert status(study(), tmp_path).running
        with pytest.raises(StudyError, match="being computed already"):
            run(study(), tmp_path, resume=True)
    assert not status(study(), tmp_path).running


def test_rows_of_another_study_are_refused(tmp_path: Path) -> None:
    filled(tmp_path / "other", outputs={"sigma": "max_force_N"})
    stopped_after(1, study(), tmp_path / "own")
    before = (tmp_path / "other" / "journal.db").read_bytes()
    (tmp_path / "own" / "journal.db").write_bytes(before)
    with pytest.raises(StudyError, match="rows are of another study"):
        run(study(), tmp_path / "own", resume=True)
    assert (tmp_path / "own" / "journal.db").read_bytes() == before


def test_one_that_never_had_a_row_may_begin_as_another(tmp_path: Path) -> None:
    filled(tmp_path, of=0, outputs={"sigma": "max_force_N"})
    assert run(study(), tmp_path).computed == 6


def test_status_counts_and_names_the_reasons(tmp_path: Path) -> None:
    stopped_after(3, study(), tmp_path)
    found = status(study(), tmp_path)
    assert found.done + found.invalid + found.missing == found.total == 6
    assert found.missing > 0
    assert list(found.errors.values()) == [found.invalid]


def test_a_missing_package_is_one_sentence(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("importlib.util.find_spec", lambda _name: None)
    with pytest.raises(StudyError, match=r"pyarrow, which is not installed; hint: pip install"):
        run(study(), tmp_path / "new")
    assert not (tmp_path / "new").exists()


def test_a_folder_that_cannot_be_made(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(OutputError, match="the folder of the study cannot be made"):
        run(study(), tmp_path / "file" / "below")


def test_the_folder_has_the_name_of_the_study() -> None:
    assert StudyFolder(study(name="a b/c")).path == Path("runs/studies/a-b-c")


def test_the_table_is_written_part_by_part(whole: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    before = rows(whole / "table.parquet")
    for part in (1, 2, 6):
        monkeypatch.setattr("arcless.study.folder.table.PART", part)
        run(study(), whole, resume=True)
        assert rows(whole / "table.parquet") == before


def test_a_variant_too_close_to_tell_leaves_its_criterion_out(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A limit is put onto what the variant with 100 N has: the others are far from it."""
    from arcless.assess import criteria
    from arcless.assess.rules import Limit, Rule

    spans = [{"type": "span", "count": 7}]
    room = {"travel": {"start": 60, "end": 310}, "analysis": {"from": 160, "to": 290}}
    forces = {"force": {"field": "pantographs.0.static_force", "values": [60, 100, 140]}}
    made = study(
        set={
            **QUICK,
            **room,
            "line.spans": spans,
            "certainty": {"starts": 2, "other_family": False},
        },
        variables=forces,
        outputs={"met": "criteria.statistical_max", "all": "passed", "mean": "mean_force_N"},
    )
    middle = made.base.with_(**{"pantographs.0.static_force": 100.0})
    [own] = arcless.run(middle).assessment.pantographs
    rule = Rule(
        name="statistical_max", title="statistical maximum", unit="N",
        quantity="statistical_max_N", relation="<=", mark="A", source="this test",
        limit=Limit(constant=own.statistical_max_N + 1e-6),
    )  # fmt: skip
    monkeypatch.setattr(criteria, "RULES", (rule,))
    run(made, tmp_path / "study")
    found = rows(tmp_path / "study" / "table.parquet")
    assert [row["status"] for row in found] == ["done"] * 3
    assert [row["met"] for row in found] == [1.0, None, 0.0]
    assert [row["all"] for row in found] == [1.0, None, 0.0]
    assert [row["mean"] is None for row in found] == [False] * 3
    assert found[0]["error"] == found[2]["error"] == ""
    assert "met: criteria.statistical_max is too close to tell" in found[1]["error"]
    assert "all: too close to tell: statistical_max" in found[1]["error"]
