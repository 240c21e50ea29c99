"""`arcless measure`, and measured files in `arcless compare`: the guide, and what is refused."""

import json
import re
import shlex
from collections.abc import Callable
from pathlib import Path

import pytest
from typer.testing import Result

import arcless as package
from tests.support import alignment_rates
from tests.support.beside import test_run as written

GUIDE = Path(__file__).parents[2] / "docs" / "guide" / "compare-measured.md"
Run = Callable[..., Result]


def refused(done: Result, *words: str) -> None:
    assert done.exit_code == 2, done.output
    assert not done.stdout
    for word in words:
        assert word in done.stderr


def test_the_worked_case_of_the_guide(arcless: Run) -> None:
    text = GUIDE.read_text("utf-8")
    (commands,) = re.findall(r"```sh\n(.*?)```", text, re.DOTALL)
    (printed,) = re.findall(r"```text\n(.*?)```", text, re.DOTALL)
    for line in commands.splitlines():
        done = arcless(*shlex.split(line)[1:])
        assert done.exit_code in (0, 3), done.output
    shown = done.stdout.replace("\u00a0", " ").splitlines()
    for line in printed.splitlines():
        assert line.rstrip() in shown
    assert Path("measured.html").is_file()
    table = re.findall(r"^\| ([^|]*) \| ([\d.]+) N \| ([\d.]+) N \| ([\d.]+) N \|$", text, re.M)
    assert len(table) == 4
    bare = json.loads(arcless("compare", "runs/line", "test-run.csv", "--json").stdout)
    whole = json.loads(
        arcless("compare", "runs/line", "test-run.csv", "--head-mass", "7.5 kg", "--json").stdout
    )
    keys = ("std_force_N", "std_force_0_5Hz_N", "std_force_5_20Hz_N", "min_force_N")
    for key, row in zip(keys, table, strict=True):
        values = [
            next(one for one in found["indicators"] if one["key"] == key)["values"]
            for found in (whole, bare)
        ]
        told = [values[0][0], values[0][1], values[1][1]]
        assert [f"{one:.1f}" for one in told] == list(row[1:]), key
    lagging = json.loads(
        arcless("compare", "runs/line", "test-run.csv", "--align-by", "force", "--json").stdout
    )
    places = [found["runs"][1]["alignments"][0] for found in (whole, bare, lagging)]
    assert [one["channel"] for one in places] == ["force", "height", "force"]
    corrected, heights, forces = (one["offset_m"] for one in places)
    assert f"by {corrected - forces:.1f} m" in text
    # A hundredth of the shortest wave, 4.4 m, and as much for the scale of the forces.
    assert heights == pytest.approx(corrected, abs=0.09)
    assert any("not corrected for the inertia" in one for one in bare["warnings"])
    (code,) = re.findall(r"```python\n(.*?)```", text, re.DOTALL)
    exec(compile(code, str(GUIDE), "exec"), {})
    assert Path("again.html").is_file()


def test_the_rates_of_the_guide() -> None:
    rows = re.findall(r"^\| (\d+) m \| ([\d.]+) σ \| (.*) \|$", GUIDE.read_text("utf-8"), re.M)
    assert len(rows) == len(alignment_rates.LENGTHS_M) * len(alignment_rates.NOISES)
    run = package.run(package.load(alignment_rates.SCENARIO))
    for length, noise, cells in rows:
        found = alignment_rates.rates(run, float(length), float(noise))
        for told, one in zip(cells.split(" | "), found.values(), strict=True):
            # Last bits of another processor may move one of a hundred over a limit.
            ours = (one.right, one.not_sure, one.untold)
            for number, here in zip(told.split(" / "), ours, strict=True):
                assert abs(int(number) - here) <= 1, (length, noise, told, ours)


def test_the_guide_names_every_key(arcless: Run, tmp_path: Path, finished: Path) -> None:
    arcless("measure", finished, "--to", "test.csv")
    words = ("test.csv", "--align", "none", "--json")
    data = json.loads(arcless("compare", finished, *words).stdout)
    text = GUIDE.read_text("utf-8")
    keys = {*data["bands"][0], *data["acceptance"][0], *data["runs"][1]["alignments"][0]}
    assert [key for key in sorted(keys) if f"`{key}`" not in text] == []


def test_an_exported_run_lies_where_it_ran(arcless: Run) -> None:
    arcless("run", "en50318-ac-simple-275-planar", "--out", "run", "--no-report", "--quiet")
    arcless("export", "run", "--to", "run.csv")
    data = json.loads(arcless("compare", "run", "run.csv", "--json").stdout)
    (by,) = data["runs"][1]["alignments"]
    assert by["offset_m"] == pytest.approx(0.0, abs=1e-6)
    assert by["correlation"] == pytest.approx(1.0, abs=1e-9)
    for one in data["indicators"]:
        if one["key"] in ("std_force_N", "max_force_N", "contact_point_range_mm"):
            assert one["differences"][1] == pytest.approx(0.0, abs=1e-9)
    assert data["warnings"] == []


def test_what_measure_tells_and_refuses(arcless: Run, finished: Path) -> None:
    done = arcless("measure", finished, "--to", "test.csv", "--force-max", "60 N")
    assert done.exit_code == 0, done.output
    for word in ("wrote test.csv", "samples at 500 Hz", "beyond the range", "delays by"):
        assert word in done.stdout
    refused(arcless("measure", finished, "--to", "no/test.csv"), "no/test.csv")
    refused(arcless("measure", finished, "--to", "a.csv", "--force-noise", "2 kg"), "--force-noise")
    refused(arcless("measure", finished, "--to", "a.csv", "--head-mass", "1 t"), "at most")
    refused(arcless("measure", finished, "--to", "a.csv", "--pantograph", "P9"), "one of P1")
    refused(arcless("measure", finished, "--to", "a.csv", "--rate", "1 MHz"), "--rate")
    refused(arcless("measure", "none", "--to", "a.csv"), "none")
    refused(arcless("measure", finished, "--to", "a.xlsx"), "expected a name that ends in .csv")
    assert not Path("a.csv").exists()


def test_what_compare_refuses_of_measurements(arcless: Run, finished: Path, tmp_path: Path) -> None:
    file = written(tmp_path / "far.csv", begin_m=0.0, end_m=400.0)
    refused(arcless("compare", finished, file, "--align", "eye"), "one of correlation")
    refused(arcless("compare", finished, file, "--offset", "9 km"), "does not overlap")
    refused(arcless("compare", finished, file, "--offset", "9 kg"), "--offset")
    refused(arcless("compare", finished, file, "--scale", "1.1"), "--scale without --offset")
    refused(arcless("compare", finished, file, file), "twice")
    refused(arcless("compare", file), "at least two")
    refused(arcless("compare", finished, finished, "--speed", "90 km/h"), "--speed without")
    refused(arcless("compare", finished, file, "--head-mass", "7 kg"), "contact force already")
    refused(arcless("compare", finished, file, "--head-lift", "7 N"), "--head-mass")
    refused(arcless("compare", finished, "none.csv"), "none.csv")
    (tmp_path / "empty.csv").write_text("", "utf-8")
    refused(arcless("compare", finished, "empty.csv"), "empty.csv")
    (tmp_path / "bad.csv").write_bytes(bytes(range(256)) * 9)
    refused(arcless("compare", finished, "bad.csv", "--out", "page.html"), "bad.csv")
    assert not (tmp_path / "page.html").exists()
