"""A short line without any symmetry, and runs on it laid out for changes by hand."""

from typing import Any

import numpy as np

import arcless
from arcless.model import Scenario
from arcless.simulate.runs.job import Job, lay_out
from arcless.simulate.setup.controllers import Controllers

FORCE = 150.0  # N, static
# Length and droppers of each span, m; pre-sag a parabola of a thousandth of the length.
SPANS = (
    (55.0, (4.5, 16.0, 27.5, 39.0, 50.5)),
    (48.0, (5.0, 13.0, 24.0, 33.0, 41.0)),
    (52.0, (6.0, 20.0, 28.0, 44.0)),
    (45.0, (4.0, 12.0, 25.0, 39.0)),
)
STAGGER = (0.2, -0.15, 0.1, -0.2, 0.18)
TRAVEL = (50.0, 150.0)


def small(*, backwards: bool = False, across: float = 1.0, **changes: Any) -> Scenario:
    """Make a scenario of four spans in space at 275 km/h, 100 m long, 1300 steps.

    `backwards` turns the line round, `across` multiplies the stagger.
    """
    data = arcless.load("en50318-ac-simple-320").to_dict()
    line = data["line"]
    pieces = [(length, [length - x for x in at][::-1]) for length, at in SPANS[::-1]]
    pieces = pieces if backwards else [(length, list(at)) for length, at in SPANS]
    stagger = [across * y for y in (STAGGER[::-1] if backwards else STAGGER)]
    line["span_types"] = {f"span {i}": _span(*piece) for i, piece in enumerate(pieces)}
    line["spans"] = [{"type": f"span {i}", "count": 1} for i in range(len(pieces))]
    line["geometry"]["stagger_contact_wire"] = stagger
    line["geometry"]["stagger_messenger_wire"] = stagger
    data["pantographs"][0] |= {"mean_force": None, "static_force": FORCE}
    data["travel"] = dict(zip(("start", "end"), TRAVEL, strict=True))
    data["analysis"] = {"from": TRAVEL[0], "to": TRAVEL[1]}
    data["solver"] |= {"scheme": "generalised-alpha", "residual_flexibility": False}
    data["solver"] |= {"contact_wire_element": 1.45, "messenger_wire_element": 2.9}
    data["speed"] = 275.0 / 3.6
    return arcless.load(data).with_(**changes)


def _span(length: float, at: list[float]) -> dict[str, Any]:
    sag = [4e-3 * x * (length - x) / length for x in at]
    return {"length": length, "droppers": {"positions": at, "presag": sag}}


def laid_out(scenario: Scenario) -> Job:
    """Find the line at rest and lay out its run."""
    return lay_out(scenario, Controllers(scenario), lambda _done, _text: None, None)


def differing(one: Any, other: Any) -> tuple[int, int]:
    """Return how many numbers two arrays have, and how many of them differ in a bit.

    A negative zero is a zero.
    """
    a, b = (np.asarray(values, dtype=np.float64) + 0.0 for values in (one, other))
    assert a.shape == b.shape
    return a.size, int(np.count_nonzero(a.view(np.int64) != b.view(np.int64)))
