"""Bad input: one message that says where, what was given and what is expected; exit code 2."""

import json
from collections.abc import Callable
from pathlib import Path

import pytest
from typer.testing import Result

Arcless = Callable[..., Result]

# What is replaced in the short scenario, by what, and words that the message must hold.
WRONG_FIELDS = {
    "unit of another kind": ("tension: 22 kN", "tension: 22 kg", ("contact_wire.tension", "kN")),
    "unknown unit": ("tension: 22 kN", "tension: 22 kNn", ("contact_wire.tension", "kN")),
    "unknown field": ("tension: 22 kN", "tensoin: 22 kN", ("tensoin", "tension")),
    "missing field": ("mass: 1.35 kg/m, ", "", ("contact_wire.mass", "missing")),
    "negative mass": ("mass: 1.35 kg/m", "mass: -1.35 kg/m", ("contact_wire.mass", "-1.35")),
    "dropper outside its span": ("45 m]", "55 m]", ("positions", "55")),
    "droppers out of order": ("5 m, 15 m", "15 m, 5 m", ("positions", "5")),
    "zero tension": ("tension: 22 kN", "tension: 0 kN", ("contact_wire.tension", "0")),
    "not a number": ("static_force: 80 N", "static_force: .nan", ("static_force", "nan")),
    "section outside the line": (
        "solver: {time_step: 2 ms}",
        "analysis: {from: 100 m, to: 900 m}",
        ("analysis", "900"),
    ),
    "wrong version": ("arcless-scenario/1", "arcless-scenario/9", ("format", "arcless-scenario/1")),
}
BOMB = "a: &a [x, x, x, x, x, x, x, x, x]\n" + "".join(
    f"{new}: &{new} [{', '.join(['*' + old] * 9)}]\n"
    for old, new in zip("abcdefgh", "bcdefghi", strict=True)
)
WRONG_FILES = {
    "empty": b"",
    "binary": bytes(range(256)) * 16,
    "aliases that explode": BOMB.encode(),
    "no mapping": b"- 1\n- 2\n",
    "broken YAML": b"format: [arcless-scenario/1\nname: x",
    "refers to itself": (
        b"format: arcless-scenario/1\nname: x\ndescription: x\nline: bad.yaml\nspeed: 10\n"
        b"pantographs: []\n"
    ),
}


def assert_refused(done: Result, *words: str) -> None:
    """Exit code 2, an error on standard error, nothing else anywhere."""
    assert done.exit_code == 2, (done.stdout, done.stderr)
    assert done.stdout == ""
    assert done.stderr.startswith("error: ")
    assert "Traceback" not in done.stderr
    assert "internal fault" not in done.stderr
    for word in words:
        assert word in done.stderr


@pytest.mark.parametrize("what", WRONG_FIELDS)
@pytest.mark.parametrize("command", ["check", "run"])
def test_wrong_field(
    arcless: Arcless, short: Path, tmp_path: Path, command: str, what: str
) -> None:
    old, new, words = WRONG_FIELDS[what]
    text = short.read_text("utf-8")
    assert old in text
    (tmp_path / "bad.yaml").write_text(text.replace(old, new, 1), "utf-8")
    assert_refused(arcless(command, "bad.yaml"), "bad.yaml", *words)
    assert [path.name for path in tmp_path.iterdir()] == ["bad.yaml"]


@pytest.mark.parametrize("what", WRONG_FILES)
def test_wrong_file(arcless: Arcless, tmp_path: Path, what: str) -> None:
    (tmp_path / "bad.yaml").write_bytes(WRONG_FILES[what])
    for command in ("check", "run", "statics"):
        assert_refused(arcless(command, "bad.yaml"), "bad.yaml")


def test_huge_file(arcless: Arcless, tmp_path: Path) -> None:
    with (tmp_path / "bad.yaml").open("wb") as file:
        file.truncate(100_000_000)
    assert_refused(arcless("check", "bad.yaml"), "bad.yaml")


def test_missing_files(arcless: Arcless) -> None:
    assert_refused(arcless("check", "none.yaml"), "none.yaml")
    assert_refused(arcless("run", "en50318-ac-simple-321"), "en50318-ac-simple-320")
    assert_refused(arcless("assess", "none.nc"), "none.nc")
    assert_refused(arcless("report", "none.nc"), "none.nc")
    assert_refused(arcless("replay", "none.json"), "none.json")


