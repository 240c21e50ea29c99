"""Quantities that outputs of a study are computed from: the numbers of an assessment by key.

A key of a pantograph (`mean_force_N`) is that of the leading one; `P2.mean_force_N` is that of the
second one, by number or by name; `worst.std_force_N` is that of the pantograph where it is worst.
`criteria.NAME` is 1 where a criterion is met, 0 where not, and nothing where it is too close
to tell; `criteria.NAME.margin` is what its limit with its tolerance leaves (`Criterion.margin`),
negative where it is not met, of the pantograph with the smallest margin, and `criteria.NAME.value`
and `criteria.NAME.limit` are its value and limit.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import asdict, fields
from typing import Any

from arcless.assess import (
    RULES,
    TOO_CLOSE,
    WEAR_KEYS,
    Assessment,
    Criterion,
    PantographAssessment,
    verdict_of,
)
from arcless.model import Scenario

_NUMBERS = (float, int, float | None, int | None)
# A run of a study goes to its end.
_RUN = [
    field.name
    for field in fields(Assessment)
    if field.type in _NUMBERS and field.name != "stopped_m"
]
_PANTOGRAPH = [
    field.name for field in fields(PantographAssessment) if field.name not in ("name", "certainty")
]
WORST = "worst"
# Keys of which low values are the worse ones, and the one of which neither end is.
_LOW = ("min_force_N", "unfiltered_min_force_N", "statistical_min_N")
_NEITHER = ("mean_force_N",)
_WORST: Mapping[str, Callable[[list[float]], float]] = {
    key: min if key in _LOW else max for key in _PANTOGRAPH if key not in _NEITHER
}
_CRITERIA = sorted({rule.name for rule in RULES})
_CRITERION_UNITS = {rule.name: rule.unit for rule in reversed(RULES)}
CRITERIA = "criteria."
MARGIN = "margin"
NUMBERS_OF_CRITERIA = ("value", "limit", MARGIN)
# Units by the endings of keys; longest first.
_UNITS = {
    "_mm3_km": "mm³/km", "_percent": "%",
    "_m_s": "m/s", "_mm": "mm", "_Hz": "Hz", "_m": "m", "_N": "N", "_s": "s",
}  # fmt: skip


def keys(scenario: Scenario) -> list[str]:
    """Return every key that an output may use of a scenario's runs."""
    own = [key for key in _PANTOGRAPH if scenario.wear is not None or key not in WEAR_KEYS]
    placed = [f"{name}.{key}" for names in _names(scenario) for name in names for key in own]
    worst = [f"{WORST}.{key}" for key in own if key in _WORST]
    criteria = [f"{CRITERIA}{name}" for name in _CRITERIA]
    numbers = [f"{key}.{number}" for key in criteria for number in NUMBERS_OF_CRITERIA]
    found = [*own, *_RUN, "passed", *criteria, *numbers, *placed, *worst]
    return list(dict.fromkeys(found))  # a pantograph may be called worst


def values(assessment: Assessment) -> dict[str, float | None]:
    """Return the value of every key; None for what was not recorded or not judged."""
    found: dict[str, float | None] = {name: getattr(assessment, name) for name in _RUN}
    # A limit that was not read decides nothing: `criteria.NAME` shows it.
    deciding = [item for item in assessment.criteria if item.passed is not False or item.fails]
    found["passed"] = _all_met(deciding, of_none=1.0)
    for key, of in _WORST.items():
        known = [getattr(pantograph, key) for pantograph in assessment.pantographs]
        found[f"{WORST}.{key}"] = None if None in known else of(known)
    for index, pantograph in enumerate(assessment.pantographs):
        for key in _PANTOGRAPH:
            value = getattr(pantograph, key)
            found[f"P{index + 1}.{key}"] = found[f"{pantograph.name}.{key}"] = value
            found.setdefault(key, value)
    for name in _CRITERIA:
        items = [item for item in assessment.criteria if item.name == name]
        found[f"{CRITERIA}{name}"] = _all_met(items)
        for number, value in zip(NUMBERS_OF_CRITERIA, _nearest(items), strict=True):
            found[f"{CRITERIA}{name}.{number}"] = value
    return found


def _nearest(criteria: Sequence[Criterion]) -> tuple[float | None, float | None, float | None]:
    """Return value, limit and margin of the criterion that is nearest to its limit or beyond."""
    known = [
        (item.margin, item.value, item.limit)
        for item in criteria
        if item.margin is not None and item.value is not None and item.limit is not None
    ]
    if not known:
        return None, None, None
    margin, value, limit = min(known)
    return value, limit, margin


def criterion_of(key: str) -> tuple[str, str] | None:
    """Return the criterion of a key and which of its numbers it is; "" for the verdict.

    None of a text that is no key of a criterion.
    """
    name, _, number = key.removeprefix(CRITERIA).partition(".")
    known = key.startswith(CRITERIA) and name in _CRITERIA
    return (name, number) if known and number in ("", *NUMBERS_OF_CRITERIA) else None


def reasons(assessment: Assessment) -> dict[str, str]:
    """Return why keys of criteria have no value, of those that are too close to tell."""
    close = [item for item in assessment.criteria if _is_close(item)]
    found = {f"criteria.{item.name}": f"criteria.{item.name} is {item.reason}" for item in close}
    names = ", ".join(dict.fromkeys(item.name for item in close))
    return {**found, "passed": f"{TOO_CLOSE}: {names}"} if close else {}


def _all_met(criteria: Sequence[Criterion], of_none: float | None = None) -> float | None:
    """Return 1 where all that could be judged are met, 0 where one is not; None between them."""
    judged = [item.passed for item in criteria if item.passed is not None]
    if not all(judged):
        return 0.0
    if any(_is_close(item) for item in criteria):
        return None
    return 1.0 if judged else of_none


def _is_close(item: Criterion) -> bool:
    return verdict_of(asdict(item)) == TOO_CLOSE


def owner_of_key(key: str, scenario: Scenario) -> int | str | None:
    """Return the pantograph that a key is of, from 0, or `WORST`; None for one of the run."""
    prefix, _, name = key.rpartition(".")
    if name not in _PANTOGRAPH:
        return None
    if not prefix:
        return 0
    places = {one: place for place, names in enumerate(_names(scenario)) for one in names}
    return places.get(prefix, WORST)


def unit_of_key(key: str) -> str:
    """Return the unit of a key, empty for none: of a criterion's number, or that of its name."""
    criterion = criterion_of(key)
    if criterion is not None:
        unit = _CRITERION_UNITS[criterion[0]] if criterion[1] else ""
        return "" if unit == "1" else unit
    return next((unit for ending, unit in _UNITS.items() if key.endswith(ending)), "")


def _names(scenario: Scenario) -> Iterator[list[str]]:
    for number, placement in enumerate(scenario.pantographs, start=1):
        yield list(dict.fromkeys([f"P{number}", placement.name]))


def is_number(value: Any) -> bool:
    """Return whether a value of a variable is a number, which expressions may use."""
    return isinstance(value, int | float) and not isinstance(value, bool)
