"""Each command on good input: what it prints, what it writes, how it ends."""

import json
import shutil
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from typer.testing import Result

from arcless.model import load

Arcless = Callable[..., Result]

# The keys that outside programs read; a missing one breaks them.
ASSESSMENT = set(
    [
        "scenario",
        "version",
        "speed_m_s",
        "pantographs",
        "max_uplift_at_support_mm",
        "slack_droppers_max",
        "min_dropper_force_N",
        "energy_residual_relative",
        "steps",
        "wall_time_s",
        "real_time_factor",
        "criteria",
    ]
)
PANTOGRAPH = set(
    [
        "name",
        "mean_force_N",
        "std_force_N",
        "std_force_0_5Hz_N",
        "std_force_5_20Hz_N",
        "max_force_N",
        "min_force_N",
        "statistical_max_N",
        "statistical_min_N",
        "contact_loss_percent",
        "longest_loss_s",
        "max_gap_mm",
        "contact_point_range_mm",
        "unfiltered_max_force_N",
        "unfiltered_min_force_N",
    ]
)
STATICS = set(
    [
        "droppers",
        "elasticity",
        "elasticity_nonuniformity",
        "contact_wire_sag_m",
        "wave_speed_m_s",
        "natural_frequencies_Hz",
    ]
)
COMMANDS = [
    "library",
    "check",
    "schema",
    "statics",
    "run",
    "resume",
    "runs",
    "assess",
    "report",
    "validate",
    "replay",
    "study",
]


def strict_json(text: str) -> object:
    """Read JSON that holds no NaN and no infinity."""

    def refuse(constant: str) -> object:
        raise AssertionError(f"{constant} in JSON")

    return json.loads(text, parse_constant=refuse)


@pytest.mark.parametrize("name", COMMANDS)
def test_help_of_every_command(arcless: Arcless, name: str) -> None:
    done = arcless(name, "--help")
    assert done.exit_code == 0
    assert done.stdout.startswith(f"Usage: arcless {name}") or "Usage:" in done.stdout
    assert name in arcless("--help").stdout


def test_no_command_prints_help(arcless: Arcless) -> None:
    done = arcless()
    assert done.exit_code == 0
    assert "Commands:" in done.stdout


def test_version(arcless: Arcless) -> None:
    assert arcless("--version").stdout.startswith("arcless 0.")


def test_library_lists_every_kind_with_its_source(arcless: Arcless) -> None:
    entries = strict_json(arcless("library", "--json").stdout)
    kinds = {"line", "pantograph", "scenario", "study", "wire"}
    assert {entry["kind"] for entry in entries} == kinds
    assert all(entry["source"] and entry["title"] for entry in entries)
    names = {entry["name"] for entry in entries}
    assert {f"en50318-ac-simple-{v}" for v in (275, 320)} <= names
    assert {f"en50318-2002-{v}" for v in (250, 300)} <= names
    printed = arcless("library").stdout
    assert all(name in printed for name in names)


def test_check_says_what_a_good_file_holds(arcless: Arcless, short: Path) -> None:
    done = arcless("check", short)
    assert done.exit_code == 0
    assert "valid scenario `short`" in done.stdout
    assert done.stderr == ""


@pytest.mark.parametrize("every", [False, pytest.param(True, marks=pytest.mark.evidence)])
def test_check_takes_shipped_models(arcless: Arcless, every: bool) -> None:
    """One of each kind, or every one; tests/unit/model/shipped loads them all."""
    entries = strict_json(arcless("library", "--json").stdout)
    names = {entry["kind"]: [e["name"] for e in entries if e["kind"] == entry["kind"]]
             for entry in entries if entry["kind"] != "wire"}  # fmt: skip
    assert len(names) > 2
    for name in (name for known in names.values() for name in (known if every else known[:1])):
        done = arcless("check", name)
        assert done.exit_code == 0, done.stderr
        assert done.stdout.startswith(f"{name}: valid ")


def test_check_warns_above_the_wave_speed(arcless: Arcless, short: Path, tmp_path: Path) -> None:
    fast = tmp_path / "fast.yaml"
    fast.write_text(short.read_text("utf-8").replace("160 km/h", "500 km/h"), "utf-8")
    done = arcless("check", fast)
    assert done.exit_code == 0
    assert "warning:" in done.stderr
    assert "wave speed" in done.stderr


