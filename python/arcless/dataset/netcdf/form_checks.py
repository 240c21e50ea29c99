"""Checks of the form of all that is read from a result file.

The checksum of a file tells of damage, not of who made it: a file may be sealed by anyone.
"""

from collections.abc import Callable, Mapping
from math import isfinite
from typing import Any

import numpy as np

from arcless.dataset.build import Entry, check_finite
from arcless.dataset.schema import DIMENSIONS, VARIABLES
from arcless.errors import ResultFormatError


def check_entry(name: str, entry: Entry, sizes: Mapping[str, int], file: object) -> None:
    """Refuse a variable or coordinate of another form than the tables of results give it.

    Parameters
    ----------
    name, entry
        Its name, and what was read. Names that the tables do not have are of nobody's use.
    sizes
        Number of labels of each dimension that has labels.

    Raises
    ------
    ResultFormatError
        Its dimensions or sizes are others, it holds no numbers, or one that is not finite.
    """
    dims, values, _ = entry
    expected: tuple[str, ...]
    if name in DIMENSIONS:
        expected, is_text = (name,), DIMENSIONS[name].kind == "name"
    elif name in VARIABLES:
        expected, is_text = VARIABLES[name].dims, False
    else:
        return
    found = tuple(sizes.get(dim, length) for dim, length in zip(dims, values.shape, strict=False))
    if dims != expected or values.shape != found:
        raise ResultFormatError(
            "a variable of the result file has the wrong shape",
            where=f"{file}: {name}",
            got=f"{values.shape} = ({', '.join(dims)})",
            expected=f"({', '.join(expected)})",
        )
    if not is_text and values.dtype.kind not in "fiu":
        raise ResultFormatError(
            "a variable of the result file holds no numbers",
            where=f"{file}: {name}",
            got=str(values.dtype),
        )
    if name in VARIABLES:
        labels = {dim: np.arange(length) for dim, length in zip(dims, values.shape, strict=True)}
        try:
            check_finite(name, VARIABLES[name], values, labels)
        except ResultFormatError as error:
            error.what = "the result file holds a value that is not a finite number"
            error.where = f"{file}: {error.where}"
            raise


def _is_number(value: object) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool) and isfinite(value)


def _is_section(value: object) -> bool:
    return isinstance(value, list) and len(value) == 2 and all(map(_is_number, value))  # noqa: PLR2004


def _is_counts(value: object) -> bool:
    return isinstance(value, list) and all(isinstance(n, int) and n >= 0 for n in value)


def _is_sentences(value: object) -> bool:
    return isinstance(value, list) and all(isinstance(text, str) for text in value)


def _is_mapping(value: object) -> bool:
    return isinstance(value, dict)


def _is_forces(value: object) -> bool:
    return isinstance(value, dict) and all(map(_is_number, value.values()))


# Form of the attributes that are JSON.
FORMS: dict[str, tuple[Callable[[object], bool], str]] = {
    "scenario": (_is_mapping, "a mapping"),
    "section_m": (_is_section, "two numbers"),
    "lcp_pivots_per_step": (_is_counts, "a list of counts"),
    "static_force_found": (_is_forces, "a mapping of numbers"),
    "stop_force_max": (_is_forces, "a mapping of numbers"),
    "controllers": (_is_mapping, "a mapping"),
    "fmus": (_is_mapping, "a mapping"),
    "certainty": (_is_mapping, "a mapping"),
    "state": (_is_mapping, "a mapping"),
    "warnings": (_is_sentences, "a list of sentences"),
}


def check_attributes(found: Mapping[str, Any]) -> None:
    """Refuse attributes of another form than results have; None is one that is not there.

    Raises
    ------
    ValueError
        Says which.
    """
    for name, (is_sound, expected) in FORMS.items():
        value = found[name]
        if value is not None and not is_sound(value):
            raise ValueError(f"{name} is not {expected}")
    for name, value in found.items():
        if isinstance(value, float) and not isfinite(value):
            raise ValueError(f"{name} is {value}")
