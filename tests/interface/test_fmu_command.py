"""`arcless fmu`: what it writes, says and refuses."""

import json
import zipfile
from collections.abc import Callable
from pathlib import Path

import pytest
from typer.testing import Result

Arcless = Callable[..., Result]


def test_a_line_is_exported(arcless: Arcless, short: Path, tmp_path: Path) -> None:
    done = arcless("fmu", "export", short, "--out", "line.fmu", "--uplift", "support 3")
    assert done.exit_code == 0, done.output
    assert "inputs: speed [m/s], P1.contact_force [N]" in done.stdout
    assert "support_3.uplift [m]" in done.stdout
    assert "for x86_64-linux" in done.stdout
    assert done.stdout.rstrip().endswith("wrote line.fmu")
    with zipfile.ZipFile(tmp_path / "line.fmu") as file:
        assert b'fmiVersion="2.0"' in file.read("modelDescription.xml")


def test_all_is_said_as_json(arcless: Arcless, short: Path, tmp_path: Path) -> None:
    words = ("--fmi", "3", "--given", "strip-height", "--travel", "position", "--json")
    done = arcless("fmu", "export", short, "--out", "line.fmu", *words)
    assert done.exit_code == 0, done.output
    facts = json.loads(done.stdout)
    names = [v["name"] for v in facts["variables"] if v["role"] == "input"]
    assert names == ["position", "P1.strip_height", "P1.strip_velocity", "P1.strip_compliance"]
    assert all(v["description"] for v in facts["variables"])
    with zipfile.ZipFile(tmp_path / "line.fmu") as file:
        assert facts["token"].encode() in file.read("modelDescription.xml")


def test_a_model_for_c_and_the_library(arcless: Arcless, short: Path, tmp_path: Path) -> None:
    assert arcless("fmu", "export", short, "--out", "line.loop").exit_code == 0
    assert (tmp_path / "line.loop").read_bytes().startswith(b"ARCLOOP")
    done = arcless("fmu", "library", ".")
    assert done.exit_code == 0
    assert (tmp_path / "arcless_loop.h").is_file()


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("--out", "line.zip"), "expected a name that ends in .fmu, .loop"),
        (("--out", "line.loop", "--fmi", "2"), "no --fmi for NAME.loop"),
        (("--out", "a.fmu", "--pantograph", "P1", "--given", "strip-height"), "contact-force"),
        (("--out", "a.fmu", "--pantograph", "P7"), "expected `P1`"),
        (("--out", "a.fmu", "--uplift", "support 99"), "a support of the line"),
        (("--out", "none/a.fmu"), "no folder"),
    ],
)
def test_what_is_refused(
    arcless: Arcless, short: Path, tmp_path: Path, words: tuple[str, ...], said: str
) -> None:
    done = arcless("fmu", "export", short, *words)
    assert done.exit_code == 2
    assert said in done.stderr
    assert not list(tmp_path.iterdir())