def test_schema_is_json(arcless: Arcless) -> None:
    assert strict_json(arcless("schema").stdout)["$schema"].startswith("https://json-schema.org/")


def test_statics_prints_tables_and_json(arcless: Arcless, short: Path, tmp_path: Path) -> None:
    found = strict_json(arcless("statics", short, "--json", "--out", "here").stdout)
    assert set(found) >= STATICS
    assert {"span", "x_m", "length_m", "force_N"} <= set(found["droppers"][0])
    assert {dropper["span"] for dropper in found["droppers"]} == set(range(1, 9))
    assert strict_json((tmp_path / "here/statics.json").read_text("utf-8")) == found
    printed = arcless("statics", short)
    assert printed.exit_code == 0
    assert "Droppers of span" in printed.stdout
    assert "Resonance speeds" in printed.stdout
    assert "wave speed" in printed.stdout
    assert "Note: speeds above 576 km/h" in printed.stdout


def test_statics_draws_the_line(arcless: Arcless, short: Path, tmp_path: Path) -> None:
    drawing = tmp_path / "line.html"
    done = arcless("statics", short, "--plot", drawing)
    assert done.exit_code == 0
    assert f"wrote {drawing}" in done.stdout
    assert "Line at rest" in drawing.read_text("utf-8")
    plain = arcless("statics", short, "--plot", drawing, "--json")
    assert strict_json(plain.stdout)["line"]  # nothing but JSON on standard output


def test_run_writes_three_files(finished: Path) -> None:
    names = sorted(path.name for path in finished.iterdir())
    assert names == ["assessment.json", "report.html", "result.nc"]
    assessment = strict_json((finished / "assessment.json").read_text("utf-8"))
    assert set(assessment) >= ASSESSMENT
    assert set(assessment["pantographs"][0]) >= PANTOGRAPH
    assert all(
        {"name", "value", "limit", "passed", "source"} <= set(c) for c in assessment["criteria"]
    )


def test_run_json_is_the_assessment_and_nothing_else(arcless: Arcless, short: Path) -> None:
    done = arcless("run", short, "--json", "--no-report", "--speed", "180 km/h")
    assessment = strict_json(done.stdout)
    # 180 km/h is 50 m/s; the value passes through the file's seven-digit text at most.
    assert assessment["speed_m_s"] == pytest.approx(50.0, rel=1e-6)
    missed = any(item["passed"] is False for item in assessment["criteria"])
    assert done.exit_code == (3 if missed else 0)
    assert sorted(path.name for path in Path("runs/short-speed=180_km-h").iterdir()) == [
        "assessment.json",
        "result.nc",
    ]


def test_run_records_how_to_run_it_again(arcless: Arcless, short: Path) -> None:
    import xarray

    words = ("run", short, "--set", "solver.time_step=4 ms", "--out", "again", "--no-report")
    assert "wrote again/result.nc" in arcless(*words).stdout.replace("\\", "/")
    with xarray.open_dataset("again/result.nc", engine="h5netcdf", decode_times=False) as dataset:
        assert dataset.attrs["command"] == f"arcless run {short} --set 'solver.time_step=4 ms'"
        # Recorded times are multiples of the step, rounded to double precision.
        np.testing.assert_allclose(np.diff(dataset["time"])[:5], 4e-3, rtol=1e-9)


def test_what_is_unverified_is_told_before_a_signature(arcless: Arcless, short: Path) -> None:
    words = ("--set", "pantographs.0.model=faiveley-cx", "--out", "own", "--quiet")
    done = arcless("run", short, *words)
    told = strict_json(Path("own/assessment.json").read_text("utf-8"))
    # Up to 200 km/h the laws of the mean force and the limit of NQ are from memory.
    assert " against unverified limits" in told["verdict"]
    assert f"{told['verdict']}.\n" in done.stdout
    warning = "pantograph faiveley-cx: 9 values are from memory, unverified (mark C)"
    assert f"Warnings:\n- {warning}" in done.stdout
    assert f"Warnings:\n- {warning}" in arcless("assess", "own").stdout
    page = Path("own/report.html").read_text("utf-8")
    assert warning in page.partition('id="criteria"')[0]


