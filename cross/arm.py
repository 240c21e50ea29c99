"""The wheel for Linux on aarch64, built on Debian; the core's tests and the wheel run under qemu.

    python -m cross.arm [wheel] [core] [try]

`wheel` makes dist/arcless-*_aarch64.whl, `core` runs the tests of the numerical core, `try` unpacks
the wheel for Debian's CPython of aarch64 and runs `tests/interface/check_wheel.py` with it.
"""

import os
import shutil
import sys
from importlib.util import find_spec
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

TARGET = "aarch64-unknown-linux-gnu"
PLATFORM, LIBRARY = "aarch64-linux", "arcless_loop.so"
GLIBC = "2.28"
_TAG = f"manylinux_{GLIBC.replace('.', '_')}"
_UNDER_QEMU = ROOT / "target" / "cross" / "arm"
_FORCES = _UNDER_QEMU / "forces.npy"
# Debian 12's Python, what it loads, and tags of wheels that its C library takes.
_PYTHON = "python3.11"
_OF_DEBIAN = (
    f"{_PYTHON}-minimal", f"lib{_PYTHON}-minimal", f"lib{_PYTHON}-stdlib", "libc6", "libgcc-s1",
    "libstdc++6", "zlib1g", "libexpat1", "libffi8", "libssl3", "libbz2-1.0", "liblzma5",
    "libsqlite3-0", "libuuid1", "libcrypt1",
)  # fmt: skip
_TAGS = ("manylinux_2_28_aarch64", "manylinux_2_17_aarch64", "manylinux2014_aarch64")
_OF_LINKER, _OF_RUNNER = (
    f"CARGO_TARGET_{TARGET.upper().replace('-', '_')}_{what}" for what in ("LINKER", "RUNNER")
)


def main(parts: list[str]) -> None:
    """Do what is asked for."""
    for part in parts or ["wheel", "core", "try"]:
        {"wheel": wheel, "core": core, "try": try_wheel}[part]()


def wheel() -> None:
    """Make the wheel, with the library of FMUs in it; zig links both against glibc 2.28."""
    environment = unpacked() | _zig()
    remove_old("arcless-*_aarch64.whl")
    run(
        "cargo", "zigbuild", "--release", "-p", "arcless-ffi", "--target", f"{TARGET}.{GLIBC}",
        "-Z", BUILD_STD, environment=environment,
    )  # fmt: skip
    made = CARGO_OUT / TARGET / "release" / f"lib{LIBRARY}"
    strip = need("aarch64-linux-gnu-strip", "binutils-aarch64-linux-gnu")
    put_library(made, PLATFORM, LIBRARY, strip)
    run(
        sys.executable, "-m", "maturin", "build", "--release", "--strip", "--target", TARGET,
        "--zig", "--compatibility", _TAG, "-Z", BUILD_STD, "--out", "dist",
        environment=environment,
    )  # fmt: skip


def _zig() -> dict[str, str]:
    """Return the environment in which cargo and maturin find zig, which is a package of PyPI."""
    path = os.pathsep.join((str(Path(sys.executable).parent), os.environ.get("PATH", os.defpath)))
    if find_spec("ziglang") is None or shutil.which("cargo-zigbuild", path=path) is None:
        raise MissingError(
            "zig is missing, which links the wheel: pip install ziglang cargo-zigbuild"
        )
    return {"PATH": path}


def core() -> None:
    """Run the tests of the numerical core under qemu."""
    libraries = "/usr/aarch64-linux-gnu"
    environment = unpacked() | {
        _OF_LINKER: need("aarch64-linux-gnu-gcc", "gcc-aarch64-linux-gnu"),
        _OF_RUNNER: f"{need('qemu-aarch64', 'qemu-user')} -L {libraries}",
    }
    run(
        "cargo", "test", "-p", "arcless-core", "--target", TARGET, "-Z", BUILD_STD,
        environment=environment,
    )  # fmt: skip


def try_wheel() -> None:
    """Run the wheel with Debian's CPython of aarch64 under qemu."""
    wheel = wheel_of("arcless-*_aarch64.whl")
    system = _system()
    site = _UNDER_QEMU / "site"
    put_packages(site, _TAGS, _PYTHON.removeprefix("python"))
    put_wheel(wheel, site)
    put_down_forces(_FORCES)
    run(
        need("qemu-aarch64", "qemu-user"), "-L", str(system), "-E", f"PYTHONPATH={site}",
        str(system / "usr" / "bin" / _PYTHON), str(ROOT / "tests" / "interface" / "check_wheel.py"),
        str(ROOT), str(_FORCES), folder=_UNDER_QEMU,
    )  # fmt: skip


def _system() -> Path:
    """Return Debian's CPython and its libraries for aarch64, unpacked where they are not yet."""
    system, fresh = _UNDER_QEMU / "system", _UNDER_QEMU / "unpacking"
    if system.exists():
        return system
    lists = _UNDER_QEMU / "lists"
    shutil.rmtree(fresh, ignore_errors=True)
    fresh.mkdir(parents=True)
    (lists / "partial").mkdir(parents=True, exist_ok=True)
    apt = [need("apt-get", "apt"), "-q", "-oAPT::Architecture=arm64", "-oAPT::Architectures=arm64"]
    apt.append(f"-oDir::State::Lists={lists}")
    run(*apt, "update")
    run(*apt, "download", *_OF_DEBIAN, folder=fresh)
    for package in fresh.glob("*.deb"):
        run("dpkg", "-x", str(package), ".", folder=fresh)
        package.unlink()
    fresh.rename(system)
    return system


if __name__ == "__main__":
    try:
        main(sys.argv[1:])
    except MissingError as error:
        sys.exit(f"make arm: {error}")
