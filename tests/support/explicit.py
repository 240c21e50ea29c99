"""What makes a scenario one of explicit steps, and what one of steps that are solved for."""

from typing import Any

EXPLICIT: dict[str, Any] = {
    "solver.scheme": "central-difference",
    "solver.wire_model": "lumped",
    "solver.contact_wire_element": 0.45,
    "solver.messenger_wire_element": 0.6,
    "solver.time_step": "1 ms",
}
# AC simple steps explicitly as it is shipped. Cubic elements and a matrix in their place: those
# that a scheme with a matrix takes by itself, and shorter ones for lines in space.
BY_MATRIX: dict[str, Any] = {"solver.scheme": "generalised-alpha"}
SOLVED: dict[str, Any] = BY_MATRIX | {
    "solver.contact_wire_element": 0.72,
    "solver.messenger_wire_element": 1.45,
}