def test_quiet_run_says_nothing_on_standard_error(arcless: Arcless, short: Path) -> None:
    assert arcless("run", short, "--quiet", "--no-report").stderr == ""


def test_assess_again_over_another_section(
    arcless: Arcless, finished: Path, tmp_path: Path
) -> None:
    words = ("--from", "150 m", "--to", "0.25 km", "--low-pass", "15 Hz", "--out", "again.json")
    done = arcless("assess", finished / "result.nc", "--json", *words)
    assessment = strict_json(done.stdout)
    assert assessment["section_m"] == [150.0, 250.0]
    assert assessment["low_pass_Hz"] == 15.0
    assert strict_json((tmp_path / "again.json").read_text("utf-8")) == assessment
    assert "Criteria" in arcless("assess", finished / "result.nc").stdout


def test_assess_without_options_repeats_the_assessment(arcless: Arcless, finished: Path) -> None:
    again = strict_json(arcless("assess", finished / "result.nc", "--json").stdout)
    assert again == strict_json((finished / "assessment.json").read_text("utf-8"))


def test_report_again(arcless: Arcless, finished: Path, tmp_path: Path) -> None:
    shutil.copy(finished / "result.nc", tmp_path)
    assert arcless("report", "result.nc").exit_code == 0
    assert arcless("report", "result.nc", "--out", "other.html").exit_code == 0
    assert (tmp_path / "report.html").stat().st_size > 0
    assert (tmp_path / "other.html").stat().st_size > 0


def test_replay_prints_the_solution(arcless: Arcless, tmp_path: Path) -> None:
    # x = 0.5 closes the first link (2·0.5 − 1 = 0); the second stays open with y = 3.
    problem = {"kind": "lcp", "H": [[2.0, 0.0], [0.0, 1.0]], "w": [-1.0, 3.0], "step": 7}
    saved = tmp_path / "failed.json"
    saved.write_text(json.dumps({**problem, "time_s": 0.007, "links": ["P1", "dropper 3"]}))
    done = arcless("replay", saved)
    assert done.exit_code == 0, done.stderr
    assert "step: 7, time: 0.007 s, links: 2" in done.stdout
    assert "P1: x = 0.5, y = 0" in done.stdout
    assert "dropper 3: x = 0, y = 3" in done.stdout


def test_replay_of_an_unsolvable_problem_fails(arcless: Arcless, tmp_path: Path) -> None:
    # −x − 1 ≥ 0 has no solution with x ≥ 0.
    saved = tmp_path / "failed.json"
    saved.write_text(json.dumps({"kind": "lcp", "H": [[-1.0]], "w": [-1.0]}))
    done = arcless("replay", saved)
    assert done.exit_code == 1
    assert "status: not solved" in done.stdout
    assert done.stderr.startswith("error:")


@pytest.mark.parametrize("kind", ["line", "pantograph", "scenario", "study", "wire"])
def test_library_lists_one_kind(arcless: Arcless, kind: str) -> None:
    entries = strict_json(arcless("library", kind, "--json").stdout)
    assert entries and {entry["kind"] for entry in entries} == {kind}


def test_a_line_where_a_scenario_is_wanted_is_told_apart(arcless: Arcless) -> None:
    done = arcless("run", "norway-s25")
    assert done.exit_code == 2
    assert "norway-s25 is a shipped line; did you mean norway-s25-250?" in done.stderr


def test_an_earlier_name_of_a_scenario_runs_and_says_what_it_is_called_now(
    arcless: Arcless, tmp_path: Path
) -> None:
    until = ("--until", "100 m", "--no-report")
    done = arcless("run", "ac-simple-3d-320", *until, "--out", tmp_path / "new")
    assert "warning: scenario ac-simple-3d-320 is now called en50318-ac-simple-320" in done.stderr
    assert "FutureWarning" not in done.stderr
    done = arcless("check", "ac-simple-3d-320")
    assert "is now called en50318-ac-simple-320" in done.stderr
    done = arcless("run", "ac-simple-3d-320", *until, "--quiet", "--out", tmp_path / "quiet")
    assert "is now called" not in done.stderr


