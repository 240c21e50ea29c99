"""Measured runs that are dropped onto the page: kept as files of the folder."""

import os
import re
from collections.abc import AsyncIterator
from pathlib import Path

from anyio.to_thread import run_sync

from arcless.errors import OutputError
from arcless.measurements.table.dialect import LARGEST_FILE
from arcless.platforms.file_names import refused_by_windows
from arcless.storage.whole_files import replacing
from arcless.studio.project.project import Project
from arcless.units import show

FOLDER = "measured"
ENDING = ".csv"
# Most bytes that the reader of measured runs takes.
LONGEST = LARGEST_FILE
_NAME = re.compile(r"[\w][\w .,()+=@-]{0,120}", re.ASCII)


async def keep(project: Project, name: str, pieces: AsyncIterator[bytes]) -> str:
    """Keep a CSV file as it comes, whole or not at all, and return its path in the project.

    Parameters
    ----------
    project
        The project.
    name
        Name of the file, which ends in .csv. One that is there stays; a number is added.
    pieces
        Its bytes.

    Raises
    ------
    OutputError
        The name is none, or the file cannot be written.
    """
    if not (name.lower().endswith(ENDING) and _NAME.fullmatch(name)):
        expected = "letters, digits, blanks and - _ . , ( ) + = @, with .csv at the end"
        raise OutputError("no name for a measured run", got=show(name), expected=expected)
    if (trouble := refused_by_windows(name)) is not None:
        raise OutputError("no name for a measured run", got=trouble, expected="another name")
    folder = await run_sync(_folder, project)
    file = await run_sync(_free, folder, name)
    with replacing(file) as new:
        async for piece in pieces:
            await run_sync(new.write, piece)
    return project.name_of(file)


def _folder(project: Project) -> Path:
    folder = project.folder / FOLDER
    try:
        folder.mkdir(exist_ok=True)
    except OSError as error:
        raise OutputError.of(error, "the folder cannot be made", FOLDER) from error
    return project.inside(FOLDER)  # refused where it is a link that leads out


def _free(folder: Path, name: str) -> Path:
    stem, number = name[: -len(ENDING)], 1
    file = folder / name
    while os.path.lexists(file):
        number += 1
        file = folder / f"{stem} ({number}){ENDING}"
    return file
