"""Table of the physical kinds and their units.

It holds the units that overhead-line engineers write.
"""

import math
import re
from fractions import Fraction
from functools import cache
from typing import NamedTuple


class Kind(NamedTuple):
    """A physical kind: its name with article, and its units in SI, SI unit first."""

    name: str
    units: dict[str, int | float | Fraction]


_MILLI = Fraction(1, 1000)
_KMH = Fraction(5, 18)
_DEGREE = math.pi / 180
# Exact by definition: Abramowitz, Stegun (eds.): Handbook of Mathematical Functions, NBS AMS 55,
# tables 2.4 and 2.5. The foot is the international one, not that of land surveys.
_FOOT, _POUND = Fraction("0.3048"), Fraction("0.45359237")
_INCH, _YARD, _CHAIN, _MILE = _FOOT / 12, 3 * _FOOT, 66 * _FOOT, 5280 * _FOOT
_KGF = Fraction("9.80665")
_LBF = _POUND * _KGF

# Keyed by SI unit. Spellings: a product is "·", a power is a plain digit (see `canonical`).
KINDS: dict[str, Kind] = {
    "N": Kind(
        "a force",
        {"N": 1, "kN": 1000, "daN": 10, "MN": 10**6, "kgf": _KGF, "tf": 1000 * _KGF, "lbf": _LBF},
    ),
    "m": Kind(
        "a length",
        {
            "m": 1,
            "mm": _MILLI,
            "cm": Fraction(1, 100),
            "km": 1000,
            "in": _INCH,
            "ft": _FOOT,
            "yd": _YARD,
            "chain": _CHAIN,
            "mi": _MILE,
        },
    ),
    "m2": Kind(
        "an area",
        {"m2": 1, "mm2": _MILLI**2, "cm2": Fraction(1, 10_000), "in2": _INCH**2},
    ),
    "kg": Kind("a mass", {"kg": 1, "g": _MILLI, "t": 1000, "lb": _POUND}),
    "kg/m": Kind(
        "a mass per length",
        {"kg/m": 1, "g/m": _MILLI, "kg/km": _MILLI, "t/km": 1, "lb/ft": _POUND / _FOOT},
    ),
    "N/m": Kind(
        "a stiffness",
        {
            "N/m": 1,
            "kN/m": 1000,
            "N/mm": 1000,
            "MN/m": 10**6,
            "kN/mm": 10**6,
            "daN/m": 10,
            "kgf/m": _KGF,
            "kgf/mm": 1000 * _KGF,
            "lbf/ft": _LBF / _FOOT,
            "lbf/in": _LBF / _INCH,
        },
    ),
    "N s/m": Kind(
        "a damping",
        {
            "N·s/m": 1,
            "kN·s/m": 1000,
            "kgf·s/m": _KGF,
            "lbf·s/ft": _LBF / _FOOT,
            "lbf·s/in": _LBF / _INCH,
        },
    ),
    "N m2": Kind(
        "a bending stiffness",
        {
            "N·m2": 1,
            "kN·m2": 1000,
            "N·mm2": _MILLI**2,
            "kgf·m2": _KGF,
            "lbf·ft2": _LBF * _FOOT**2,
            "lbf·in2": _LBF * _INCH**2,
        },
    ),
    "kg m2": Kind("a moment of inertia", {"kg·m2": 1, "lb·ft2": _POUND * _FOOT**2}),
    "N m/rad": Kind(
        "a rotational stiffness",
        {"N·m/rad": 1, "kN·m/rad": 1000, "kgf·m/rad": _KGF, "lbf·ft/rad": _LBF * _FOOT},
    ),
    "N m s/rad": Kind(
        "a rotational damping",
        {"N·m·s/rad": 1, "kgf·m·s/rad": _KGF, "lbf·ft·s/rad": _LBF * _FOOT},
    ),
    "m/s": Kind("a speed", {"m/s": 1, "km/h": _KMH, "mph": _MILE / 3600, "ft/s": _FOOT}),
    "s": Kind("a time", {"s": 1, "ms": _MILLI, "min": 60}),
    "rad": Kind("an angle", {"rad": 1, "mrad": _MILLI, "deg": _DEGREE, "°": _DEGREE}),
    "Hz": Kind("a frequency", {"Hz": 1, "kHz": 1000}),
    # Standard gravity is gn, for g is the gram. Exact by definition, as kgf.
    "m/s2": Kind("an acceleration", {"m/s2": 1, "gn": _KGF}),
    "1/s": Kind("a rate", {"1/s": 1}),
    "1/K": Kind("a thermal expansion", {"1/K": 1, "1/°C": 1, "1/°F": Fraction(9, 5)}),
    "K": Kind("a temperature difference", {"K": 1}),
    "kg/m3": Kind(
        "a density", {"kg/m3": 1, "g/cm3": 1000, "t/m3": 1000, "lb/ft3": _POUND / _FOOT**3}
    ),
    "N/(m/s)2": Kind("an aerodynamic coefficient", {"N/(m/s)2": 1, "N/(km/h)2": 1 / _KMH**2}),
    "N/s": Kind("a rate of force", {"N/s": 1, "kN/s": 1000, "kgf/s": _KGF, "lbf/s": _LBF}),
    "A": Kind("an electric current", {"A": 1, "kA": 1000}),
    "V": Kind("a voltage", {"V": 1, "kV": 1000}),
    "Ohm": Kind("a resistance", {"Ohm": 1, "mOhm": _MILLI, "uOhm": Fraction(1, 1_000_000)}),
    "Pa": Kind(
        "a hardness",
        {"Pa": 1, "MPa": 10**6, "GPa": 10**9, "N/mm2": 10**6, "kgf/mm2": 10**6 * _KGF},
    ),
    # Responses of a structure to a force: displacement, velocity and acceleration of 1 N.
    "m/N": Kind(
        "a compliance",
        {
            "m/N": 1,
            "mm/N": _MILLI,
            "um/N": _MILLI**2,
            "mm/kN": _MILLI**2,
            "in/lbf": _INCH / _LBF,
        },
    ),
    "m/s/N": Kind(
        "a mobility", {"m/s/N": 1, "mm/s/N": _MILLI, "m/s/kN": _MILLI, "in/s/lbf": _INCH / _LBF}
    ),
    "m/s2/N": Kind(
        "an accelerance",
        {"m/s2/N": 1, "mm/s2/N": _MILLI, "m/s2/kN": _MILLI, "1/kg": 1, "gn/N": _KGF},
    ),
    "J/kg": Kind("a latent heat", {"J/kg": 1, "kJ/kg": 1000, "MJ/kg": 10**6}),
    "1": Kind("a number without unit", {"": 1, "%": Fraction(1, 100), "‰": _MILLI}),
}