ARMS = {"kind": "arm", "length": 1.2, "slope": 0.14, "mass": 0.7}


@pytest.mark.parametrize("kind", ["line", "scenario"])
def test_check_finds_the_line_at_rest(
    arcless: Arcless, short: Path, tmp_path: Path, kind: str
) -> None:
    """Three equal staggers leave an arm with what leaning droppers do: it would have to push."""
    data = load(str(short)).to_dict()
    line = data["line"]
    line["steady_arm"] = ARMS
    line["geometry"]["stagger_contact_wire"] = [0.3, 0.3, 0.3, -0.3, -0.3, -0.3]
    written = data if kind == "scenario" else line
    (tmp_path / "pushed.yaml").write_text(json.dumps(written), "utf-8")
    done = arcless("check", "pushed.yaml")
    assert (done.exit_code, done.stdout) == (2, "")
    assert "pushed.yaml: " in done.stderr
    assert "the steady arm at support" in done.stderr
    assert "would have to push: got a force of -" in done.stderr
    # Nothing was computed that could have failed: the file is wrong for both commands.
    again = arcless("statics", "pushed.yaml", "--quiet")
    assert (again.exit_code, again.stdout, again.stderr) == (2, "", done.stderr)


@pytest.mark.parametrize("tension", ["18.37 N", "60 N"])
def test_statics_and_check_say_the_same_of_a_loose_wire(
    arcless: Arcless, tmp_path: Path, tension: str
) -> None:
    data = load("en50318-ac-simple-320-planar").to_dict()
    data["line"]["contact_wire"]["tension"] = tension
    (tmp_path / "loose.yaml").write_text(json.dumps(data), "utf-8")
    checked = arcless("check", "loose.yaml")
    found = arcless("statics", "loose.yaml", "--quiet")
    assert (checked.exit_code, found.exit_code) == (2, 2)
    assert "error: loose.yaml: " in found.stderr
    assert checked.stderr.splitlines()[-1] == found.stderr.splitlines()[-1]


def test_a_run_of_a_loose_wire_is_wrong_input_and_asks_for_the_unit(
    arcless: Arcless, tmp_path: Path
) -> None:
    planar = "en50318-ac-simple-320-planar"
    tension = ("--set", "line.contact_wire.tension=25", "--quiet")
    ran = arcless("run", planar, *tension, "--out", "loose")
    found = arcless("statics", planar, *tension)
    assert (ran.exit_code, ran.stdout) == (2, "")
    assert ran.stderr == found.stderr
    assert f"error: {planar}: contact wire at " in ran.stderr
    assert "did you mean 25 kN? a number without a unit is in N" in ran.stderr
    assert not (tmp_path / "loose").exists()


def test_a_search_that_fails_is_no_mistake_of_the_file() -> None:
    from arcless.errors import ModelError, NotConvergedError
    from arcless.simulate.checks import faults_of

    def failed() -> NotConvergedError:
        return NotConvergedError("no static equilibrium was found", where="contact wire at 3 m")

    told = r"^own\.yaml: contact wire at 3 m: no static"
    with pytest.raises(NotConvergedError, match=told), faults_of("own.yaml"):
        raise failed()
    with pytest.raises(ModelError, match=told), faults_of("own.yaml", model_alone=True):
        raise failed()


@pytest.mark.parametrize("command", ["assess", "report"])
def test_a_run_is_named_by_its_folder_or_its_file(
    arcless: Arcless, finished: Path, tmp_path: Path, command: str
) -> None:
    shutil.copytree(finished, tmp_path / "kept")
    by_folder = arcless(command, "kept")
    assert by_folder.exit_code in (0, 3), by_folder.output
    assert by_folder.stdout == arcless(command, "kept/result.nc").stdout
    (tmp_path / "empty").mkdir()
    refused = arcless(command, "empty")
    assert refused.exit_code == 2
    assert "empty: no run in this folder: got no result.nc" in refused.stderr


