"""The study file as a person would write it; a file that is there is patched, its comments stay."""

from collections.abc import Iterator, Mapping
from typing import Any, TypeGuard

from arcless.errors import ModelError
from arcless.model import edit
from arcless.model.files.text_patches import rendered
from arcless.model.files.yaml_reader import parse
from arcless.units import show

FORMAT = "arcless-study/1"
# Groups whose entries stand on lines of their own.
_BLOCKS = ("set", "variables", "outputs")
# Fields that are written, in this order.
KEYS = (
    "name", "description", "scenario", "set", "variables", "design", "outputs", "seed", "executor",
)  # fmt: skip


def written(definition: Mapping[str, Any], before: str | None) -> str:
    """Return the text of a study.

    Parameters
    ----------
    definition
        Fields of a study file, `KEYS`, values as typed.
    before
        The text that is there; None for a new file. What is not among `KEYS` stays.

    Raises
    ------
    ModelError
        A field is unknown, a value is nothing that YAML has, or the text cannot be patched.
    """
    unknown = [key for key in definition if key not in KEYS]
    if unknown:
        raise ModelError(
            "field of a study", got=show(unknown[0]), expected=f"one of: {', '.join(KEYS)}"
        )
    return _new(definition) if before is None else _patched(definition, before)


def _new(definition: Mapping[str, Any]) -> str:
    lines = [f"format: {FORMAT}"]
    for key in KEYS:
        value = definition.get(key)
        if value is None or value in ({}, ""):
            continue
        if key in _BLOCKS and isinstance(value, Mapping):
            lines.append(f"{key}:")
            for name, entry in value.items():
                lines += _entry(str(name), entry, is_open=key == "variables")
        else:
            lines.append(f"{key}: {rendered(value)}")
    return "\n".join([*lines, ""])


def _entry(name: str, entry: Any, *, is_open: bool) -> list[str]:
    if is_open and isinstance(entry, Mapping):
        inside = [f"    {rendered(str(key))}: {rendered(value)}" for key, value in entry.items()]
        return [f"  {rendered(name)}:", *inside]
    return [f"  {rendered(name)}: {rendered(entry)}"]


def _patched(definition: Mapping[str, Any], text: str) -> str:
    data, _ = parse(text, "study file")
    for path, value in _differences(definition, data):
        patch = edit.remove(text, path) if value is None else edit.change(text, path, value)
        text = patch.apply(text)
    return text


def _differences(
    now: Mapping[str, Any], before: Mapping[str, Any], above: str = ""
) -> Iterator[tuple[str, Any]]:
    """Yield the paths that differ with their new values; None where one goes.

    A group whose names have dots is one value: its entries have no paths.
    """
    gone = [key for key in before if key not in now] if above else []
    for key in gone:
        yield f"{above}{key}", None
    for key, value in now.items():
        old = before.get(key)
        path = f"{above}{key}"
        if value is None:
            if old is not None:
                yield path, None
        elif _has_entries(value) and _has_entries(old) and not _is_wrapped(old):
            yield from _differences(value, old, f"{path}.")
        elif value != (old["value"] if _is_wrapped(old) and not _is_wrapped(value) else old):
            yield path, value


def _has_entries(value: Any) -> TypeGuard[Mapping[str, Any]]:
    return isinstance(value, Mapping) and bool(value) and not any("." in str(key) for key in value)


def _is_wrapped(value: Any) -> TypeGuard[Mapping[str, Any]]:
    return isinstance(value, Mapping) and "value" in value
