"""Coefficients of wear for tests: round numbers that make each part easy to write down."""

from copy import deepcopy
from typing import Any

_WEAR: dict[str, Any] = {
    "body": "contact wire",
    "current": 400.0,
    "hardness": 1e9,
    "mechanical": {
        "factor": 2e-8, "reference_current": 400.0, "reference_force": 100.0,
        "current_exponent": 2.0, "force_exponent": 0.5,
    },
    "joule": {
        "factor": 3e-6,
        "resistance": {
            "kind": "power", "reference_resistance": 0.01, "reference_force": 100.0,
            "exponent": 0.5,
        },
    },
    "arc": {"factor": 0.1, "voltage": 30.0, "melting_heat": 2e5, "density": 8900.0},
}  # fmt: skip


def wear_data(**changes: Any) -> dict[str, Any]:
    """Return a section `wear`; changes by path, dots written as ``__``."""
    data = deepcopy(_WEAR)
    for path, value in changes.items():
        *groups, last = path.split("__")
        place = data
        for group in groups:
            place = place[group]
        place[last] = value
    return data