def test_the_library_is_short_and_has_its_sources_on_demand(arcless: Arcless) -> None:
    short, long = arcless("library").stdout, arcless("library", "--sources").stdout
    assert len(short.splitlines()) < len(long.splitlines()) / 2
    assert "GitHub" not in short
    assert "GitHub" in long
    assert arcless("library", "-v").stdout == long


def test_tables_in_a_pipe_end_without_blanks(arcless: Arcless) -> None:
    lines = arcless("statics", "norway-s25-250").stdout.splitlines()
    assert lines
    assert [line for line in lines if line != line.rstrip()] == []


def test_a_run_that_ends_before_until_is_refused(arcless: Arcless, short: Path) -> None:
    done = arcless("run", short, "--until", "5 km")
    assert done.exit_code == 2
    assert "until: the run ends before that: got" in done.stderr
    assert "5 km" in done.stderr


def test_notes_and_tolerances_stand_on_the_terminal(
    arcless: Arcless, short: Path, tmp_path: Path
) -> None:
    text = short.read_text("utf-8").replace("  design: {supply: AC 25 kV}\n", "")
    (tmp_path / "silent.yaml").write_text(text, "utf-8")
    done = arcless("run", "silent.yaml")
    assert done.exit_code == 0, done.output  # a supply that nobody gave decides nothing
    assert "Notes:\n- line.design.supply is not given" in done.stdout
    assert "Criteria, AC 25 kV" in done.stdout
    assert "+ 1 " in done.stdout
    assert "warning: line.design.supply: not given" in done.stderr
    assert "not met (unverified)" in done.stdout or "not met" not in done.stdout


def test_statics_of_a_line_alone(arcless: Arcless) -> None:
    done = arcless("statics", "norway-s25", "--json", "--quiet")
    found = strict_json(done.stdout)
    assert (found["scenario"], found["line"], done.stderr) == (None, "norway-s25", "")
    assert set(strict_json(arcless("statics", "norway-s25-250", "--json").stdout)) == set(found)
    printed = arcless("statics", "norway-s25").stdout
    assert "norway-s25: line at rest" in printed
    assert "Resonance speeds" not in printed


def test_statics_of_a_line_takes_what_that_of_a_scenario_takes(arcless: Arcless) -> None:
    arcless("new", "ridge", "--from", "norway-s25")
    words = ("--plot", "p.html", "--droppers", "d.csv", "--supports", "s.csv", "--out", "out")
    change = ("--set", "contact_wire.tension=12 kN")
    done = arcless("statics", "ridge.yaml", *words, *change, "--quiet")
    assert done.stdout.endswith("wrote s.csv\n")
    found = strict_json(Path("out/statics.json").read_text("utf-8"))
    assert found["wave_speed_m_s"] == pytest.approx((12e3 / 1.091) ** 0.5, rel=1e-3)
    # With the name that the field has in a scenario, too.
    words = ("--set", "line.contact_wire.tension=12 kN", "--json", "--quiet")
    same = strict_json(arcless("statics", "ridge.yaml", *words).stdout)
    assert same == found


def test_a_name_of_both_is_the_scenario(arcless: Arcless) -> None:
    name = "china-stitched-350"
    for given, scenario in ((name, name), (f"scenario/{name}", name), (f"line/{name}", None)):
        found = strict_json(arcless("statics", given, "--json", "--quiet").stdout)
        assert (found["scenario"], found["line"]) == (scenario, name)


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (("run", "ridge.yaml"), "this is a line: `arcless statics ridge.yaml`"),
        (("statics", "dsa-250"), "dsa-250 is a shipped pantograph"),
        (("statics", "ridge.yaml", "--set", "contact_wire.tention=1"), "did you mean tension?"),
        (("statics", "ridge.yaml", "--set", "speed=1"), "expected a field of the line"),
        (("statics", "bad.yaml"), "bad.yaml:3"),
    ],
)
def test_statics_of_a_line_says_what_is_wrong(
    arcless: Arcless, words: tuple[str, ...], told: str
) -> None:
    arcless("new", "ridge", "--from", "norway-s25")
    Path("bad.yaml").write_text("format: arcless-line/1\nname: [\n")
    done = arcless(*words)
    assert done.exit_code == 2
    assert told in done.stderr
