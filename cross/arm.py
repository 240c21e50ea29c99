"""The wheel for Linux on aarch64, built on Debian; the core's tests run under qemu.

python -m cross.arm [wheel] [core]
"""

import os
import shutil
import sys
from importlib.util import find_spec
from pathlib import Path

from cross.toolchain import (
    BUILD_STD,
    CARGO_OUT,
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
_OF_LINKER, _OF_RUNNER = (
    f"CARGO_TARGET_{TARGET.upper().replace('-', '_')}_{what}" for what in ("LINKER", "RUNNER")
)


def main(parts: list[str]) -> None:
    """Do what is asked for."""
    for part in parts or ["wheel", "core"]:
        {"wheel": wheel, "core": core}[part]()


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


if __name__ == "__main__":
    try:
        main(sys.argv[1:])
    except MissingError as error:
        sys.exit(f"make arm: {error}")
