"""Builds for other systems: what is missing is named, what lies there is of one build, and what
wine lacks is written in C."""

import shutil
import sys
from pathlib import Path

import pytest
from cross import arm, packages, toolchain, windows
from cross.packages import put_packages, put_wheel, wheel_of
from cross.toolchain import MissingError, need, put_library, remove_old
from cross.wine_libraries import _MATH, _RUNTIME, _complex

from arcless.fmi.export.library import FOLDER, PLATFORMS


def test_a_missing_command_names_its_package(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(shutil, "which", lambda _: None)
    with pytest.raises(
        MissingError, match="`wine64` is missing; on Debian: apt-get install wine64"
    ):
        need("wine64", "wine64")


def test_a_command_that_is_there() -> None:
    assert need("sh", "dash") == shutil.which("sh")


def test_zig_that_is_missing_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(arm, "find_spec", lambda _: None)
    with pytest.raises(MissingError, match=r"zig is missing.*pip install ziglang cargo-zigbuild"):
        arm._zig()


@pytest.mark.parametrize("of", [arm, windows])
def test_libraries_lie_where_exports_look_for_them(of: object) -> None:
    assert isinstance(of, type(arm))
    assert PLATFORMS[of.PLATFORM].library == of.LIBRARY
    assert toolchain._OF_FMUS == FOLDER


def test_a_library_is_put_into_a_folder_of_its_own(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(toolchain, "ROOT", tmp_path)
    monkeypatch.setattr(toolchain, "_OF_FMUS", tmp_path / "libraries")
    made = tmp_path / "libmade.so"
    made.write_bytes(b"library")
    put_library(made, "aarch64-linux", "arcless_loop.so", "true")
    assert (tmp_path / "libraries/aarch64-linux/arcless_loop.so").read_bytes() == b"library"


def test_one_wheel_is_tried(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for module in (toolchain, packages):
        monkeypatch.setattr(module, "ROOT", tmp_path)
    dist = tmp_path / "dist"
    dist.mkdir()
    with pytest.raises(MissingError, match=r"dist/ has 0 wheels arcless-\*-win_amd64\.whl"):
        wheel_of("arcless-*-win_amd64.whl")
    kept = dist / "arcless-1-cp311-abi3-manylinux_2_28_x86_64.whl"
    for name in ("arcless-1-cp311-abi3-win_amd64.whl", "arcless-2-cp311-abi3-win_amd64.whl"):
        (dist / name).touch()
    kept.touch()
    with pytest.raises(MissingError, match="dist/ has 2 wheels"):
        wheel_of("arcless-*-win_amd64.whl")
    remove_old("arcless-*-win_amd64.whl")
    assert list(dist.iterdir()) == [kept]
    assert wheel_of("arcless-*_x86_64.whl") == kept


@pytest.fixture
def commands(monkeypatch: pytest.MonkeyPatch) -> list[tuple[str, ...]]:
    """List what is run from now on, instead of running it: pip has a wheel then."""
    asked: list[tuple[str, ...]] = []

    def note(*command: str, **_: object) -> None:
        asked.append(command)
        if "pip" in command:
            folder = Path(command[command.index("-d") + 1])
            folder.mkdir(parents=True)
            (folder / "numpy-2-cp313-cp313-win_amd64.whl").touch()

    monkeypatch.setattr(packages, "run", note)
    return asked


def test_packages_are_put_there_once(tmp_path: Path, commands: list[tuple[str, ...]]) -> None:
    site = tmp_path / "site"
    put_packages(site, ["win_amd64"], "3.13", extras=["fmi"], more=["pytest"])
    pip, unzip = commands
    assert pip[:3] == (sys.executable, "-m", "pip")
    assert pip[pip.index("--platform") + 1] == "win_amd64"
    assert pip[pip.index("--python-version") + 1] == "3.13"
    assert {"numpy>=2.0", "fmpy>=0.3.32", "pytest"} < set(pip)
    assert unzip == ("unzip", "-qo", str(tmp_path / "wheels" / "numpy-2-cp313-cp313-win_amd64.whl"),
                     "-d", str(site))  # fmt: skip
    put_packages(site, ["win_amd64"], "3.13", extras=["fmi"], more=["pytest"])
    assert len(commands) == 2
    put_packages(site, ["win_amd64"], "3.13", extras=["fmi"])  # others: all anew
    assert len(commands) == 4


def test_packages_that_are_not_completed_do_not_count(
    tmp_path: Path, commands: list[tuple[str, ...]]
) -> None:
    def stop() -> None:
        raise MissingError("`x86_64-w64-mingw32-gcc` is missing")

    for _ in range(2):
        with pytest.raises(MissingError, match="is missing"):
            put_packages(tmp_path / "site", ["win_amd64"], "3.13", then=stop)
    assert len(commands) == 4


def test_the_wheel_takes_the_place_of_an_earlier_one(
    tmp_path: Path, commands: list[tuple[str, ...]]
) -> None:
    for name in ("arcless", "arcless-1.dist-info", "numpy"):
        (tmp_path / name).mkdir()
    put_wheel(tmp_path / "arcless.whl", tmp_path)
    assert {path.name for path in tmp_path.iterdir()} == {"numpy"}
    assert commands == [("unzip", "-qo", str(tmp_path / "arcless.whl"), "-d", str(tmp_path))]


@pytest.mark.parametrize("names", [_MATH, _RUNTIME])
def test_names_are_exchanged_in_place(names: tuple[str, str]) -> None:
    assert len(names[0]) == len(names[1])


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("creal", "double my_creal(double complex z) { return creal(z); }"),
        ("creall", "double my_creall(double complex z) { return creal(z); }"),
        ("cabsf", "float my_cabsf(float complex z) { return cabsf(z); }"),
        ("csqrtf", "float complex my_csqrtf(float complex z) { return csqrtf(z); }"),
        ("_FCbuild", "float complex my__FCbuild(float a, float b) { return a + b * I; }"),
        ("ceil", None),
        ("cosf", None),
        ("cbrt", None),
    ],
)
def test_functions_of_complex_numbers(name: str, text: str | None) -> None:
    assert _complex(name) == text
