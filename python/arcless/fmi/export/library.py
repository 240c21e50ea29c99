"""The compiled library that an FMU carries, and its header for C."""

from dataclasses import dataclass
from pathlib import Path

from arcless.errors import OutputError
from arcless.storage.whole_files import write_bytes

FOLDER = Path(__file__).parents[1] / "libraries"
HEADER = "arcless_loop.h"


@dataclass(frozen=True)
class Platform:
    """A platform: folders of FMI 2.0 and 3.0, name of the library in them and for C."""

    fmi2: str
    fmi3: str
    library: str
    for_c: str


# By the folder that the build puts the library in.
PLATFORMS = {
    "x86_64-linux": Platform("linux64", "x86_64-linux", "arcless_loop.so", "libarcless_loop.so"),
    # FMI 2.0 names no folder for it; importers take that of 3.0.
    "aarch64-linux": Platform(
        "aarch64-linux", "aarch64-linux", "arcless_loop.so", "libarcless_loop.so"
    ),
    "x86_64-windows": Platform("win64", "x86_64-windows", "arcless_loop.dll", "arcless_loop.dll"),
}


def libraries() -> dict[str, Path]:
    """Return the libraries that are here by their platforms.

    Raises
    ------
    OutputError
        There is none.
    """
    paths = {name: FOLDER / name / of.library for name, of in PLATFORMS.items()}
    found = {name: path for name, path in paths.items() if path.is_file()}
    if not found:
        raise OutputError(
            "the library that an FMU carries is missing",
            where=str(FOLDER),
            expected=" or ".join(f"{name}/{of.library}" for name, of in PLATFORMS.items()),
            hint="it comes with the wheel; in a checkout `make build` compiles it",
        )
    return found


def copy_library(folder: str | Path) -> list[Path]:
    """Copy the libraries and the header of the C interface into a folder; return what is there.

    Parameters
    ----------
    folder
        A folder that exists; files of the same names are replaced.

    Raises
    ------
    OutputError
        There is no library, or it cannot be written there.
    """
    written = []
    for name, path in libraries().items():
        target = Path(folder) / PLATFORMS[name].for_c
        if target in written:  # of another processor, under the same name
            target = target.with_name(f"{name}-{target.name}")
        write_bytes(target, path.read_bytes())
        written.append(target)
    header = Path(folder) / HEADER
    write_bytes(header, (FOLDER / HEADER).read_bytes())
    return [*written, header]