ALIASES = {
    "Ns/m": "N·s/m",
    "kNs/m": "kN·s/m",
    "Nm2": "N·m2",
    "kNm2": "kN·m2",
    "kgm2": "kg·m2",
    "Nm/rad": "N·m/rad",
    "Nms/rad": "N·m·s/rad",
    "N·s2/m2": "N/(m/s)2",
    "Ns2/m2": "N/(m/s)2",
    "kmh": "km/h",
    "kph": "km/h",
    "mi/h": "mph",
    "mile": "mi",
    "feet": "ft",
    "inch": "in",
    "lbs": "lb",
    "lbs/ft": "lb/ft",
    "kp": "kgf",
    "µm/N": "um/N",
    "μm/N": "um/N",
    "(m/s)/N": "m/s/N",
    "m/(N·s)": "m/s/N",
    "m/(s·N)": "m/s/N",
    "(m/s2)/N": "m/s2/N",
    "m/(s2·N)": "m/s2/N",
    "m/(N·s2)": "m/s2/N",
    "s-1": "1/s",
    "K-1": "1/K",
    "/K": "1/K",
    "/°C": "1/°C",
    "Ω": "Ohm",
    "mΩ": "mOhm",
    "µΩ": "uOhm",
    "μΩ": "uOhm",
}
KIND_OF_UNIT = {unit: kind for kind in KINDS.values() for unit in kind.units if unit}

_POWER = re.compile(r"(?<=[mstn)])([23])")


@cache
def accepted(unit: str) -> str:
    """Say which kind and which units a field takes, e.g. ``a speed (m/s, km/h, mph, ft/s)``."""
    kind = KINDS[unit]
    units = [spell(name) for name in kind.units if name]
    if "" in kind.units:
        return f"{kind.name}, or in {' or '.join(units)}"
    return f"{kind.name} ({', '.join(units)})"


def spell(unit: str) -> str:
    """Return a unit as engineers print it: ``N·m2`` → ``N m²``."""
    return _POWER.sub(lambda found: "²" if found[1] == "2" else "³", unit.replace("·", " "))


def canonical(written: str) -> str:
    """Return a unit as `KINDS` spells it: ``N s/m`` → ``N·s/m``; an unknown one likewise."""
    name = written.replace("²", "2").replace("³", "3").replace("**", "").replace("^", "")
    name = name.replace("⁻¹", "-1").replace("\u2212", "-")
    name = re.sub(r"\s*[·⋅*]\s*|\s+", "·", name)
    name = re.sub(r"·?/·?", "/", name)
    return ALIASES.get(name, name)
