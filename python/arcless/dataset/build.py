"""Arrays of a run → described variables and attributes, checked against the one table."""

import json
from collections.abc import Collection, Mapping
from datetime import UTC, datetime
from difflib import get_close_matches
from typing import Any

import numpy as np
from numpy.typing import NDArray

from arcless.dataset.schema import (
    ATTRIBUTES,
    DIMENSIONS,
    RESULT_FORMAT,
    VARIABLES,
    Variable,
    sizes_of,
)
from arcless.errors import ResultFormatError

Entry = tuple[tuple[str, ...], NDArray[Any], dict[str, str]]
Described = dict[str, Entry]


def variables(given: Mapping[str, Any], names: Mapping[str, Any]) -> tuple[Described, Described]:
    """Return variables and the coordinates they use: dimensions, values, unit and meaning.

    Raises
    ------
    ResultFormatError
        As `dataset_from`, but none has to be there.
    """
    arrays = _arrays(given)
    coords = _coordinates(names, sizes_of({name: a.shape for name, a in arrays.items()}))
    data: Described = {}
    for name, array in arrays.items():
        variable = VARIABLES[name]
        _check_shape(name, variable, array, coords)
        if array.size:
            check_finite(name, variable, array, coords)
            meaning = {"units": variable.units, "long_name": variable.long_name}
            data[name] = (variable.dims, array, meaning)
    used = {dim for dims, _, _ in data.values() for dim in dims}
    return data, {dim: _coordinate(dim, coords[dim]) for dim in coords if dim in used}


def check_complete(names: Collection[str]) -> None:
    """Refuse a record that lacks a required variable."""
    if missing := missing_variables(names):
        raise ResultFormatError("the record of the run is incomplete", expected=", ".join(missing))


def missing_variables(present: Any) -> list[str]:
    """Return the required variables that are not among the given names."""
    return [n for n, variable in VARIABLES.items() if variable.required and n not in present]


def nearest_hint(name: str, known: Any) -> str | None:
    """Return a hint with the known name most like this one, if any is."""
    match = get_close_matches(name, list(known), n=1)
    return f"did you mean {match[0]}?" if match else None


def _arrays(given: Mapping[str, Any]) -> dict[str, NDArray[Any]]:
    for name in given:
        if name not in VARIABLES:
            hint = nearest_hint(name, VARIABLES)
            raise ResultFormatError("a variable of the result is not known", got=name, hint=hint)
    return {
        name: np.asarray(given[name], dtype=_type_of(variable))
        for name, variable in VARIABLES.items()
        if name in given
    }


def _type_of(variable: Variable) -> type[np.generic]:
    if variable.integer:
        return np.int64
    return np.float32 if variable.single else np.float64


def _coordinates(names: Mapping[str, Any], sizes: dict[str, int]) -> dict[str, NDArray[Any]]:
    for dim in names:
        if dim not in DIMENSIONS:
            hint = nearest_hint(dim, DIMENSIONS)
            raise ResultFormatError("a dimension of the result is not known", got=dim, hint=hint)
    coords: dict[str, NDArray[Any]] = {}
    for dim, size in sizes.items():
        kind = DIMENSIONS[dim].kind
        if dim in names:
            values = np.asarray(names[dim], dtype=None if kind == "name" else np.float64)
            coords[dim] = values.astype(np.int64) if kind == "count" else values
        elif kind == "count":
            coords[dim] = np.arange(1, size + 1)
        else:
            raise ResultFormatError("a dimension of the result has no labels", where=dim)
        if kind == "number" and np.any(~(np.diff(coords[dim]) > 0)):
            raise ResultFormatError("a coordinate does not increase", where=dim)
    return coords


def _coordinate(dim: str, values: NDArray[Any]) -> Entry:
    entry = DIMENSIONS[dim]
    labels = values.astype(object) if entry.kind == "name" else values
    return (dim,), labels, {"units": entry.units, "long_name": entry.long_name}


def _check_shape(
    name: str, variable: Variable, array: NDArray[Any], coords: Mapping[str, NDArray[Any]]
) -> None:
    expected = tuple(len(coords[dim]) if dim in coords else -1 for dim in variable.dims)
    if array.shape != expected:
        raise ResultFormatError(
            "a variable has the wrong shape",
            where=name,
            got=str(array.shape),
            expected=f"{expected} = ({', '.join(variable.dims)})",
        )


def check_finite(
    name: str, variable: Variable, array: NDArray[Any], coords: Mapping[str, NDArray[Any]]
) -> None:
    """Refuse an array with a value that is not finite where the table of variables allows none."""
    bad = ~np.isfinite(array)
    if variable.padded:
        bad &= ~np.all(np.isnan(array), axis=0)
    if variable.absent:
        bad &= ~np.isnan(array)
    if not bad.any():
        return
    first = np.unravel_index(int(np.argmax(bad)), array.shape)
    place = ", ".join(
        f"{dim} {coords[dim][i]}" for dim, i in zip(variable.dims, first, strict=True)
    )
    raise ResultFormatError(
        "the run produced a value that is not a finite number",
        where=f"{name} at {place}",
        got=str(array[first]),
        expected=f"a finite value in {variable.units}",
    )


def attributes(given: Mapping[str, Any]) -> dict[str, Any]:
    """Return the attributes as they are stored.

    Raises
    ------
    ResultFormatError
        A name is unknown, a required one missing, or a value is not finite.
    """
    attrs = {
        "format": RESULT_FORMAT,
        "created": datetime.now(UTC).isoformat(timespec="seconds"),
        **{name: value for name, value in given.items() if value is not None},
    }
    for name in attrs:
        if name not in ATTRIBUTES:
            hint = nearest_hint(name, ATTRIBUTES)
            raise ResultFormatError("an attribute of the result is not known", got=name, hint=hint)
    missing = [n for n, entry in ATTRIBUTES.items() if entry.required and n not in attrs]
    if missing:
        raise ResultFormatError("attributes of the result are missing", expected=", ".join(missing))
    return {name: _stored(name, attrs[name]) for name in ATTRIBUTES if name in attrs}


def _stored(name: str, value: Any) -> str | int | float:
    kind = ATTRIBUTES[name].kind
    if kind == "integer":
        return int(value)
    if kind == "number" and np.isfinite(value):
        return float(value)
    if kind == "text" or (kind == "json" and isinstance(value, str)):
        return str(value)
    try:  # JSON refuses what is not finite, in a list as well as alone
        return json.dumps(value, ensure_ascii=False, allow_nan=False)
    except ValueError as error:
        what = "an attribute holds a value that is not a finite number"
        raise ResultFormatError(what, where=name, got=str(value)[:80]) from error
