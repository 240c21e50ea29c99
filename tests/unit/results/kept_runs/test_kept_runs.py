"""Runs below a folder: their verdicts and numbers, and files that are none."""

import json
import os
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import arcless
from arcless.dataset.netcdf import lazy_reader
from arcless.dataset.schema import ATTRIBUTES
from arcless.errors import ResultFormatError
from arcless.model import load
from arcless.results import KeptRun, Result
from arcless.results.kept_runs import reading
from arcless.results.kept_runs.places import run_file
from arcless.results.kept_runs.reading import WRITTEN_TOGETHER_S
from tests.support.synthetic import scenario_data, synthetic_dataset

SHAKEN = {"amplitude": 60.0}  # σ = 42 N of a mean of 100 N: more than the 0.3 F_m of EN 50367
NOW = {"arcless_version": arcless.__version__}


def saved(folder: Path, amplitude: float = 5.0, **more: Any) -> Result:
    """Save a drawn run, a sine about 100 N, with its assessment."""
    data = more.pop("scenario", scenario_data())
    attrs = {**NOW, **more.pop("attrs", {})}
    force = more.pop("force", lambda t: 100.0 + amplitude * np.sin(2.0 * np.pi * t))
    dataset = synthetic_dataset(force=force, scenario=data, attrs=attrs, **more)
    result = Result(dataset, load(data))
    folder.mkdir(parents=True, exist_ok=True)
    result.save(folder / "result.nc")
    if result.is_complete:
        (folder / "assessment.json").write_text(result.assessment.to_json(), "utf-8")
    return result


def only(folder: Path) -> KeptRun:
    (found,) = arcless.runs(folder)
    return found


