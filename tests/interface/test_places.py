"""Places to write to that are no such places: refused before computing, and nothing is lost."""

from collections.abc import Callable
from pathlib import Path

import pytest
from typer.testing import Result

Arcless = Callable[..., Result]


def keep(folder: Path) -> Path:
    """Make a folder with something in it."""
    thesis = folder / "precious" / "thesis.txt"
    thesis.parent.mkdir(parents=True)
    thesis.write_text("years of work\n")
    return thesis


@pytest.fixture
def never(monkeypatch: pytest.MonkeyPatch) -> None:
    """Fail where anything is computed."""
    from arcless import simulate

    def fault(*_arguments: object, **_options: object) -> None:
        raise AssertionError("it was computed first")

    for name in ("run", "statics", "resume"):
        monkeypatch.setattr(simulate, name, fault)


@pytest.mark.parametrize("name", ["result.nc", "assessment.json", "report.html"])
def test_folders_in_the_place_of_files_of_a_run(
    arcless: Arcless, short: Path, tmp_path: Path, name: str, never: None
) -> None:
    thesis = keep(tmp_path / "out" / name)
    done = arcless("run", short, "--out", "out")
    assert done.exit_code == 2, done.stderr
    assert f"out/{name}: the file cannot be written: got a folder" in done.stderr.replace("\n", " ")
    assert thesis.read_text() == "years of work\n"
    assert sorted(path.name for path in (tmp_path / "out").iterdir()) == [name]


def test_a_folder_that_comes_while_it_computes(
    arcless: Arcless, short: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from arcless.cli.output import outcome

    write, made = outcome.write, []

    def late(*arguments: object, **options: object) -> object:
        made.append(keep(tmp_path / "out" / "assessment.json"))
        return write(*arguments, **options)  # type: ignore[arg-type]

    monkeypatch.setattr(outcome, "write", late)
    done = arcless("run", short, "--out", "out", "--no-report")
    assert done.exit_code == 2, done.stderr
    assert made[0].read_text() == "years of work\n"
    assert [path.name for path in (tmp_path / "out").iterdir()] == ["assessment.json"]


def test_a_folder_in_the_place_of_statics(
    arcless: Arcless, short: Path, tmp_path: Path, never: None
) -> None:
    thesis = keep(tmp_path / "out" / "statics.json")
    assert arcless("statics", short, "--out", "out").exit_code == 2
    plot = keep(tmp_path / "plot.html")
    assert arcless("statics", short, "--plot", "plot.html").exit_code == 2
    assert thesis.is_file() and plot.is_file()


def test_a_folder_in_the_place_of_a_report(
    arcless: Arcless, finished: Path, tmp_path: Path
) -> None:
    thesis = keep(tmp_path / "mine.html")
    done = arcless("report", finished / "result.nc", "--out", "mine.html")
    assert done.exit_code == 2
    assert thesis.is_file()
    assert [path.name for path in tmp_path.iterdir()] == ["mine.html"]


@pytest.mark.parametrize("words", [("--out", "x" * 300), ("--out", "new/" + "x" * 300)])
def test_names_too_long_leave_nothing(
    arcless: Arcless, short: Path, tmp_path: Path, words: tuple[str, str]
) -> None:
    done = arcless("run", short, "--quiet", *words)
    assert done.exit_code == 2, done.stderr
    assert ".arcless" not in done.stderr
    assert "File name too long" in done.stderr
    assert list(tmp_path.iterdir()) == []


def test_a_link_is_replaced_and_what_it_leads_to_stays(
    arcless: Arcless, short: Path, tmp_path: Path
) -> None:
    for name in ("result.nc", "assessment.json"):
        (tmp_path / f"other-{name}").write_text("mine\n")
        (tmp_path / "out").mkdir(exist_ok=True)
        (tmp_path / "out" / name).symlink_to(f"../other-{name}")
    words = ("run", short, "--out", "out", "--no-report", "--quiet")
    assert arcless(*words).exit_code == 2
    done = arcless(*words, "--overwrite")
    assert done.exit_code in (0, 3), done.stderr
    for name in ("result.nc", "assessment.json"):
        assert (tmp_path / f"other-{name}").read_text() == "mine\n"
        assert not (tmp_path / "out" / name).is_symlink()
