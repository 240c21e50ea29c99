"""A second pantograph in the text of a scenario, equal to the first, at a distance behind it."""

from pathlib import Path
from typing import Any

from arcless.errors import ModelError
from arcless.model.edit import change
from arcless.model.files.yaml_reader import parse
from arcless.model.load import load_text
from arcless.model.pantograph.spacing import TSI

RULE = (
    "TSI ENE, table 4.2.13, column B, as given in Bane NOR TRV:00597: 200 m from 250 km/h, 85 m"
    " above 120 km/h, 15 m above 80 km/h, else 8 m; it follows the speed."
)
_LEADING, _TRAILING = "leading", "trailing"


def with_second(text: str, spacing: str, label: str, file: Path) -> str:
    """Return the text of a scenario with a second pantograph.

    Parameters
    ----------
    text
        The scenario, with one pantograph.
    spacing
        Distance of the second pantograph behind the first: ``tsi``, or a length with its unit such
        as ``"85 m"``.
    label
        Name of the file, for messages.
    file
        The file: references in the text begin in its folder.

    Raises
    ------
    ModelError
        It is not one scenario with one pantograph, or the two do not fit on its line.
    """
    data, _ = parse(text, label)
    given = data.get("pantographs")
    if not isinstance(given, list) or len(given) != 1:
        got = f"{len(given)} pantographs" if isinstance(given, list) else "none"
        raise ModelError("--two-pantographs", where=label, got=got,
                         expected="a scenario with one pantograph",
                         hint="change pantographs.1.distance in the copy")  # fmt: skip
    first = dict(given[0])
    place: Any = spacing if spacing != TSI else {"value": TSI, "mark": "B", "note": RULE}
    changes: dict[str, Any] = {} if "name" in first else {"pantographs.0.name": _LEADING}
    model = {"model": first.pop("model")} if "model" in first else {}
    changes["pantographs.1"] = {**model, **first, "name": _TRAILING, "distance": place}
    made = text
    for path, value in changes.items():
        made = change(made, path, value, label, is_folded=path == "pantographs.1").apply(made)
    try:
        load_text(made, file)
    except ModelError as error:
        raise ModelError(error.what, where=f"{label} --two-pantographs {spacing}", got=error.got,
                         expected=error.expected, hint=error.hint) from None  # fmt: skip
    return made
