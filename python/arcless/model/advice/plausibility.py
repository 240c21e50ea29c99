"""Numbers of a valid model that no line and no pantograph in service has: mostly a wrong unit.

Section and stress are not in a model file. As of copper, ρ = 8900 kg/m³, they follow from the mass:

    A = m/ρ,   σ = T/A,   ε = T/EA,   c_l = √(EA/m) = √(E/ρ)

c_l is the speed of longitudinal waves, a constant of the material: 3.4 to 3.8 km/s for copper and
its alloys, 5.1 km/s for steel and for aluminium. Strands have all of their mass and less of E;
those of aluminium and steel are light: 200 MPa of them are 390 MPa as of copper.

The ranges hold the shipped lines, with room to either side: they are there to catch kN for N and mm
for m, not to judge a design. Assumed; none is from a standard.
"""

from collections.abc import Iterator
from math import sqrt
from typing import NamedTuple

from arcless.model.line.line import Line
from arcless.model.line.parts.wire_ends import GRAVITY
from arcless.model.pantograph.placement import PantographPlacement
from arcless.model.scenario.scenario import Scenario

THOUSAND, MILLION = 1e3, 1e6
COPPER_DENSITY = 8900.0  # kg/m³
RAYLEIGH_EXAMPLE = "damping: {alpha: 0.17 1/s, beta: 0.1 ms}"


class UsualRange(NamedTuple):
    """Usual range of a quantity: lower and upper end in a unit, and the size of that unit in SI."""

    low: float
    high: float
    unit: str
    scale: float = 1.0


MASS = UsualRange(0.3, 3.0, "kg/m")
STRESS = UsualRange(20.0, 450.0, "MPa", 1e6)
STRAIN = UsualRange(0.01, 0.5, "%", 1e-2)
LONGITUDINAL = UsualRange(2.5, 5.5, "km/s", 1e3)
WAVE_SPEED = UsualRange(200.0, 650.0, "km/h", 1 / 3.6)
HEIGHT = UsualRange(3.5, 7.5, "m")
ENCUMBRANCE = UsualRange(0.15, 3.0, "m")
DROPPER_STIFFNESS = UsualRange(0.5, 1e5, "kN/m", 1e3)
FORCE = UsualRange(30.0, 300.0, "N")
MOVING_MASS = UsualRange(3.0, 150.0, "kg")


def line_plausibility(line: Line) -> list[str]:
    """Return one sentence for each number of a line that is far from what lines have."""
    return [*_about_wires(line), *_about_geometry(line), *_about_damping(line)]


def pantograph_plausibility(scenario: Scenario) -> list[str]:
    """Return one sentence for each number of its pantographs that is far from what they have."""
    return [
        told
        for number, placement in enumerate(scenario.pantographs)
        for told in _about_pantograph(f"pantographs.{number}", placement)
    ]


def _about_wires(line: Line) -> Iterator[str]:
    for name, wire in line.wires():
        if not wire.tension:  # a rail
            continue
        yield from _beyond(f"line.{name}.mass", "the mass", wire.mass, MASS)
        stress = wire.tension * COPPER_DENSITY / wire.mass
        yield from _beyond(
            f"line.{name}.tension", "the stress, as of copper with this mass,", stress, STRESS
        )
        strain = wire.tension / wire.axial_stiffness
        yield from _beyond(
            f"line.{name}.axial_stiffness", "the strain at rest, T/EA,", strain, STRAIN
        )
        sound = sqrt(wire.axial_stiffness / wire.mass)
        what = "the speed of longitudinal waves, √(EA/m), which is that of the material,"
        yield from _beyond(f"line.{name}.axial_stiffness", what, sound, LONGITUDINAL)
    if line.wave_speed is not None:
        what = "the wave speed of the contact wire"
        yield from _beyond("line.contact_wire", what, line.wave_speed, WAVE_SPEED)


def _about_geometry(line: Line) -> Iterator[str]:
    geometry = line.geometry
    what = "the height of the contact wire"
    height = geometry.contact_wire_height
    yield from _beyond("line.geometry.contact_wire_height", what, height, HEIGHT)
    if geometry.encumbrance is not None:
        what = "the encumbrance"
        yield from _beyond("line.geometry.encumbrance", what, geometry.encumbrance, ENCUMBRANCE)
        yield from _about_sag(line, geometry.encumbrance)
    if line.dropper is not None:
        what = "the stiffness of a dropper"
        yield from _beyond(
            "line.dropper.stiffness", what, line.dropper.stiffness, DROPPER_STIFFNESS
        )


def _about_sag(line: Line, encumbrance: float) -> Iterator[str]:
    """Say that the messenger wire would hang as low as the contact wire: w L²/8T."""
    messenger = line.messenger_wire
    if messenger is None:
        return
    longest = max(span.length for span in line.span_list())
    sag = line.hanging_mass * GRAVITY * longest**2 / (8.0 * messenger.tension)
    if sag > encumbrance:
        yield (
            f"line.messenger_wire.tension: {messenger.tension:g} N lets the messenger wire sag by"
            f" some {sag:.2g} m in a span of {longest:g} m, and line.geometry.encumbrance is"
            f" {encumbrance:g} m: is a unit wrong?"
        )


def _about_damping(line: Line) -> Iterator[str]:
    """Say that waves of a line never die down, where nothing in its wires damps them."""
    wires = dict(line.wires())
    if any(wire.damping.alpha or wire.damping.beta for wire in wires.values()):
        return
    yield (
        f"line: no wire has damping ({', '.join(f'{name}.damping' for name in wires)}), so waves"
        " leave by the ends alone: σ, forces above 5 Hz and those of a trailing pantograph are too"
        f" high. Lines were measured at 1 to 5 % of critical; {RAYLEIGH_EXAMPLE} is a start"
    )


def _about_pantograph(path: str, placement: PantographPlacement) -> Iterator[str]:
    for field in ("static_force", "mean_force"):
        force = getattr(placement, field)
        if force is not None:
            what = f"the {field.replace('_', ' ')}"
            yield from _beyond(f"{path}.{field}", what, force, FORCE)
    model = placement.model
    if model.masses:
        total = sum(mass.mass for mass in model.masses)
        if model.head is not None:
            total += model.head.strips * model.head.mass
        yield from _beyond(f"{path}.model.masses", "the moving mass", total, MOVING_MASS)


def _number(value: float) -> str:
    """Return a number in three digits, without an exponent where that is short."""
    rounded = float(f"{value:.3g}")
    return f"{rounded:.0f}" if THOUSAND <= value < MILLION else f"{rounded:g}"


def _beyond(path: str, what: str, value: float, usual: UsualRange) -> Iterator[str]:
    """Say that a value in SI is beyond its usual range; mind the unit."""
    shown = value / usual.scale
    if not usual.low <= shown <= usual.high:
        yield (
            f"{path}: {what} is {_number(shown)} {usual.unit}; usual are {usual.low:g} to"
            f" {usual.high:g} {usual.unit}: is a unit wrong?"
        )
