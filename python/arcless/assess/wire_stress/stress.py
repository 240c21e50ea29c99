"""Stress of the contact wire at clamps and supports: at rest, in a passage, and its cycles."""

from collections.abc import Iterator
from dataclasses import asdict, dataclass
from typing import TYPE_CHECKING, Any

from arcless.assess.wire_stress import histories, tables
from arcless.assess.wire_stress.bending import StiffString
from arcless.assess.wire_stress.cycles import Cycles, check_exponent
from arcless.dataset.metadata import metadata
from arcless.errors import ModelError
from arcless.model.line.wire_section import WireSection
from arcless.units import to_si

if TYPE_CHECKING:
    import pandas

    from arcless.dataset.plain_dataset import Dataset
    from arcless.model import Scenario

PASCAL_PER_MPA = 1e6
# Young's moduli in Pa of copper and its alloys, with a margin (mark: assumed; contact wires of the
# catalogue lie between 103 and 126 GPa). Narrower, and rounded EA would be warned of; wider, and
# the area of another wire would pass.
LEAST_MODULUS, LARGEST_MODULUS = 90e9, 135e9


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
        key = tables.range_key(self.exponent)
        return max(self.places, key=lambda one: float(getattr(one, key)))

    @property
    def notes(self) -> list[str]:
        """Sentences on what is doubtful in these numbers."""
        modulus, section = self.wire.section.modulus, self.wire.section
        if LEAST_MODULUS <= modulus <= LARGEST_MODULUS:
            return []
        return [
            f"the area of {1e6 * section.area:.1f} mm² ({section.basis}) and the EA of the line "
            f"make Young's modulus {1e-9 * modulus:.1f} GPa; that of copper and its alloys is "
            f"{1e-9 * LEAST_MODULUS:g} to {1e-9 * LARGEST_MODULUS:g} GPa (assumed): check area, "
            "EA and EI"
        ]

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
            "notes": self.notes,
        }

    def to_dataframe(self) -> "pandas.DataFrame":
        """Return places and fibres along the track as a data frame, stresses in MPa."""
        return tables.data_frame(self.to_dict())

    def __repr__(self) -> str:
        return f"<WireStress of {tables.in_words(self.to_dict())}>"

    def _repr_html_(self) -> str:
        return tables.card(self.to_dict())


def wire_stress(
    data: "Dataset",
    scenario: "Scenario",
    *,
    area: float | str | None = None,
    tension: float | str | None = None,
    exponent: float | str | None = None,
) -> WireStress:
    """Return the stress of the contact wire at clamps and supports in the analysis section.

    Parameters
    ----------
    data
        A record of a run.
    scenario
        Its scenario.
    area
        Area of the contact wire in m², or a text such as ``"120 mm²"``; without it, that of a full
        round section.
    tension
        Tension of the contact wire in N, or a text such as ``"18 kN"``; without it, that of the
        design.
    exponent
        Exponent m of a Wöhler line, for the equivalent range.

    Raises
    ------
    ModelError
        The run stopped early, or a pantograph did not pass all places of the section; the line is
        of a kind that this does not know, the wire has no EI, or a number is none that can be
        meant.
    OutputError
        The package rainflow is not installed.
    """
    slope = None if exponent is None else check_exponent(exponent)
    _check_finished(data, scenario)
    wire = _wire(scenario, _number("area", area, "m2"), _number("tension", tension, "N"))
    section = scenario.analysis_range()
    found = [
        *histories.of_droppers(data, wire, section),
        *histories.of_supports(data, wire, section),
    ]
    places = list(_places(found, wire, slope))
    if not places:
        raise ModelError(
            "wire stress", got="no force of a dropper or steady arm in the section",
            expected="a run that recorded them", hint="output.droppers and output.supports: true",
        )  # fmt: skip
    _check_passed(data, scenario, places)
    return WireStress(places, wire, slope, section)


def _number(name: str, value: float | str | None, unit: str) -> float | None:
    try:
        return None if value is None else to_si(value, unit)
    except ModelError as error:
        error.where = name
        raise


def _check_finished(data: "Dataset", scenario: "Scenario") -> None:
    if metadata(data)["state"] is not None:
        raise ModelError(
            "run that stopped early", where=scenario.name, expected="a finished run",
            hint="`arcless resume RUN` continues it",
        )  # fmt: skip


def _check_passed(data: "Dataset", scenario: "Scenario", places: list[PlaceStress]) -> None:
    """Refuse a run in which a pantograph did not pass one of the places."""
    begin, end = (pick(one.x_m for one in places) for pick in (min, max))
    path = data["position"].values
    for i, name in enumerate(data["pantograph"].values):
        first, last = float(path[0, i]), float(path[-1, i])
        if not first <= begin <= end <= last:
            raise ModelError(
                "section that was not wholly passed", where=scenario.name,
                got=f"pantograph {name} ran over {first:.1f} to {last:.1f} m",
                expected=f"all places of the section, {begin:.1f} to {end:.1f} m",
                hint="run it with another section (analysis.from, analysis.to) or a longer travel",
            )  # fmt: skip


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
            expected="the tension of the contact wire, which `arcless statics` prints",
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
