"""`arcless pantograph fit`: its guide, what it writes, and what it refuses."""

import json
import re
import shlex
from collections.abc import Callable
from pathlib import Path

import pytest
import yaml
from typer.testing import Result

from arcless.model import load
from tests.interface.test_start import OF_OTHERS, modules_of
from tests.support.receptances import FREQUENCIES, measured, table

GUIDE = Path(__file__).parents[2] / "docs" / "guide" / "frequency-responses.md"
BLOCK = re.compile(r"```(\w+)\n(.*?)```", re.S)
# Rows of the tables of the guide that a command prints, with the columns that rounding cannot move.
ROW = re.compile(r"^\| (\d) \|(.*)\|$", re.M)
Command = Callable[..., Result]


@pytest.fixture
def bench(tmp_path: Path) -> Path:
    """Return a table of 1 % noise, few frequencies, of two masses."""
    file = tmp_path / "bench.csv"
    data = measured("en50318-2002", 0.01, frequency=FREQUENCIES[::3])
    file.write_text(table(data, "mobility", "m/s/N"), "utf-8")
    return file


def refused(done: Result, *words: str, code: int = 2) -> None:
    assert done.exit_code == code, done.output
    assert not done.stdout
    for word in words:
        assert word in done.stderr


def test_the_guide(arcless: Command, capsys: pytest.CaptureFixture[str]) -> None:
    text = GUIDE.read_text("utf-8")
    blocks = BLOCK.findall(text)
    making, using = (code for language, code in blocks if language == "python")
    listing, writing = (code for language, code in blocks if language == "sh")
    exec(compile(making, str(GUIDE), "exec"), {})
    said = "".join(arcless(*shlex.split(line)[1:]).stdout for line in (listing, writing))
    cells = {tuple(line.split()) for line in said.splitlines()}
    shown = [tuple(f"{number}{rest}".replace("|", " ").split()) for number, rest in ROW.findall(
        text[: text.index("## Damping")])]  # fmt: skip
    assert len(shown) == 10
    assert [row for row in shown if row not in cells] == []
    words, printed, messages = (code for language, code in blocks if language == "text")
    assert words.strip() in said
    written = Path("bench-head.yaml").read_text("utf-8")
    masses, scenario = (code for language, code in blocks if language == "yaml")
    assert masses in written
    Path("bench-run.yaml").write_text(scenario, "utf-8")
    assert load("bench-run.yaml").pantographs[0].model.masses[2].mass == pytest.approx(7.51338)
    exec(compile(using, str(GUIDE), "exec"), {})
    assert capsys.readouterr().out == printed
    assert Path("amplitude.svg").is_file()
    rows = Path("bench.csv").read_text("utf-8").splitlines(keepends=True)
    tried = (
        ("".join(rows).replace(" [m/s²/N]", ""), ()),
        ("".join([rows[0], *reversed(rows[1:])]), ()),
        ("".join(rows).replace("deg", "rad"), ()),
        ("".join([rows[0], *rows[1::40]]), ("--order", "3")),
        ("".join(rows), ("--order", "1")),
    )
    for message, (table_text, more) in zip(messages.splitlines(), tried, strict=True):
        Path("bench.csv").write_text(table_text, "utf-8")
        done = arcless("pantograph", "fit", "bench.csv", *more)
        assert done.stderr.removeprefix("error: ") == f"{message}\n"
        assert done.exit_code == (1 if "misses" in message else 2)


def test_file_page_and_data(arcless: Command, bench: Path) -> None:
    done = arcless("pantograph", "fit", bench, "--order", 2, "--out", "own.yaml",
                   "--report", "own.html", "--static-force", "8 kgf")  # fmt: skip
    assert done.exit_code == 0, done.output
    assert done.stdout.endswith("pantographs: [{model: own.yaml}]\n")
    assert arcless("check", "own.yaml").stdout == "own.yaml: valid pantograph `own`, 2 masses\n"
    data = yaml.safe_load(Path("own.yaml").read_text("utf-8"))
    assert data["static_force"] == "78.4532 N"
    assert "bench.csv, SHA-256" in data["sources"]["R"]
    page = Path("own.html").read_text("utf-8")
    for words in ("Receptance of own", "mobility in bench.csv", "static_force: 78.4532 N",
                  "likeness of neighbours"):  # fmt: skip
        assert words in page
    found = json.loads(arcless("pantograph", "fit", bench, "--order", 2, "--json").stdout)
    assert found["order"] == 2
    assert 0.5 < found["misfit_percent"] < 1.5  # the noise
    fits = json.loads(arcless("pantograph", "fit", bench, "--json", "--quiet").stdout)
    assert {one["order"] for one in fits} == {1, 2, 3, 4}


def test_a_full_matrix_is_written_as_matrices(arcless: Command, bench: Path) -> None:
    words = ("pantograph", "fit", bench, "--order", 2, "--damping", "full", "--out", "own.yaml")
    assert arcless(*words).exit_code == 0
    said = "own.yaml: valid pantograph `own`, 2 coordinates, given by matrices\n"
    assert arcless("check", "own.yaml").stdout == said
    before = Path("own.yaml").read_bytes()
    refused(arcless(*words), "the file exists", "--overwrite")
    assert arcless(*words, "--overwrite").exit_code == 0
    assert Path("own.yaml").read_bytes() == before


def test_what_is_refused(arcless: Command, bench: Path, tmp_path: Path) -> None:
    fit = ("pantograph", "fit")
    refused(arcless(*fit, "nowhere.csv"), "nowhere.csv")
    refused(arcless(*fit, bench, "--out", "own.yaml"), "--order", "it lists the orders")
    refused(arcless(*fit, bench, "--order", 2, "--out", "own.txt"), "ends in .yaml")
    refused(arcless(*fit, bench, "--order", 2, "--out", "no/own.yaml"), "cannot be written")
    refused(arcless(*fit, bench, "--order", 2, "--static-force", "7 kg"), "--static-force", "kgf")
    refused(arcless(*fit, bench, "--order", 2, "--largest-misfit", "much"), "--largest-misfit")
    refused(arcless(*fit, bench, "--order", 12), "1 to 8 masses")
    refused(arcless(*fit, bench, "--order", 2, "--static-force", "-5 N", "--out", "own.yaml"),
            "static_force", "above 0")  # fmt: skip
    refused(arcless(*fit, bench, "--order", 1, "--out", "own.yaml"), "misses the data", code=1)
    assert sorted(one.name for one in tmp_path.iterdir()) == ["bench.csv"]


def test_it_loads_nothing_that_runs(bench: Path) -> None:
    modules = modules_of("pantograph", "fit", bench, "--order", 1, "--largest-misfit", "90 %")
    slow = {"xarray", "bokeh", "h5netcdf", "h5py", "pandas", "matplotlib"}
    assert not {name.partition(".")[0] for name in modules} & slow
    assert not modules & OF_OTHERS
