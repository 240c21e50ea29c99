"""What a command loads before it answers, measured in modules because times wobble."""

import subprocess
import sys
from pathlib import Path

import pytest

SLOW = {"xarray", "scipy", "bokeh", "h5netcdf", "h5py", "pandas", "matplotlib"}
SHORT = Path(__file__).parent / "data" / "short.yaml"


def loaded_by(*words: object) -> set[str]:
    """Return the top-level packages that one command line imports."""
    script = (
        "import sys\nfrom arcless.cli import main\n"
        "try:\n    main()\nexcept SystemExit as leave:\n    assert not leave.code, leave.code\n"
        "print(*sys.modules, file=sys.stderr)"
    )
    done = subprocess.run(
        [sys.executable, "-c", script, *map(str, words)],
        capture_output=True,
        text=True,
        timeout=60,
        check=True,
    )
    return {name.partition(".")[0] for name in done.stderr.split()}


def test_help_loads_nothing_slow() -> None:
    assert not loaded_by("--help") & (SLOW | {"numpy", "pydantic", "ruamel"})


@pytest.mark.parametrize("words", [("check", SHORT), ("library",), ("schema",)])
def test_commands_on_model_files_load_nothing_slow(words: tuple[object, ...]) -> None:
    assert not loaded_by(*words) & SLOW


def test_a_run_without_a_report_loads_no_more_than_it_needs(tmp_path: Path) -> None:
    words = ("run", SHORT, "--no-report", "--quiet", "--out", tmp_path, "--until", "70 m")
    # Results are files of HDF5; splines of SciPy are for heads and irregular tracks alone.
    assert not loaded_by(*words) & (SLOW - {"h5py"})
