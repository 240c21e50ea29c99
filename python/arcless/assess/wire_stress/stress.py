"""Stress of the contact wire at clamps and supports: at rest, in a passage, and its cycles."""

from collections.abc import Iterator
from dataclasses import asdict, dataclass
from typing import TYPE_CHECKING, Any

from arcless.assess.wire_stress import histories
from arcless.assess.wire_stress.bending import StiffString
from arcless.assess.wire_stress.cycles import Cycles, check_exponent
from arcless.errors import ModelError
from arcless.model.line.wire_section import WireSection

if TYPE_CHECKING:
    from arcless.dataset.plain_dataset import Dataset
    from arcless.model import Scenario

PASCAL_PER_MPA = 1e6


@dataclass(frozen=True)
class PlaceStress:
    """Stress of one fibre at a clamp or support, in MPa.

    Attributes
    ----------
    name, x_m, fibre
        Of the place; the fibre on top, or that which points to the steady arm.
    at_rest_MPa, max_MPa, min_MPa
        T/A and bending together.
    largest_range_MPa, cycles
        Largest range of a cycle, and number of cycles, by rainflow counting.
    equivalent_range_MPa
        Range of one cycle that does the damage of all; None without an exponent.
    """

    name: str
    x_m: float
    fibre: str
    at_rest_MPa: float  # noqa: N815 - the unit is part of the name
    max_MPa: float  # noqa: N815
    min_MPa: float  # noqa: N815
    largest_range_MPa: float  # noqa: N815
    cycles: float
    equivalent_range_MPa: float | None  # noqa: N815


@dataclass(frozen=True)
class WireStress:
    """Stress of the contact wire of a run.

    Attributes
    ----------
    places
        Clamps of droppers, then those of steady arms, along the track.
    wire
        The contact wire, its tension and its section.
    exponent
        Of the Wöhler line; None without one.
    section_m
        The part of the line, in m.
    """

    places: list[PlaceStress]
    wire: StiffString
    exponent: float | None
    section_m: tuple[float, float]

    @property
    def worst(self) -> PlaceStress:
        """Place with the largest equivalent range, or without an exponent the largest range."""
        return max(self.places, key=lambda one: one.equivalent_range_MPa or one.largest_range_MPa)

    def to_dict(self) -> dict[str, Any]:
        """Return plain values, ready for JSON."""
        section = self.wire.section
        return {
            "section_m": list(self.section_m),
            "tension_N": self.wire.tension,
            "area_mm2": 1e6 * section.area,
            "area_from": section.basis,
            "half_height_mm": 1e3 * section.half_height,
            "modulus_GPa": 1e-9 * section.modulus,
            "axial_stress_MPa": self.wire.axial_stress / PASCAL_PER_MPA,
            "exponent": self.exponent,
            "places": [asdict(place) for place in self.places],
        }


def wire_stress(
    data: "Dataset",
    scenario: "Scenario",
    *,
    area: float | None = None,
    tension: float | None = None,
    exponent: float | None = None,
) -> WireStress:
    """Return the stress of the contact wire at clamps and supports in the analysis section.

    Parameters
    ----------
    data
        A record of a run.
    scenario
        Its scenario.
    area
        Area of the contact wire in m²; without it, that of a full round section.
    tension
        Tension of the contact wire in N; without it, that of the design.
    exponent
        Exponent m of a Wöhler line, for the equivalent range.

    Raises
    ------
    ModelError
        The line is of a kind that this does not know, the wire has no EI, or a number is none that
        can be meant.
    OutputError
        The package rainflow is not installed.
    """
    if exponent is not None:
        check_exponent(exponent)
    wire, section = _wire(scenario, area, tension), scenario.analysis_range()
    found = [
        *histories.of_droppers(data, wire, section),
        *histories.of_supports(data, wire, section),
    ]
    places = list(_places(found, wire, exponent))
    if not places:
        raise ModelError(
            "wire stress", got="no force of a dropper or steady arm in the section",
            expected="a run that recorded them", hint="output.droppers and output.supports: true",
        )  # fmt: skip
    return WireStress(places, wire, exponent, section)


def _wire(scenario: "Scenario", area: float | None, tension: float | None) -> StiffString:
    line = scenario.line
    for field, is_there in (
        ("twin_contact_wires", line.twin_contact_wires is not None),
        ("tension_lengths", line.tension_lengths is not None),
    ):
        if is_there:
            raise ModelError(
                "wire stress", got=f"a line with {field}",
                expected="one contact wire, which carries the whole contact force",
            )  # fmt: skip
    if tension is None and not scenario.as_built.is_empty:
        raise ModelError(
            "wire stress", got="a line as built, whose tension is not that of the design",
            expected="the tension of the contact wire, which `arcless statics` tells",
        )  # fmt: skip
    wire = line.contact_wire
    section = WireSection.of(wire, area)
    pulled = wire.tension if tension is None else tension
    if section is None or wire.bending_stiffness == 0.0 or pulled <= 0.0:
        raise ModelError(
            "wire stress", got=f"EI = {wire.bending_stiffness:g} N m², T = {pulled:g} N",
            expected="a contact wire with bending stiffness, under tension",
        )  # fmt: skip
    return StiffString(section, pulled, wire.mass)


def _places(
    found: list[histories.History], wire: StiffString, exponent: float | None
) -> Iterator[PlaceStress]:
    axial = wire.axial_stress
    for one in found:
        cycles = Cycles.of(one.stress)
        equivalent = None if exponent is None else cycles.equivalent_range(exponent)
        yield PlaceStress(
            one.name,
            one.x_m,
            one.fibre,
            (axial + one.held) / PASCAL_PER_MPA,
            float(axial + one.stress.max()) / PASCAL_PER_MPA,
            float(axial + one.stress.min()) / PASCAL_PER_MPA,
            cycles.largest / PASCAL_PER_MPA,
            cycles.count,
            None if equivalent is None else equivalent / PASCAL_PER_MPA,
        )
