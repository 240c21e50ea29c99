"""Wear of contact wire or collector strip, by friction, current and arcs.

Volume lost per distance run, in m³/m, after the heuristic model of Bucca and Collina:

    NWR = k₁ (½(1 + I/I₀))^(−α) (F_m/F₀)^β F_m/H  +  k₂ R(F_m) I²/(H V)  +  k₃ u V_a I/(V H_m ρ)
          mechanical                                 Joule                  arc

Source: Bucca and Collina, Wear 266 (2009), the form from memory (mark C). Their coefficients were
not found in a readable source; all of them are the user's.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

# 1 mm³/km in m³/m.
MM3_PER_KM = 1e-12
ILLUSTRATIVE = (
    "wear: the coefficients are illustrative, not measured; they show how the three parts change, "
    "not how fast anything wears"
)


@dataclass(frozen=True)
class WearRates:
    """Volume worn off per distance run, in mm³/km; None for what cannot be told."""

    wear_mechanical_mm3_km: float
    wear_joule_mm3_km: float | None
    wear_arc_mm3_km: float | None
    wear_total_mm3_km: float | None


def wear_rates(
    wear: Mapping[str, Any], mean_force_N: float, loss_percent: float, speed_m_s: float
) -> WearRates:
    """Return the wear by the passage of one pantograph.

    Parameters
    ----------
    wear
        The section `wear` of a scenario, in SI.
    mean_force_N
        F_m, mean contact force in N; zero where there never was contact.
    loss_percent
        100 u, share of time without contact in %, of the unfiltered force: an arc burns as soon
        as strip and wire part, and a low-pass closes short gaps.
    speed_m_s
        V, mean speed in m/s; 0 or more.
    """
    force, current = max(mean_force_N, 0.0), wear["current"]
    mechanical = _mechanical(wear["mechanical"], force, current) / wear["hardness"]
    if speed_m_s > 0.0:
        resistance = contact_resistance(wear["joule"]["resistance"], force, current)
        heat = None if resistance is None else resistance * current**2 / speed_m_s
        joule = None if heat is None else wear["joule"]["factor"] * heat / wear["hardness"]
        arc = _arc(wear["arc"], loss_percent / 100.0, current) / speed_m_s
    else:
        joule = arc = None
    total = None if joule is None or arc is None else mechanical + joule + arc
    return WearRates(mechanical / MM3_PER_KM, *map(_in_mm3_km, (joule, arc, total)))


def contact_resistance(
    law: Mapping[str, Any], force_N: float, current_A: float = 1.0
) -> float | None:
    """Return R(F_m) in Ω by a power law or a table; None where it has no value.

    Without a current the resistance does not matter, and is 0 where it has no value.
    """
    nothing = 0.0 if current_A == 0.0 else None
    if law["kind"] == "power":
        if force_N == 0.0 and law["exponent"] > 0.0:
            return nothing
        ratio = force_N / law["reference_force"]
        return float(law["reference_resistance"] * ratio ** -law["exponent"])
    forces = law["force"]
    if not forces[0] <= force_N <= forces[-1]:
        return nothing
    return float(np.interp(force_N, forces, law["resistance"]))


def wear_notes(wear: Mapping[str, Any] | None, rates: Mapping[str, WearRates]) -> list[str]:
    """Say whose coefficients they are, and why a part is missing; rates by pantograph."""
    if wear is None:
        return []
    notes = [ILLUSTRATIVE] if wear["illustrative"] else []
    for name, found in rates.items():
        if found.wear_arc_mm3_km is None:
            notes.append(f"wear of pantograph {name}: it stands still, so the parts of the current "
                         "have no value per distance")  # fmt: skip
        elif found.wear_joule_mm3_km is None:
            notes.append(f"wear of pantograph {name}: no contact resistance is given for its mean "
                         "force")  # fmt: skip
    return notes


def _in_mm3_km(rate: float | None) -> float | None:
    return None if rate is None else rate / MM3_PER_KM


def _mechanical(given: Mapping[str, Any], force: float, current: float) -> float:
    """Return k₁ (½(1 + I/I₀))^(−α) (F_m/F₀)^β F_m in N."""
    eased = (0.5 * (1.0 + current / given["reference_current"])) ** -given["current_exponent"]
    if force == 0.0:
        return 0.0
    pressed = (force / given["reference_force"]) ** given["force_exponent"]
    return float(given["factor"] * eased * pressed * force)


def _arc(given: Mapping[str, Any], share: float, current: float) -> float:
    """Return k₃ u V_a I/(H_m ρ), volume molten per time in m³/s."""
    power = share * given["voltage"] * current
    return float(given["factor"] * power / (given["melting_heat"] * given["density"]))
