"""Twin contact wires that part and meet in plan, and what statics on paper says of them.

All is to first order in the slopes of the wires, except for the catenary of `sag`.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from math import asinh, sinh, sqrt, tanh
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import brentq

from arcless.equilibrium.equilibrium import Equilibrium, find
from arcless.model import Scenario, load
from tests.support.catenary import Catenary, green, hooke
from tests.support.line_types import scenario_data
from tests.support.overlaps import plain_data

Floats = NDArray[np.float64]
GRAVITY, HEIGHT, ENCUMBRANCE = 9.81, 5.3, 1.8
MASS, TENSION, AXIAL = 1.1, 15e3, 14e6
MESSENGER_MASS, MESSENGER_AXIAL, MESSENGER_TENSION = 0.6, 7.4e6, 30e3
SUPPORT = 5e5  # stiffness of the messenger wire's supports, upwards and across, N/m
# Bars without mass that pull across alone, and supports that hold the wire across rigidly.
ARM = {"kind": "arm", "length": 1.0, "slope": 0.0, "mass": 0.0}
HELD = {"kind": "spring", "vertical_stiffness": 0.0}
ROUNDED = 1.0 / sqrt(72.0)  # ℓ/h of a corner in a string of cubic elements
FAMILIES: dict[str, dict[str, Any]] = {
    "chain": {"scheme": "generalised-alpha", "wire_model": "lumped"},
    "cubic": {"scheme": "generalised-alpha"},
    "explicit chain": {"scheme": "central-difference"},
}


def line_of(
    family: str, size: float, lengths: Sequence[float], separations: Sequence[float], *,
    bending: float = 0.0, gravity: float = GRAVITY, built: dict[str, Any] | None = None,
    **changes: Any,
) -> Scenario:  # fmt: skip
    """Return a line whose spans have two droppers in their middle, one on either wire."""
    types = {
        f"span {number}": {"length": length, "droppers": {"positions": [0.5 * length]}}
        for number, length in enumerate(lengths, start=1)
    }
    line = plain_data(1, **{
        "twin_contact_wires": {"separations": list(separations)},
        "contact_wire__bending_stiffness": bending,
        "messenger_wire__tension": MESSENGER_TENSION,
        "dropper__mass": 0.0,
        "steady_arm": ARM,
        **changes,
    })  # fmt: skip
    line["span_types"], line["spans"] = types, [{"type": name} for name in types]
    places = np.cumsum([0.0, *lengths])
    solver = {
        **FAMILIES[family], "gravity": gravity,
        "contact_wire_element": size, "messenger_wire_element": size,
    }  # fmt: skip
    data = scenario_data(
        line, speed=5.0, solver=solver, as_built=built or {},
        travel={"start": places[1], "end": places[3]},
        analysis={"from": 0.5 * (places[1] + places[2]), "to": places[2]},
    )  # fmt: skip
    return load(data)


def at_rest(*asked: Any, **changes: Any) -> Equilibrium:
    """Bring such a line to rest."""
    return find(line_of(*asked, **changes))


def pulls(found: Equilibrium) -> Floats:
    """Return the pull of each arm in N, positive to the left: a row for each inner support."""
    side = found.mesh.parts["struts"]["direction"][:, 1]
    rows = [s.steady_arm for s in found.mesh.supports if s.steady_arm is not None]
    return np.reshape([side[row] * found.arrays["strut_tension"][row] for row in rows], (-1, 2))


def of_strings(lengths: Sequence[float], staggers: Sequence[float]) -> Floats:
    """Return T × the change of direction of a string at its inner supports in N."""
    slopes = np.diff(staggers) / np.array(lengths)
    return TENSION * (slopes[:-1] - slopes[1:])


@dataclass(frozen=True)
class Layer:
    """A wire that bends, between +b/2 and −b/2 in equal spans: half a span, from its middle.

    T y″ − EI y⁗ = 0 with y′ = 0 at the supports: y = −A (x − q sinh(x/ℓ)/sinh(L/2ℓ)),
    A = b/(L − 2q), q = ℓ tanh(L/2ℓ). A chain of segments h has ℓ′ with 2 sinh(h/2ℓ′) = h/ℓ, and
    h/sinh(h/ℓ′) instead of the ℓ before tanh.
    """

    span: float
    apart: float
    bending: float
    segment: float | None = None

    @property
    def _rounding(self) -> tuple[float, float]:
        ell, h = sqrt(self.bending / TENSION), self.segment
        if h is None:
            return ell, ell * tanh(0.5 * self.span / ell)
        own = 0.5 * h / asinh(0.5 * h / ell)
        return own, h / sinh(h / own) * tanh(0.5 * self.span / own)

    @property
    def slope(self) -> float:
        """Slope A of the wire in mid-span, away from the layer."""
        return self.apart / (self.span - 2.0 * self._rounding[1])

    @property
    def pull(self) -> float:
        """Lateral pull 2 T A on a support in N."""
        return 2.0 * TENSION * self.slope

    def across(self, x: Floats) -> Floats:
        """Return y in m at places x in m from mid-span."""
        own, q = self._rounding
        return -self.slope * (x - q * np.sinh(x / own) / sinh(0.5 * self.span / own))


def bending_of(family: str, size: float, bending: float) -> float:
    """Return EI per metre of track of a wire that is stretched, as the elements have it.

    Both resist bending per metre of unstretched wire: EI/s in cubic elements, EI s³ in a chain;
    explicit steps take EI x coth x instead of EI, x = (h/2) √(T/EI).
    """
    if family == "cubic":
        return bending / float(green(TENSION, AXIAL))
    s = float(hooke(TENSION, AXIAL))
    x = 0.5 * size / s * sqrt(TENSION / bending)
    return bending * s**3 * (x / tanh(x) if family == "explicit chain" else 1.0)


def sag(family: str, span: float, apart: float) -> float:
    """Return the sag in m of a wire from dropper to dropper, in the upright plane that it is in.

    That plane is longer by u = √(1 + (b/L)²), and so is the tension in it.
    """
    law, u = (green if family == "cubic" else hooke), sqrt(1.0 + (apart / span) ** 2)
    weight = MASS * GRAVITY

    def curve(rest: float) -> Catenary:
        return Catenary(weight, AXIAL, law, u * TENSION, 0.5 * weight * rest, rest)

    def missed(rest: float) -> float:
        return float(curve(rest).at(rest)[0] - u * span)

    rest = brentq(missed, 0.9 * span, 1.1 * u * span, xtol=1e-13)
    return -float(curve(rest).at(0.5 * rest)[1])


@dataclass(frozen=True)
class Leaning:
    """Forces that a pair of droppers in mid-span has: upright V in N each, over the height h."""

    span: float

    @property
    def upright(self) -> float:
        """Weight of a span of one contact wire."""
        return MASS * GRAVITY * self.span / float(hooke(TENSION, AXIAL))

    @property
    def height(self) -> float:
        """Encumbrance less the sag of the messenger wire under its weight and both droppers."""
        own = MESSENGER_MASS * GRAVITY / float(hooke(MESSENGER_TENSION, MESSENGER_AXIAL))
        sag = own * self.span**2 / 8.0 + 2.0 * self.upright * self.span / 4.0
        return ENCUMBRANCE - sag / MESSENGER_TENSION

    @property
    def stiffness(self) -> float:
        """V/h in N/m: a dropper pulls across by as much for each metre between its ends."""
        return self.upright / self.height

    def middle(self, wide: float, narrow: float) -> float:
        """Return y in m of a wire in mid-span, between wide/2 and narrow/2."""
        mean = 0.25 * (wide + narrow)
        return mean / (1.0 + self.stiffness * self.span / (4.0 * TENSION))

    def blown(self, contact: float, messenger: float) -> tuple[float, float, float]:
        """Return the way of both wires in mid-span in m, and the pull across of a dropper in N.

        Under loads in N/m across the track, of droppers that are upright without.
        """
        own = self.span / (4.0 * TENSION)
        above = 2.0 * (self.span / (4.0 * MESSENGER_TENSION) + 1.0 / SUPPORT)
        free = contact * self.span**2 / (8.0 * TENSION)
        carried = messenger * self.span**2 / (8.0 * MESSENGER_TENSION)
        carried += messenger * self.span / SUPPORT
        pull = self.stiffness * (free - carried) / (1.0 + self.stiffness * (own + above))
        return free - own * pull, carried + above * pull, pull
