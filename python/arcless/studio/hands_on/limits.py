"""The limit that contact forces of a session are compared with, from the rules of assessment."""

from typing import Any

from arcless.assess.rules import RULES, Facts
from arcless.model import Scenario
from arcless.model.line.parts.geometry import ASSUMED_SUPPLY


def highest_force(scenario: Scenario, speed_m_s: float) -> dict[str, Any] | None:
    """Return the limit of the statistical maximum F_m + 3σ at a speed: N, mark and words.

    It is a limit of a whole section, not of a moment: shown to compare with, it decides nothing.
    """
    supply = scenario.line.design.supply
    facts = Facts(supply=supply or ASSUMED_SUPPLY, speed_km_h=3.6 * speed_m_s)
    for rule in RULES:
        if rule.name == "statistical_max" and rule.applies(facts):
            assumed = "" if supply else ", supply assumed"
            about = f"limit of {rule.title}, mark {rule.mark}{assumed}"
            return {"force_N": rule.limit.constant, "about": about}
    return None
