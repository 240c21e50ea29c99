"""Rows as the page reads them, variants as scenarios, and studies that are computed."""

import asyncio
import math
import time
from pathlib import Path
from typing import Any

import pytest

import arcless
from arcless import ModelError, StudyError, study
from arcless.assess import NOT_JUDGED
from arcless.assess.quantities import label_of
from arcless.model.files.yaml_reader import parse
from arcless.studio.answers.answers import Refused
from arcless.studio.project.project import Project
from arcless.studio.project.texts import version_of
from arcless.studio.studies.computing import Computing
from arcless.studio.studies.desk import Desk
from arcless.studio.studies.verdicts import RowVerdicts
from arcless.study.evaluation.variants import scenario
from arcless.study.journal.row import Row
from arcless.study.report.data.judge import judge
from arcless.study.report.data.judged import VERDICTS
from arcless.study.report.data.record import Record

FILE, FOLDER = "force.yaml", "runs/studies/force"
# Seconds for what takes one; longer, a failing test takes as long to say so.
PATIENCE = 60.0
TEXT = """format: arcless-study/1
name: force
scenario: own.yaml
set:
  line.spans: [{type: standard, count: 5}]
  travel: {start: 60 m, end: 180 m}
  analysis: {from: 100 m, to: 170 m}
variables:
  force: {field: pantographs.0.static_force, values: [100 N, 130 N, 160 N, -1 N]}
  tension: {field: line.contact_wire.tension, range: [20 kN, 24 kN], count: 2}
design: {kind: grid}
outputs: {sigma: std_force_N}
"""
SCENARIO = """format: arcless-scenario/1
name: own
base: en50318-ac-simple-275-planar
set: {speed: 200 km/h}
"""


