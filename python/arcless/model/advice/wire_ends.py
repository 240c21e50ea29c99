"""Notice about a line that says nothing of the ends of its wires."""

from arcless.model.line.line import Line
from arcless.model.line.parts.components import Wire

# A cold night below the temperature of installation, K; and what a change is printed for, K.
COLDER, STEP = 20.0, 10.0
WIRES = ("contact_wire", "messenger_wire", "auxiliary_wire")


def end_notices(line: Line) -> list[str]:
    """Return one sentence if wires of a line have no `ends`, with what temperature then does.

    A taut wire between anchors cannot grow, so its elastic strain takes back the thermal one:
    dT/dθ = −EA α. What its sag gives back is left out.
    """
    wires = {name: wire for name in WIRES if (wire := getattr(line, name)) and wire.ends is None}
    if not wires:
        return []
    told = "; ".join(_told(name, wire) for name, wire in wires.items())
    return [
        f"line: no ends given, so wires are anchored (ends: fixed) and pull with the temperature:"
        f" {told}. Real lines mostly hang on weights: say ends: weights (with a midpoint_anchor"
        " both ends move), constant_force, spring, or fixed"
    ]


def _told(name: str, wire: Wire) -> str:
    per_kelvin = wire.axial_stiffness * wire.thermal_expansion
    change = f"{name} by {per_kelvin * STEP / 1e3:.2g} kN per {STEP:g} K"
    if wire.tension == 0:
        return change
    cold = wire.tension + per_kelvin * COLDER
    return f"{change}, {cold / 1e3:.3g} kN {COLDER:g} K colder in place of {wire.tension / 1e3:.3g}"
