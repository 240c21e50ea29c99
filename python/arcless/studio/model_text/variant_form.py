"""The form of a variant: what it sets, and the common fields that it leaves as they are."""

from collections.abc import Iterator, Mapping
from typing import Any

from arcless.model import Scenario
from arcless.model.variants.variant_files import Variant
from arcless.studio.model_text.about import About, about
from arcless.studio.model_text.form_field import told, value_of
from arcless.studio.model_text.places import Place

TRAIN = ("model", "static_force", "mean_force", "distance")
_SET = "set"
_BASE = About(
    description=Variant.model_fields["base"].description or "", unit=None, units=[],
    minimum=None, maximum=None, choices=[], required=True,
)  # fmt: skip


def variant_groups(
    data: Mapping[str, Any], places: Mapping[str, Place], scenario: Scenario | None
) -> list[dict[str, Any]]:
    """Return the groups of fields of a variant.

    Parameters
    ----------
    data, places
        What is typed, and where.
    scenario
        The whole scenario; None where it cannot be read.
    """
    typed = data.get(_SET)
    given = {key: value_of(one) for key, one in typed.items()} if isinstance(typed, dict) else {}
    whole = {} if scenario is None else scenario.to_dict()
    groups: dict[str, list[dict[str, Any]]] = {"Run": [], "Set by this variant": []}
    groups["Run"].append(told("base", "base", data.get("base"), _BASE, places.get("base")))
    for title, path in _common(whole):
        own = given.get(path)
        field = _field(path, own, places, _inherited(whole, path) if own is None else None)
        if field is not None and field["value"] is not None:
            groups.setdefault(title, []).append(field)
    common = {path for _, path in _common(whole)}
    for path, value in given.items():
        field = None if path in common else _field(path, value, places, None)
        if field is not None:
            groups["Set by this variant"].append(field)
    return [{"title": title, "fields": own} for title, own in groups.items() if own]


def _common(whole: Mapping[str, Any]) -> Iterator[tuple[str, str]]:
    """Yield title and path of the fields that every scenario has; the speed without one, too."""
    yield "Run", "speed"
    for place in range(len(whole.get("pantographs", ()))):
        for name in TRAIN:
            yield f"Pantograph {place + 1}", f"pantographs.{place}.{name}"


def _field(
    path: str, typed: Any, places: Mapping[str, Place], inherited: Any
) -> dict[str, Any] | None:
    parts = tuple(int(part) if part.isdigit() else part for part in path.split("."))
    known = about("scenario", parts)
    if known is None or isinstance(typed, dict):
        return None
    label = parts[-1] if path.count(".") < 1 or path.startswith("pantographs.") else _words(parts)
    field = f"{_SET}.{path}"
    return told(field, str(label), typed, known, places.get(field), inherited=inherited)


def _words(parts: tuple[str | int, ...]) -> str:
    words = [str(part + 1) if isinstance(part, int) else part for part in parts]
    return f"{' '.join(words[:-1])}: {words[-1]}"


def _inherited(whole: Mapping[str, Any], path: str) -> Any:
    """Return what the base has at a path: as it is typed there, else in SI; a model by its name."""
    value: Any = whole
    for part in path.split("."):
        value = value[int(part)] if isinstance(value, list | tuple) else (value or {}).get(part)
    given = (whole.get("provenance", {}).get(path) or {}).get("given")
    if isinstance(value, Mapping):
        return value.get("name")
    # A force that another one stands in for keeps its note, and has no value.
    return value if given is None or value is None else given
