"""FMUs that a model file names: found from its folder, checked, and known by their digest."""

from collections.abc import Mapping
from pathlib import Path as FilePath
from typing import Any

from pydantic import ValidationError

from arcless.errors import ModelError
from arcless.model.fields.document import printed
from arcless.model.fields.part import Path
from arcless.model.files.yaml_reader import Origin, is_file
from arcless.model.fmu.checks import checked, digest_of
from arcless.model.fmu.mapping import PantographFmu

FIELD = "fmu"


def with_fmu(data: Mapping[str, Any], origin: Origin, prefix: Path) -> dict[str, Any]:
    """Return the data of a pantograph with the place and the digest of its FMU.

    An FMU that a model file names is checked by its description; none of its code is loaded.

    Raises
    ------
    ModelError
        There is no such file, or the pantograph cannot be that FMU.
    """
    given = data.get(FIELD)
    own = {"file": given} if isinstance(given, str) else given
    name = _plain(own.get("file")) if isinstance(own, Mapping) else None
    if not isinstance(own, Mapping) or not isinstance(name, str):
        return dict(data)
    path = (*prefix, FIELD)
    file = origin.file(name)
    found = {**own, "file": _again(own["file"], file.as_posix())}
    if origin.label is not None:
        _check(found, file, origin, path)
    if own.get("sha256") is None and is_file(file):
        found["sha256"] = digest_of(file)
    return {**data, FIELD: found}


def _check(data: Mapping[str, Any], file: FilePath, origin: Origin, path: Path) -> None:
    """Check the FMU of a model file; what is wrong with the fields themselves is said later."""
    plain = {key: _plain(value) for key, value in data.items()}
    try:
        fmu = PantographFmu.model_validate(plain)
    except ValidationError:
        return
    try:
        checked(fmu, file)
    except ModelError as error:
        field = (*path, *(error.field or ("file",)))
        where = origin.where(field)
        error.what = f"{printed(field)}: {error.what}"
        named = error.where
        error.where = where if named is None or where is None else f"{where} ({named})"
        error.field = field
        raise


def _plain(value: Any) -> Any:
    """Return a value without its provenance."""
    return value["value"] if isinstance(value, Mapping) and "value" in value else value


def _again(given: Any, value: str) -> Any:
    """Return a value in the form that was given, with its provenance where it had one."""
    return {**given, "value": value} if isinstance(given, Mapping) else value
