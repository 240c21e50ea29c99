"""One wire over one span between two anchors: the smallest line there is."""

from typing import Any

from arcless.equilibrium import equilibrium
from arcless.model import load
from tests.support.line_types import scenario_data
from tests.support.simple_lines import trolley_data

SPAN, HEIGHT = 60.0, 10.0
MASS, AXIAL, TENSION = 1.1, 14e6, 12e3
GRAVITY = 9.81
WEIGHT = MASS * GRAVITY


def one_wire(
    line: dict[str, Any] | None = None, as_built: dict[str, Any] | None = None, **solver: Any
) -> equilibrium.Equilibrium:
    """Bring a trolley wire without bending stiffness to rest over a span of 60 m.

    Parameters
    ----------
    line
        Changes of the line by path, dots written as ``__``.
    as_built, solver
        What the scenario says of these.
    """
    changes = {"span_types__span__length": SPAN, **(line or {})}
    span = changes["span_types__span__length"]
    data = trolley_data(
        **{
            "contact_wire__ends": "fixed",
            "contact_wire__bending_stiffness": 0.0,
            "geometry__contact_wire_height": HEIGHT,
            "spans": [{"type": "span"}],
            **changes,
        }
    )
    scenario = scenario_data(data, speed=5.0, solver=solver, as_built=as_built or {})
    scenario["travel"] = {"start": 0.2 * span, "end": 0.8 * span}
    scenario["analysis"] = {"from": 0.4 * span, "to": 0.6 * span}
    return equilibrium.find(load(scenario))