@pytest.fixture
def project(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Project:
    (tmp_path / FILE).write_text(TEXT)
    (tmp_path / "own.yaml").write_text(SCENARIO)
    monkeypatch.chdir(tmp_path)  # the usual folder of a study is below the current one
    return Project.of(tmp_path)


@pytest.fixture
def desk(project: Project) -> Desk:
    return Desk(project, Computing())


def test_rows_come_after_a_number_as_they_are_in_the_journal(desk: Desk) -> None:
    loaded = study.load(FILE)
    study.run(loaded)
    first = desk.rows(FOLDER, 0, "", 5)
    rest = desk.rows(FOLDER, first["next"], first["edition"], 100)
    assert [len(first["rows"]), len(rest["rows"])] == [5, 3]
    found = {row[0]: row for row in [*first["rows"], *rest["rows"]]}
    place = study.open(FILE)
    for row in place.rows():
        assert found[row.variant] == [
            row.variant, row.status, row.values["force"], row.values["tension"],
            row.outputs.get("sigma"), *found[row.variant][5:7], row.error, row.wall_time_s,
        ]  # fmt: skip
    assert rest["counts"] == {"done": 6, "invalid": 2}
    assert (rest["there"], rest["total"], rest["running"]) == (8, 8, False)


def test_rows_that_come_later_are_found_though_their_numbers_are_lower(desk: Desk) -> None:
    loaded = study.load(FILE)
    place = study.StudyFolder(loaded)
    with place.open_journal() as journal:
        place.write_state(journal.mode)
        for number in (5, 3):
            journal.append(_row(number))
        first = desk.rows(FOLDER, 0, "", 100)
        for number in (4, 1):
            journal.append(_row(number))
        second = desk.rows(FOLDER, first["next"], first["edition"], 100)
        assert second["running"]
    assert [row[0] for row in first["rows"]] == [3, 5]
    assert [row[0] for row in second["rows"]] == [1, 4]


def _row(number: int) -> Row:
    values = {"force": 1.0, "tension": 2.0}
    return Row(number, str(number), values, "done", {"sigma": 3.0}, "", 0.1, "0")


def test_rows_are_judged_as_the_report_of_the_study_judges_them(desk: Desk) -> None:
    text = TEXT.replace("{sigma: std_force_N}", "{sigma: std_force_N, mean: mean_force_N}")
    text = text.replace("130 N", "60 N").replace("160 N", "250 N")  # too low, too high
    (Path.cwd() / FILE).write_text(text)
    study.run(study.load(FILE))
    first = desk.rows(FOLDER, 0, "", 3)
    rest = desk.rows(FOLDER, first["next"], first["edition"], 100)
    place = study.open(FILE)
    record = Record(place.study, place.path)
    wanted = judge(record)
    rows = {row[0]: row for row in [*first["rows"], *rest["rows"]]}
    assert len({row[6] for row in rows.values()}) > 2
    titles = [one["title"] for one in rest["criteria"]]
    assert titles == [one.title for one in wanted.items]
    for at, row in enumerate(record.done):
        *_, verdict, judged, _error, _time = rows[row.variant]
        assert verdict == VERDICTS[wanted.codes[at]]
        told = {titles[number]: (word, limit) for number, word, limit in judged}
        for item in wanted.items:
            word, limit = VERDICTS[item.codes[at]], float(item.limits[at])
            assert told.get(item.title, (NOT_JUDGED, limit)) == (word, limit) or math.isnan(limit)
    assert {row[5 + 1] for row in rows.values() if row[1] == "invalid"} == {NOT_JUDGED}
    # The limit of σ goes with the mean force of the row: 0.3 F_m.
    sigma = titles.index(label_of("std_force_N"))
    assert [dict((n, limit) for n, _, limit in rows[1][7])[sigma]] == pytest.approx(
        [0.3 * rows[1][5]]
    )
    assert rest["not_judged"] == list(wanted.unknown)


def test_rows_that_come_one_by_one_are_judged_as_all_at_once(desk: Desk) -> None:
    study.run(study.load(FILE))
    done = [row for row in study.open(FILE).rows() if row.status == "done"]
    whole, single = RowVerdicts(study.load(FILE)), RowVerdicts(study.load(FILE))
    together = whole.of(done)
    apart = {number: one for row in done for number, one in single.of([row]).items()}
    assert apart == together
    assert single.criteria == whole.criteria
    assert whole.of([]) == {}


@pytest.mark.parametrize(
    ("change", "begun"),
    [(("", ""), "same"), (("100 N", "110 N"), "other"), (("name: force", "name: new"), None)],
)
def test_a_name_that_is_taken_is_told_before_anything_is_written(
    desk: Desk, project: Project, change: tuple[str, str], begun: str | None
) -> None:
    assert desk.text(FILE, _given(TEXT))["begun"] is None
    study.run(study.load(FILE))
    given = _given(TEXT.replace(*change))
    told = desk.text(FILE, given)
    assert (told["begun"], told["changes"]) == (begun, begun != "same")
    assert told["version"] == version_of(TEXT.encode())
    free = desk.text("free.yaml", given)
    assert (free["changes"], free["version"]) == (False, None)
    assert (project.folder / FILE).read_text() == TEXT


def test_a_study_does_not_take_the_file_of_another_model(desk: Desk) -> None:
    told = desk.text("own.yaml", _given(TEXT))
    assert told["errors"][0]["field"] == ("name",)
    assert told["count"] is None


def _given(text: str) -> dict[str, Any]:
    data, _ = parse(text, FILE)
    return {key: value for key, value in data.items() if key != "format"}


def test_an_error_has_the_place_of_its_field(desk: Desk) -> None:
    given = _given(TEXT.replace("20 kN, 24 kN", "20 kN, 24 bananas"))
    (error,) = desk.text(FILE, given)["errors"]
    assert error["field"][:2] == ("variables", "tension")


def test_another_edition_is_read_from_the_start(desk: Desk) -> None:
    study.run(study.load(FILE))
    answer = desk.rows(FOLDER, 7, "of another server", 100)
    assert len(answer["rows"]) == 8


def test_the_definition_names_columns_and_units(desk: Desk) -> None:
    study.run(study.load(FILE))
    about = desk.about(FOLDER)
    assert [(one["name"], one["unit"], one["scale"]) for one in about["variables"]] == [
        ("force", "N", 1.0), ("tension", "kN", 1000.0),
    ]  # fmt: skip
    assert [(one["name"], one["unit"]) for one in about["outputs"]] == [("sigma", "N")]
    # Words are those of the vocabulary, and of the list of fields.
    assert [one["label"] for one in about["outputs"]] == [label_of("std_force_N")]
    assert about["outputs"][0]["decimals"] == 1
    assert [one["label"] for one in about["variables"]] == [
        "Pantograph 1: static force", "Line contact wire: tension",
    ]  # fmt: skip
    assert about["count"] == 8


@pytest.mark.parametrize("number", [1, 6])
def test_a_variant_becomes_the_scenario_that_was_computed(
    desk: Desk, project: Project, number: int
) -> None:
    loaded = study.load(FILE)
    study.run(loaded)
    path = desk.scenario(FOLDER, number, f"variant-{number}")["path"]
    text = (project.folder / path).read_text()
    assert "base: own.yaml" in text
    assert "line.contact_wire.tension: 2" in text
    made, wanted = arcless.load(path), scenario(loaded, number)
    assert made.speed == pytest.approx(200.0 / 3.6)
    for field in ("line", "pantographs", "travel", "analysis", "speed", "solver"):
        assert _numbers(made.to_dict()[field]) == _numbers(wanted.to_dict()[field]), field
    # Opened once more it is the same file; another text of that name is not written over.
    assert desk.scenario(FOLDER, number, f"variant-{number}")["path"] == path
    (project.folder / path).write_text(text + "description: mine\n")
    with pytest.raises(Refused):
        desk.scenario(FOLDER, number, f"variant-{number}")
    assert (project.folder / path).read_text().endswith("mine\n")


def _numbers(data: Any) -> Any:
    if isinstance(data, dict):
        return {key: _numbers(value) for key, value in data.items() if key != "provenance"}
    return [_numbers(one) for one in data] if isinstance(data, list) else data


def test_a_variant_of_a_scenario_that_was_changed_since_is_refused(
    desk: Desk, project: Project
) -> None:
    study.run(study.load(FILE))
    (project.folder / "own.yaml").write_text(SCENARIO.replace("200", "210"))
    with pytest.raises(ModelError, match="changed since"):
        desk.scenario(FOLDER, 1, "variant-1")
    assert not (project.folder / "variant-1.yaml").exists()


def test_a_study_is_computed_stopped_and_gone_on_with(project: Project) -> None:
    text = TEXT.replace("count: 2", "count: 400")
    (project.folder / FILE).write_text(text)
    computing = Computing()
    desk = Desk(project, computing)
    desk.run(FILE, resume=False, retry_failed=False)
    with pytest.raises(StudyError, match="already"):
        desk.run(FILE, resume=True, retry_failed=False)
    _until(lambda: desk.rows(FOLDER, 0, "", 1)["there"] > 0)
    desk.stop(FOLDER)
    _until(lambda: not computing.is_running(project.folder / FOLDER))
    stopped = desk.rows(FOLDER, 0, "", 1)
    assert 0 < stopped["there"] < stopped["total"]
    assert stopped["error"] is None  # it was asked to
    with pytest.raises(StudyError, match="begun already"):
        desk.run(FILE, resume=False, retry_failed=False)
    desk.run(FILE, resume=True, retry_failed=False)
    _until(lambda: desk.rows(FOLDER, 0, "", 1)["there"] > stopped["there"])
    desk.stop(FOLDER)
    _until(lambda: not computing.is_running(project.folder / FOLDER))


def test_a_study_ends_with_the_server_and_keeps_its_rows(project: Project) -> None:
    (project.folder / FILE).write_text(TEXT.replace("count: 2", "count: 400"))
    computing = Computing()
    desk = Desk(project, computing)

    async def serve() -> None:
        async with computing.at_work():
            desk.run(FILE, resume=False, retry_failed=False)
            _until(lambda: desk.rows(FOLDER, 0, "", 1)["there"] > 0)

    asyncio.run(serve())
    _until(lambda: not computing.is_running(project.folder / FOLDER))
    found = desk.rows(FOLDER, 0, "", 1)
    assert 0 < found["there"] < found["total"]
    assert found["error"] is None


def test_what_ends_a_study_is_told(project: Project) -> None:
    computing = Computing()
    folder = project.folder / "runs" / "x"
    computing.start(project.folder / "missing.yaml", folder, project.folder)
    _until(lambda: not computing.is_running(folder))
    assert "missing.yaml" in str(computing.error(folder))


def test_a_study_without_a_value_says_so(desk: Desk, project: Project) -> None:
    (project.folder / FILE).write_text(TEXT.replace("100 N, 130 N, 160 N, ", ""))
    desk.run(FILE, resume=False, retry_failed=False)
    _until(lambda: not desk.rows(FOLDER, 0, "", 1)["own"])
    found = desk.rows(FOLDER, 0, "", 100)
    assert found["counts"] == {"invalid": 2}
    assert "no variant has a value" in found["error"]


def _until(ready: Any) -> None:
    end = time.monotonic() + PATIENCE
    while not ready():
        assert time.monotonic() < end
        time.sleep(0.05)
