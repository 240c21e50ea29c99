"""Modules that a command loads before it answers; times would wobble."""

import gc
import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest
from typer.testing import Result

SLOW = {"xarray", "scipy", "bokeh", "h5netcdf", "h5py", "pandas", "matplotlib"}
SHORT = Path(__file__).parent / "data" / "short.yaml"
# What runs many, one in real time, or only reads the line at rest.
OF_OTHERS = {f"arcless.simulate.{name}" for name in ("batches", "session", "resonance")}
COMMAND = (
    "from arcless.cli import main\n"
    "try:\n    main()\nexcept SystemExit as leave:\n    assert not leave.code, leave.code\n"
)


def told_by(script: str, *words: object, **environment: str) -> list[str]:
    """Return the words that a script, called with a command line, writes to standard error."""
    done = subprocess.run(
        [sys.executable, "-c", script, *map(str, words)],
        capture_output=True,
        text=True,
        timeout=60,
        check=True,
        env={**os.environ, **environment},
    )
    return done.stderr.split()


def modules_of(*words: object) -> set[str]:
    """Return the modules that one command line imports."""
    return set(told_by(f"import sys\n{COMMAND}print(*sys.modules, file=sys.stderr)", *words))


def loaded_by(*words: object) -> set[str]:
    """Return the top-level packages that one command line imports."""
    return {name.partition(".")[0] for name in modules_of(*words)}


def test_help_loads_nothing_slow() -> None:
    assert not loaded_by("--help") & (SLOW | {"numpy", "pydantic", "yaml"})


@pytest.mark.parametrize("words", [("check", SHORT), ("library",), ("schema",), ("show", SHORT)])
def test_commands_on_model_files_load_nothing_slow(words: tuple[object, ...]) -> None:
    assert not loaded_by(*words) & SLOW


def test_a_run_without_a_report_loads_no_more_than_it_needs(tmp_path: Path) -> None:
    words = ("run", SHORT, "--no-report", "--quiet", "--out", tmp_path, "--until", "70 m")
    modules = modules_of(*words)
    # Results are files of HDF5; splines of SciPy are for heads and irregular tracks alone.
    assert not {name.partition(".")[0] for name in modules} & (SLOW - {"h5py"})
    assert not modules & (OF_OTHERS | {"numpy.ma"})


def test_a_report_loads_no_classes_of_bokeh(tmp_path: Path) -> None:
    loaded = loaded_by("run", SHORT, "--quiet", "--out", tmp_path)
    assert (tmp_path / "report.html").exists()
    assert not loaded & (SLOW - {"h5py"})


def test_published_ranges_load_no_other_suite() -> None:
    script = "import sys, arcless.validate\nprint(*sys.modules, file=sys.stderr)"
    assert not {"arcless.validate.founding_paper", "arcless.validate.evidence"} & set(
        told_by(script)
    )


@pytest.mark.parametrize("first", ["batches.groups", "session.realtime", "resonance.spans"])
def test_no_module_hides_the_function_of_its_name(first: str) -> None:
    script = (
        f"import sys, arcless.simulate.{first}\nfrom arcless import simulate\n"
        "for name in simulate.__all__:\n    print(type(getattr(simulate, name)).__name__, "
        "file=sys.stderr)"
    )
    assert "module" not in told_by(script)


@pytest.mark.parametrize("package", ["simulate", "validate"])
def test_a_package_has_all_of_its_names_and_no_other(package: str) -> None:
    script = (
        f"import sys\nfrom arcless import {package} as given\n"
        "for name in given.__all__:\n    assert getattr(given, name) is not None, name\n"
        "try:\n    given.nothing\nexcept AttributeError as error:\n"
        "    print(error, file=sys.stderr)"
    )
    assert told_by(script)[-1] == "`nothing`"


def test_what_a_command_imports_is_not_searched_for_garbage() -> None:
    ask = "import gc, sys\nprint(gc.get_freeze_count() > 10_000, gc.isenabled(), file=sys.stderr)"
    assert told_by(COMMAND + ask, "check", SHORT)[-2:] == ["True", "True"]


def test_in_the_process_of_somebody_else_nothing_stays(arcless: Callable[..., Result]) -> None:
    before = gc.get_freeze_count()
    assert arcless("check", SHORT).exit_code == 0
    assert gc.get_freeze_count() == before


@pytest.mark.parametrize(("given", "taken"), [({}, "1"), ({"OPENBLAS_NUM_THREADS": "2"}, "2")])
def test_who_sets_a_number_of_threads_gets_it(
    given: dict[str, str], taken: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delenv("OPENBLAS_NUM_THREADS", raising=False)
    ask = "import os, sys\nprint(os.environ['OPENBLAS_NUM_THREADS'], file=sys.stderr)"
    assert told_by(COMMAND + ask, "--help", **given)[-1] == taken
