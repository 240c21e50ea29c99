"""Changes that name a file: a model of the folder names its files in its own text, and only there.

A value that is set for a run is read as seen from the folder that the server was started in, which
may be any; and no question may lead out of the folder of the project.
"""

from collections.abc import Mapping
from typing import Any

from arcless.errors import ModelError
from arcless.model.files.csv_tables import COLUMNS, LISTS
from arcless.storage.shipped_files import shipped
from arcless.units import plain, show

# Last part of a field → kind of the model that it names; None: a file of another kind.
_NAMING: dict[str, str | None] = {
    "line": "line", "model": "pantograph", "base": "scenario", "file": None, "function": None,
    **dict.fromkeys((*LISTS, *COLUMNS)),
}  # fmt: skip


def check_named(changes: Mapping[str, Any]) -> None:
    """Refuse changes that name files.

    Raises
    ------
    ModelError
        A value names a file, and no shipped model.
    """
    for field, value in changes.items():
        _check(str(field), value)


def _check(field: str, value: Any) -> None:
    if isinstance(value, Mapping):
        for name, one in value.items():
            # The value of a mapping with a source is that of the field.
            _check(field if name == "value" else f"{field}.{name}", one)
    elif isinstance(value, list):
        for index, one in enumerate(value):
            _check(f"{field}.{index}", one)
    elif isinstance(value, str) and (last := field.rpartition(".")[2]) in _NAMING:
        kind = _NAMING[last]
        if kind is None or value not in shipped(kind):
            raise ModelError(
                plain(field), got=show(value),
                expected="no file" if kind is None else f"the name of a shipped {kind}",
                hint="name a file in the text of a model, not in a change",
            )  # fmt: skip
