"""Cross-section of a wire, as its stiffnesses imply it: area, modulus, distance of the outer fibre.

A full round section of area A has I = A²/(4π), so that

  A = 4π EI/EA,   E = EA/A,   r = √(A/π)

Line files hold EA and EI, and most EI of the catalogue are those of full round sections. A grooved
or worn wire differs by some per cent. Where wires of a strand slide, EI lies far below that of a
full section, and so does A found from it; a profile has more. Then the mass over A is the density
of no metal, and the area is not taken.
"""

from dataclasses import dataclass
from math import pi, sqrt
from typing import Self

from arcless.errors import ModelError
from arcless.model.line.parts.components import TensionedWire

# Areas in m² of wires of overhead lines and of conductor rails lie between: 1 mm² and 0.01 m².
LEAST_AREA, LARGEST_AREA = 1e-6, 1e-2
# Densities in kg/m³ from aluminium, 2700, to copper, 8900, with some margin: an area found from
# EI is wrong where the wire is lighter or heavier. Narrower, and rounded EI would be refused.
LIGHTEST, HEAVIEST = 2400.0, 9800.0


@dataclass(frozen=True)
class WireSection:
    """Cross-section of a wire.

    Attributes
    ----------
    area
        A in m².
    modulus
        Young's modulus E = EA/A in Pa.
    half_height
        Distance r in m from the neutral axis to the outer fibre: half of the diameter, where the
        line has it, otherwise √(A/π).
    bending_stiffness
        EI of the line in N m².
    stated
        True when the area was stated, False when it follows from EI and EA.
    """

    area: float
    modulus: float
    half_height: float
    bending_stiffness: float
    stated: bool

    @classmethod
    def of(cls, wire: TensionedWire, area: float | None = None) -> Self | None:
        """Return the section of a wire; None where the area is not stated nor follows from EI.

        Parameters
        ----------
        wire
            With EA and EI.
        area
            A in m²; without it, that of a full round section.

        Raises
        ------
        ModelError
            The area is none of a wire.
        """
        if area is not None and not LEAST_AREA <= area <= LARGEST_AREA:
            raise ModelError(
                "area of a wire", got=f"{1e6 * area:g} mm²",
                expected=f"{1e6 * LEAST_AREA:g} to {1e6 * LARGEST_AREA:g} mm²",
            )  # fmt: skip
        stiffness = wire.bending_stiffness
        found = 4.0 * pi * stiffness / wire.axial_stiffness if area is None else area
        if area is None and not LIGHTEST * found <= wire.mass <= HEAVIEST * found:
            return None
        round_half = sqrt(found / pi)
        half = round_half if wire.diameter is None else 0.5 * wire.diameter
        return cls(found, wire.axial_stiffness / found, half, stiffness, area is not None)

    @property
    def basis(self) -> str:
        """Where the area is from, in words."""
        return "stated" if self.stated else "full round section of EI and EA"
