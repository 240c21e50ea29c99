"""Where runs of a project are."""

from pathlib import Path

from arcless.errors import OutputError
from arcless.results.kept_runs.places import result_file
from arcless.studio.answers.answers import Refused
from arcless.studio.project.project import Project
from arcless.units import show


def run_of(project: Project, path: object) -> Path:
    """Return the result file of a run below the folder, named by its folder or its file.

    Raises
    ------
    OutputError, Refused
        There is none.
    """
    if not isinstance(path, str):
        raise OutputError("no run", got=show(path), expected="the path of a run")
    file = result_file(project.inside(path))
    # The file itself may be a link that leads out.
    file = project.inside(project.name_of(file))
    if file.suffix != ".nc" or not file.is_file():
        raise Refused(404, f"there is no run {path}")
    return file
