"""What makes a scenario one of explicit steps."""

from typing import Any

EXPLICIT: dict[str, Any] = {
    "solver.scheme": "central-difference",
    "solver.wire_model": "lumped",
    "solver.contact_wire_element": 0.45,
    "solver.messenger_wire_element": 0.6,
    "solver.time_step": "1 ms",
}
