"""A variant of a scenario as a file that holds only what differs."""

import re
from collections.abc import Mapping
from typing import Any

from arcless.errors import OutputError
from arcless.model.load import load_text
from arcless.model.variants.variant_files import variant_text
from arcless.platforms.file_names import refused_by_windows
from arcless.storage.shipped_files import shipped
from arcless.studio.answers.answers import Refused
from arcless.studio.project import texts
from arcless.studio.project.project import Project, is_shipped
from arcless.units import show

_NAME = re.compile(r"[\w][\w .+=-]{0,80}")
_BAD_REQUEST = 400


def make(project: Project, scenario: object, name: object, changes: object) -> str:
    """Write a variant next to its base, and return its path in the project.

    Parameters
    ----------
    project
        The project.
    scenario
        Path of the base.
    name
        Name of the variant, which is that of its file.
    changes
        Fields that differ, by dotted path, values as typed.

    Raises
    ------
    ModelError
        The variant is no valid scenario.
    OutputError
        The name is none that a file can have, or is taken.
    """
    if not (isinstance(scenario, str) and isinstance(name, str) and isinstance(changes, Mapping)):
        raise Refused(_BAD_REQUEST, "A variant needs a scenario, a name and changes")
    if not _NAME.fullmatch(name) or name in shipped("scenario"):
        expected = "letters, digits, blanks, - _ . + =, and not the name of a shipped scenario"
        raise OutputError("no name for a scenario", got=show(name), expected=expected)
    if (trouble := refused_by_windows(f"{name}.yaml")) is not None:
        raise OutputError("no name for a scenario", got=trouble, expected="another name")
    base = texts.model_file(project, scenario)
    folder, named = project.folder, scenario.rpartition("/")[2]
    if not is_shipped(scenario):
        folder = base.parent
        named = base.name
    path = project.name_of(folder / f"{name}.yaml")
    text = variant_text(name, named, _plain(changes))
    load_text(text, folder / f"{name}.yaml", project.folder)
    texts.write(project, path, text, None)
    return path


def _plain(changes: Mapping[Any, Any]) -> dict[str, Any]:
    return {str(field): value for field, value in changes.items()}
