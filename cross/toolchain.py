"""Debian's Rust compiler and the source of its library, unpacked below target/.

The compiler on this machine has the standard library of this system only. Debian's package
`rust-web-src` has its source, and `rustc-web` the compiler that it belongs to: with both cargo
builds the library for any other system (`-Zbuild-std`). The packages are unpacked and not
installed: another compiler may be installed here.
"""

import os
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parents[1]
UNPACKED = ROOT / "target" / "cross" / "rust"
CARGO_OUT = ROOT / "target" / "cross" / "cargo"
# Their dependencies carry versions in their names: they are asked for.
_FIRST = ("rustc-web", "rust-web-src", "libstd-rust-web-dev")
_BELONG = ("libstd-rust-web-", "libllvm")
# Given to cargo after `-Z`: parts of the standard library that are built with the crates.
BUILD_STD = "build-std=std,panic_unwind"
# Folder of the libraries that FMUs carry, by platform; `arcless.fmi.export.library` reads it.
_OF_FMUS = ROOT / "python" / "arcless" / "fmi" / "libraries"


class MissingError(Exception):
    """Something is not on this machine: the message says what, and how it comes there."""


def need(command: str, package: str) -> str:
    """Return the path of a command, or say which package of Debian has it."""
    found = shutil.which(command) or shutil.which(f"/usr/lib/wine/{command}")
    if found is None:
        raise MissingError(f"`{command}` is missing; on Debian: apt-get install {package}")
    return found


def unpacked() -> dict[str, str]:
    """Unpack the compiler where it is not yet; return the environment that builds with it."""
    for command, package in (("apt-get", "apt"), ("dpkg", "dpkg"), ("cargo", "cargo")):
        need(command, package)
    usr = UNPACKED / "usr"
    if not (usr / "bin" / "rustc").exists():
        _unpack()
    libraries = [usr / "lib" / "x86_64-linux-gnu", *sorted((usr / "lib").glob("llvm-*/lib"))]
    environment = {name: value for name, value in os.environ.items() if name != "PYO3_PYTHON"}
    return environment | {
        "LD_LIBRARY_PATH": os.pathsep.join(str(place) for place in libraries),
        "RUSTC": str(usr / "bin" / "rustc"),
        "RUSTC_BOOTSTRAP": "1",  # building the library is not stable
        "CARGO_TARGET_DIR": str(CARGO_OUT),
        "PYO3_CROSS_PYTHON_VERSION": "3.11",
    }


def put_library(made: Path, platform: str, name: str, strip: str) -> None:
    """Put a library that FMUs carry next to those of other platforms, without symbols.

    Parameters
    ----------
    made
        The library as cargo made it.
    platform, name
        Its folder, and its name there.
    strip
        Command that strips it.
    """
    run(strip, str(made))
    folder = _OF_FMUS / platform
    folder.mkdir(parents=True, exist_ok=True)
    shutil.copyfile(made, folder / name)
    print(f"wrote {(folder / name).relative_to(ROOT)}", file=sys.stderr)


def remove_old(pattern: str) -> None:
    """Remove wheels of earlier builds from dist/: one is there after a build, the new one."""
    for old in (ROOT / "dist").glob(pattern):
        old.unlink()


def run(*command: str, environment: dict[str, str] | None = None, folder: Path = ROOT) -> None:
    """Run a command, whose output is shown; end with its exit code where it fails.

    Its streams are pipes: CPython of Windows does not start under wine without.
    """
    print("$", *command, file=sys.stderr, flush=True)
    with subprocess.Popen(
        command, cwd=folder, env=environment, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
    ) as process:  # fmt: skip
        assert process.stdout is not None
        for line in process.stdout:
            sys.stdout.buffer.write(line)
            sys.stdout.buffer.flush()
    if process.returncode:
        sys.exit(process.returncode)


def text_of(*command: str) -> str:
    """Return what a command prints; end with its exit code where it fails."""
    done = subprocess.run(command, capture_output=True, encoding="utf-8", check=False)
    if done.returncode:
        sys.exit(done.stderr)
    return done.stdout


def _unpack() -> None:
    names = [*_FIRST, *sorted(_dependencies())]
    fresh = UNPACKED.with_name("unpacking")
    shutil.rmtree(fresh, ignore_errors=True)
    fresh.mkdir(parents=True)
    print(f"Unpacking {', '.join(names)} into {UNPACKED.relative_to(ROOT)}", file=sys.stderr)
    done = subprocess.run(["apt-get", "download", "-q", *names], cwd=fresh, check=False)
    if done.returncode:
        raise MissingError(
            "packages of Debian cannot be downloaded; is `apt-get update` to be run?"
        )
    for package in fresh.glob("*.deb"):
        run("dpkg", "-x", str(package), ".", folder=fresh)
        package.unlink()
    shutil.rmtree(UNPACKED, ignore_errors=True)
    fresh.rename(UNPACKED)


def _dependencies() -> set[str]:
    found: set[str] = set()
    ask = [_FIRST[0]]
    while ask:
        asked = ["apt-cache", "depends", ask.pop()]
        done = subprocess.run(asked, capture_output=True, encoding="utf-8", check=False)
        named = {line.split()[-1] for line in done.stdout.splitlines() if " Depends: " in line}
        new = {name for name in named if name.startswith(_BELONG)} - found
        found |= new
        ask += sorted(name for name in new if name.startswith(_BELONG[0]))
    if not any(name.startswith(_BELONG[1]) for name in found):
        raise MissingError("no package `rustc-web` is known; Debian 12 has it: apt-get update")
    return found - set(_FIRST)