def test_no_variable_of_a_run_with_its_assessment_is_opened(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    saved(tmp_path / "one")
    known = only(tmp_path)
    monkeypatch.setattr(lazy_reader, "split", None)
    assert known.verdict == "met"
    assert only(tmp_path) == known
    (tmp_path / "one" / "assessment.json").unlink()
    assert only(tmp_path).verdict == "unreadable"  # it is assessed, and cannot be


@pytest.fixture
def never(monkeypatch: pytest.MonkeyPatch) -> None:
    """Fail where a run is assessed."""

    def fault(*_arguments: object, **_options: object) -> None:
        raise AssertionError("it was assessed")

    monkeypatch.setattr(reading, "assess", fault)


def test_numbers_are_those_of_the_assessment(tmp_path: Path) -> None:
    assessment = saved(tmp_path / "one").assessment
    (tmp_path / "one" / "assessment.json").unlink()
    found = only(tmp_path)
    assert (found.path, found.name) == (tmp_path / "one", "synthetic")
    assert found.verdict == ("met" if assessment.passed else "not met") == "met"
    (own,), (pantograph,) = found.pantographs, assessment.pantographs
    for key in ("name", "mean_force_N", "std_force_N", "max_force_N", "min_force_N", "NQ_percent"):
        assert getattr(own, key) == getattr(pantograph, key), key
    assert found.max_uplift_at_support_mm == assessment.max_uplift_at_support_mm
    assert found.speed_m_s == assessment.speed_m_s
    assert found.worst is own


def test_lines_of_one_name_are_told_apart_by_what_they_say(tmp_path: Path) -> None:
    data = scenario_data()
    stiffer = json.loads(json.dumps(data))
    stiffer["line"]["contact_wire"]["tension"] *= 1.1
    told = json.loads(json.dumps(data))
    told["line"]["description"] = "the same line in other words"
    for name, one in (("a", data), ("b", stiffer), ("c", told)):
        saved(tmp_path / name, scenario=one)
    found = {one.path.name: one for one in arcless.runs(tmp_path)}
    assert {one.line for one in found.values()} == {data["line"]["name"]}
    assert found["a"].line_digest == found["c"].line_digest != found["b"].line_digest


def test_a_criterion_that_is_not_met_is_named(tmp_path: Path) -> None:
    assessment = saved(tmp_path, **SHAKEN).assessment
    found = only(tmp_path)
    assert found.verdict == "not met"
    assert found.reason is not None
    missed = [one.title for one in assessment.criteria if one.fails]
    assert missed and found.reason.startswith(", ".join(missed))


def test_a_limit_that_does_not_decide_is_told_and_does_not(tmp_path: Path) -> None:
    # Contact is lost for 2 % of the time, 20 ms each: more than the 0.1 % of a limit of mark C.
    result = saved(tmp_path, force=lambda t: np.where(t % 1.0 < 0.02, 0.0, 100.0))
    (loss,) = [one for one in result.assessment.criteria if one.name == "contact_loss"]
    assert loss.passed is False and not loss.fails
    found = only(tmp_path)
    assert found.verdict == "met"
    assert found.reason is not None
    assert found.reason.startswith("beyond a limit that is not verified: ")
    assert loss.title in found.reason


def test_without_a_limit_that_decides_nothing_is_met(tmp_path: Path) -> None:
    criteria = saved(tmp_path).assessment.to_dict()["criteria"]
    assert reading.judged(criteria)[0] == "met"
    for one in criteria:
        one["mark"] = "C"
    assert reading.judged(criteria)[0] == "not judged"
    for one in criteria:
        one.update(mark="A", passed=None, reason="too close to tell: 0.1 N")
    assert reading.judged(criteria)[0] == "met"  # as `Assessment.passed` has it


def test_a_run_whose_deviation_is_not_judged_is_not_met(tmp_path: Path) -> None:
    saved(tmp_path, section=(200.0, 280.0))  # spans of 50 m: fewer than two
    found = only(tmp_path)
    assert found.verdict == "not judged"
    assert found.reason is not None
    assert "not judged: standard deviation σ, statistical maximum" in found.reason
    # What is not judged for want of a value or of a limit is not told: it could not be compared.
    assert "lateral" not in found.reason
    assert "uplift" not in found.reason


def test_of_several_pantographs_the_worst_leads(tmp_path: Path) -> None:
    saved(tmp_path, pantographs=("P1", "P2"))
    file = tmp_path / "assessment.json"
    kept = json.loads(file.read_text("utf-8"))
    kept["pantographs"][1]["std_force_N"] += 1.0  # as the kept assessment is the one that is read
    file.write_text(json.dumps(kept), "utf-8")
    found = only(tmp_path)
    assert [one.name for one in found.pantographs] == ["P1", "P2"]
    assert found.worst is not None and found.worst.name == "P2"
    assert found.to_dict()["worst"] == "P2"
    assert json.loads(json.dumps(found.to_dict())) == found.to_dict()


def test_the_kept_assessment_saves_computing(tmp_path: Path, never: None) -> None:
    saved(tmp_path)
    assert only(tmp_path).verdict == "met"


STALE = {
    "of another run": lambda kept: kept | {"wall_time_s": kept["wall_time_s"] + 1e-9},
    "of another section": lambda kept: kept | {"section_m": [200.0, 300.0]},
    "of another filter": lambda kept: kept | {"low_pass_Hz": 10.0},
    "of another scenario": lambda kept: kept | {"scenario": "other"},
    "without a key": lambda kept: {key: kept[key] for key in kept if key != "steps"},
    "without its numbers": lambda kept: kept | {"pantographs": [{}]},
    "no mapping": lambda kept: [kept],
}


@pytest.mark.parametrize("change", STALE)
def test_an_assessment_of_another_is_not_believed(tmp_path: Path, change: str) -> None:
    sigma = saved(tmp_path).assessment.pantographs[0].std_force_N
    file = tmp_path / "assessment.json"
    kept = json.loads(file.read_text("utf-8"))
    kept["pantographs"][0]["std_force_N"] = 1.0
    file.write_text(json.dumps(STALE[change](kept)), "utf-8")
    assert only(tmp_path).pantographs[0].std_force_N == sigma


def test_an_assessment_older_than_its_result_is_not_believed(tmp_path: Path) -> None:
    result = saved(tmp_path)
    result.dataset["contact_force"] += 10.0
    result.save(tmp_path / "result.nc")
    os.utime(tmp_path / "assessment.json", ns=(0, 0))
    # The mean of the record that was made over, to the filter's rounding.
    assert only(tmp_path).pantographs[0].mean_force_N == pytest.approx(110.0, rel=1e-3)


def test_an_assessment_that_was_edited_is_not_believed(tmp_path: Path) -> None:
    result = saved(tmp_path)
    beside = tmp_path / "assessment.json"
    kept = json.loads(beside.read_text(encoding="utf-8"))
    kept["pantographs"][0]["std_force_N"] = 1.0
    beside.write_text(json.dumps(kept), encoding="utf-8")
    later = (tmp_path / "result.nc").stat().st_mtime + WRITTEN_TOGETHER_S + 1.0
    os.utime(beside, (later, later))
    whole = result.assessment.pantographs[0].std_force_N
    assert only(tmp_path).pantographs[0].std_force_N == pytest.approx(whole, rel=1e-12)  # rounding


def test_a_result_of_another_version_is_assessed_anew(tmp_path: Path) -> None:
    saved(tmp_path, attrs={"arcless_version": "0.0.9"})
    kept = json.loads((tmp_path / "assessment.json").read_text("utf-8"))
    (tmp_path / "assessment.json").write_text(json.dumps(kept | {"criteria": []}), "utf-8")
    found = only(tmp_path)
    assert (found.version, found.verdict) == ("0.0.9", "met")


@pytest.mark.parametrize("content", ["", "{", "null", "[" * 5000, "\0\1\2"])
def test_a_damaged_assessment_is_not_read(tmp_path: Path, content: str) -> None:
    saved(tmp_path)
    (tmp_path / "assessment.json").write_text(content, "utf-8")
    assert only(tmp_path).verdict == "met"


def test_a_run_that_stopped_says_where(tmp_path: Path) -> None:
    state = {"position_m": 612.5, "step": 5, "time_s": 5.0}
    saved(tmp_path, attrs={"state": state})
    found = only(tmp_path)
    assert found.verdict == "stopped early"
    assert (found.reason or "").startswith("at 612.50 m, ")
    assert found.pantographs == () and found.worst is None


def test_changes_are_told(tmp_path: Path) -> None:
    data = load(scenario_data()).with_(speed="80 km/h").to_dict()
    saved(tmp_path, scenario=data)
    assert only(tmp_path).changes == {"speed": "80 km/h"}


def spoilt(good: bytes) -> dict[str, bytes]:
    middle = len(good) // 2
    return {
        "empty.nc": b"",
        "text.nc": b"hello",
        "half.nc": good[:middle],
        "zeros.nc": good[:middle] + bytes(512) + good[middle + 512 :],
        "tail.nc": good[:-1] + b"g",
    }


def test_what_cannot_be_read_is_told_among_the_others(tmp_path: Path) -> None:
    import h5py

    saved(tmp_path / "good")
    good = (tmp_path / "good" / "result.nc").read_bytes()
    for name, content in spoilt(good).items():
        (tmp_path / name).write_bytes(content)
    with h5py.File(tmp_path / "foreign.nc", "w") as file:
        file["x"] = np.arange(3)
    with h5py.File(tmp_path / "later.nc", "w") as file:
        file.attrs["format"] = "arcless-result/99"
    (tmp_path / "lost.nc").symlink_to("nowhere")
    (tmp_path / "folder.nc").mkdir()
    (tmp_path / ".hidden.nc").write_bytes(b"")
    found = {one.path.name: one for one in arcless.runs(tmp_path)}
    bad = {*spoilt(good), "foreign.nc", "later.nc", "lost.nc"}
    assert set(found) == {"good", *bad}
    for name in bad:
        assert found[name].verdict == "unreadable", name
        assert found[name].reason and "\n" not in (found[name].reason or ""), name
        assert found[name].name is None
    assert "checksum" in (found["zeros.nc"].reason or "")
    assert "arcless-result/99" in (found["later.nc"].reason or "")
    assert found["good"].verdict == "met"


def test_attributes_that_make_no_sense_are_damage(tmp_path: Path) -> None:
    data = scenario_data()
    for attrs in ({"scenario": {**data, "provenance": []}}, {"state": {"no": 1}}):
        result = saved(tmp_path, attrs=attrs) if "state" in attrs else saved(tmp_path)
        result.dataset.attrs.update({key: json.dumps(value) for key, value in attrs.items()})
        result.save(tmp_path / "result.nc")
        assert only(tmp_path).verdict == "unreadable", attrs


def test_a_result_with_nothing_but_what_every_version_has(tmp_path: Path) -> None:
    data = load(scenario_data()).with_(speed="80 km/h").to_dict()
    del data["provenance"]["speed"]["given"]  # of the time before values were kept as typed
    result = saved(tmp_path, scenario=data, attrs={"arcless_version": "0.0.1"})
    for name, attribute in ATTRIBUTES.items():
        if not attribute.required:
            result.dataset.attrs.pop(name, None)
    result.save(tmp_path / "result.nc")
    found = only(tmp_path)
    assert (found.verdict, found.version) == ("met", "0.0.1")
    assert float(found.changes["speed"]) == pytest.approx(80 / 3.6, rel=1e-12)


def test_the_oldest_comes_first_and_studies_are_left_out(tmp_path: Path) -> None:
    for name, year in (("late", 2026), ("early", 2025)):
        saved(tmp_path / name, attrs={"created": f"{year}-01-01T00:00:00+00:00"})
    saved(tmp_path / "study" / "results")
    (tmp_path / "study" / "study.json").write_text("{}")
    found = arcless.runs(tmp_path)
    assert [one.path.name for one in found] == ["early", "late"]


def test_folders_that_are_none(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    assert arcless.runs() == []
    with pytest.raises(ResultFormatError, match="absent: no such folder"):
        arcless.runs("absent")
    Path("file").touch()
    with pytest.raises(ResultFormatError, match="file: no such folder: got a file"):
        arcless.runs("file")
    Path("runs").touch()
    with pytest.raises(ResultFormatError, match="got a file"):
        arcless.runs()


def test_what_is_no_run_is_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    saved(Path("runs/one"))
    study = [f"study/{name}" for name in ("study.json", "table.parquet", "report.html")]
    for name in (*study, "x.yaml", "x.html", "runs/one/report.html", "many/a.nc", "empty/x.txt"):
        Path(name).parent.mkdir(exist_ok=True)
        Path(name).write_text("{}")
    for path, words in {
        **dict.fromkeys(study, "study in place of a run"),
        "study": "study in place of a run.*arcless study report study",
        "x.yaml": "describes what to run.*arcless run x.yaml",
        "x.html": r"or the result\.nc in it$",
        "runs/one/assessment.json": "the run is runs/one/result.nc",
        "runs/one/report.html": "the run is runs/one/result.nc",
        "runs": "arcless runs runs",
        "many": "name the file, such as many/a.nc",
        "empty": "no run in this folder.*arcless run SCENARIO --out empty",
        "one": "did you mean runs/one",
        "en50318-ac-simple-320": "shipped scenario: `arcless run en50318-ac-simple-320`",
        "absent": "no such result file",
    }.items():
        with pytest.raises(ResultFormatError, match=words):
            arcless.open(path)
    assert run_file("runs/one") == run_file("runs/one/result.nc") == Path("runs/one/result.nc")


def test_files_of_a_study_are_known_by_the_names_that_it_writes() -> None:
    from arcless.results.kept_runs import places
    from arcless.study.folder.folder import NAMES, TABLE

    assert set(places._OF_STUDIES) <= NAMES
    assert places.TABLE == TABLE
