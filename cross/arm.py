"""The wheel for Linux on aarch64, built on Debian; the core's tests run under qemu.

python -m cross.arm [wheel] [core]
"""

import sys

from cross.toolchain import MissingError, need, run, unpacked

TARGET = "aarch64-unknown-linux-gnu"
GLIBC = "manylinux_2_28"
_BUILD_STD = "build-std=std,panic_unwind"
_OF_LINKER, _OF_RUNNER = (
    f"CARGO_TARGET_{TARGET.upper().replace('-', '_')}_{what}" for what in ("LINKER", "RUNNER")
)


def main(parts: list[str]) -> None:
    """Do what is asked for."""
    for part in parts or ["wheel", "core"]:
        {"wheel": wheel, "core": core}[part]()


def wheel() -> None:
    """Make the wheel; zig links it against glibc 2.28."""
    run(
        sys.executable, "-m", "maturin", "build", "--release", "--strip", "--target", TARGET,
        "--zig", "--compatibility", GLIBC, "-Z", _BUILD_STD, "--out", "dist",
        environment=unpacked(),
    )  # fmt: skip


def core() -> None:
    """Run the tests of the numerical core under qemu."""
    libraries = "/usr/aarch64-linux-gnu"
    environment = unpacked() | {
        _OF_LINKER: need("aarch64-linux-gnu-gcc", "gcc-aarch64-linux-gnu"),
        _OF_RUNNER: f"{need('qemu-aarch64', 'qemu-user')} -L {libraries}",
    }
    run(
        "cargo", "test", "-p", "arcless-core", "--target", TARGET, "-Z", _BUILD_STD,
        environment=environment,
    )  # fmt: skip


if __name__ == "__main__":
    try:
        main(sys.argv[1:])
    except MissingError as error:
        sys.exit(f"make arm: {error}")
