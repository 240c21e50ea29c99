"""Changes that make a scenario one of explicit steps, or one of implicit steps."""

from typing import Any

EXPLICIT: dict[str, Any] = {
    "solver.scheme": "central-difference",
    "solver.residual_flexibility": "auto",
    "solver.wire_model": "lumped",
    "solver.contact_wire_element": 0.45,
    "solver.messenger_wire_element": 0.6,
    "solver.time_step": "1 ms",
}
# Cubic elements and a matrix, nothing left to the line: elements of a coarse division, and shorter
# ones for lines in space. Without what points yield beyond their elements.
BY_MATRIX: dict[str, Any] = {
    "solver.scheme": "generalised-alpha",
    "solver.residual_flexibility": False,
    "solver.contact_wire_element": 1.45,
    "solver.messenger_wire_element": 2.9,
}
SOLVED: dict[str, Any] = BY_MATRIX | {
    "solver.contact_wire_element": 0.72,
    "solver.messenger_wire_element": 1.45,
}


def both_kinds(element: float, step: float) -> dict[str, dict[str, Any]]:
    """Return changes of `scenario_data` for both kinds of wires, by their name in the evidence.

    Elements of all wires have the given length in m; chains take steps of the given s.
    """
    fine = {f"solver__{wire}_wire_element": element for wire in ("contact", "messenger")}
    return {
        "chains": {**fine, "solver__scheme": "central-difference", "solver__time_step": step},
        "cubic elements": {**fine, "solver__scheme": "generalised-alpha"},
    }