def test_result_that_is_none(arcless: Arcless, tmp_path: Path) -> None:
    (tmp_path / "bad.nc").write_bytes(b"CDF\x01" + bytes(200))
    for command in ("assess", "report"):
        assert_refused(arcless(command, "bad.nc"), "bad.nc")


@pytest.mark.parametrize(
    ("words", "expected"),
    [
        (("--speed", "300 kg"), "speed"),
        (("--speed", "nan"), "speed"),
        (("--set", "solver.time_step"), "path.to.field=value"),
        (("--set", "solver.timestep=1 ms"), "time_step"),
        (("--set", "pantographs.4.static_force=80 N"), "pantographs"),
        (("--set", "line.contact_wire.tension=20 kg"), "tension"),
        (("--colour",), "--help"),
    ],
)
def test_wrong_option(arcless: Arcless, short: Path, words: tuple[str, ...], expected: str) -> None:
    assert_refused(arcless("run", short, *words), expected)


def test_unwritable_folder_is_found_before_computing(
    arcless: Arcless, short: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("arcless.simulate.run", lambda *_, **__: pytest.fail("computed"))
    (tmp_path / "file").touch()
    assert_refused(arcless("run", short, "--out", "file/out"), "file/out", "--out")
    assert_refused(arcless("run", short, "--out", "file"), "file", "--out")


def test_wrong_section_and_filter(arcless: Arcless, finished: Path) -> None:
    result = finished / "result.nc"
    assert_refused(arcless("assess", result, "--from", "9000 m", "--to", "9100 m"), "section")
    assert_refused(arcless("assess", result, "--from", "3 kg"), "--from", "km")
    assert_refused(arcless("assess", result, "--low-pass", "5 kHz"), "low-pass")
    assert_refused(arcless("assess", result, "--low-pass", "1e-100 Hz"), "low-pass", "0.001 Hz")


@pytest.mark.parametrize(
    "saved",
    [
        "{",
        "[]",
        '{"kind": "other"}',
        '{"kind": "lcp", "w": [1]}',
        '{"kind": "lcp", "w": [1, 2], "H": [[1]]}',
        '{"kind": "lcp", "w": [NaN], "H": [[1]]}',
        '{"kind": "lcp", "w": ["a"], "H": [[1]]}',
        '{"kind": "lcp", "w": [1], "H": [[1]], "links": ["P1", "P2"]}',
        "[" * 100_000,
    ],
)
def test_wrong_problem_to_replay(arcless: Arcless, tmp_path: Path, saved: str) -> None:
    (tmp_path / "bad.json").write_text(saved)
    assert_refused(arcless("replay", "bad.json"), "bad.json")


def test_reports_of_reference_cases_that_cannot_be(arcless: Arcless) -> None:
    # Refused at once, not after the computation.
    assert_refused(arcless("validate", "--report", "nowhere/a.html"), "nowhere/a.html")
    assert_refused(arcless("validate", "other"), "seed")


def test_a_fault_of_ours_is_a_message_too(
    arcless: Arcless, short: Path, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    def broken(*_: object, **__: object) -> None:
        raise ZeroDivisionError("division by zero")

    monkeypatch.setattr("arcless.simulate.run", broken)
    done = arcless("run", short)
    assert done.exit_code == 1
    assert "internal fault: ZeroDivisionError" in done.stderr
    assert "ARCLESS_TRACEBACK" in done.stderr
    assert list(tmp_path.iterdir()) == []


def test_json_never_holds_nan() -> None:
    from arcless.cli.terminal.console import json_text

    with pytest.raises(ValueError, match="Out of range"):
        json_text({"value": float("nan")})
    assert json.loads(json_text({"value": None})) == {"value": None}


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("line.svg", ("line.svg", "not a .html file", "--plot")),
        ("line", ("not a .html file", "without an ending")),
        ("none/line.html", ("none/line.html", "no folder", "a folder that exists")),
        ("folder.html", ("folder.html", "a folder")),
    ],
)
def test_a_drawing_that_cannot_be_written_is_refused_before_computing(
    arcless: Arcless, short: Path, tmp_path: Path, name: str, words: tuple[str, ...]
) -> None:
    (tmp_path / "folder.html").mkdir()
    before = sorted(tmp_path.rglob("*"))
    assert_refused(arcless("statics", short, "--plot", tmp_path / name), *words)
    assert sorted(tmp_path.rglob("*")) == before


def test_a_speed_without_its_unit_is_refused_before_computing(
    arcless: Arcless, short: Path
) -> None:
    for words in (("--speed", "300"), ("--set", "speed=300")):
        assert_refused(arcless("run", short, *words), "did you mean 300 km/h?")
