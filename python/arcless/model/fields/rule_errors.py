"""Errors of rules that many parts of a model share, each with one wording."""

from arcless.errors import ModelError
from arcless.model.fields.part import Path


def missing(*field: str | int, expected: str, hint: str | None = None) -> ModelError:
    """Return the error of a field that must be there, by its path."""
    return ModelError("missing field", expected=expected, hint=hint, field=field)


def both_given(
    first: str, second: str, *, at: Path = (), expected: str = "", hint: str | None = None
) -> ModelError:
    """Return the error of two fields that exclude each other, at the second one or a path."""
    return ModelError(
        f"both {first} and {second} given",
        expected=expected or f"{first} or {second}",
        hint=hint,
        field=at or (second,),
    )
