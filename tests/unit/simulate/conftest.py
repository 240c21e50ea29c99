"""A short line that runs in a fraction of a second."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import arcless
from arcless.model import Scenario
from arcless.results import Result

SHORT = Path(__file__).parents[2] / "interface" / "data" / "short.yaml"
QUICK = {
    "line.spans": [{"type": "span", "count": 6}],
    "travel": {"start": "50 m", "end": "200 m"},
    "analysis": {"from": "60 m", "to": "190 m"},
}
# What these tests are about is not how `auto` divides a line: few elements, and a matrix.
PLAIN = {
    "solver.scheme": "generalised-alpha",
    "solver.residual_flexibility": False,
    "solver.contact_wire_element": 1.45,
    "solver.messenger_wire_element": 2.9,
}


def plain(changes: dict[str, Any]) -> dict[str, Any]:
    """Return the settings above where changes do not ask for explicit steps or for `auto`."""
    other = changes.get("solver.scheme") in ("central-difference", "auto") or "solver" in changes
    return {} if other else PLAIN


@pytest.fixture(scope="session")
def short() -> Callable[..., Scenario]:
    """Return a maker of short scenarios; changes by dotted path."""
    base = arcless.load(SHORT)
    return lambda **changes: base.with_(**{**QUICK, **plain(changes), **changes})


@pytest.fixture(scope="session")
def run(short: Callable[..., Scenario]) -> Callable[..., Result]:
    """Run the short scenario with changes, each only once."""
    known: dict[str, Result] = {}

    def answer(**changes: Any) -> Result:
        key = repr(sorted(changes.items()))
        if key not in known:
            known[key] = arcless.run(short(**changes))
        return known[key]

    return answer


@pytest.fixture(scope="session")
def placement(short: Callable[..., Scenario]) -> dict[str, Any]:
    """Return the data of the short scenario's pantograph."""
    return short().to_dict()["pantographs"][0]
