"""Random trains for a random line: speed, pantographs, their forces and places."""

from math import sqrt
from random import Random
from typing import Any

from tests.support.random_parts import length_of

Data = dict[str, Any]
# All shipped pantographs but those of one line: `praks` of the published method, and `tsg-18f`,
# whose base spring is for conductor rails.
PANTOGRAPHS = (
    "ac-simple", "dsa-250", "dsa-380", "dsa-380-lift", "en50318-2002", "faiveley-cx", "sss-400",
    "two-mass-study",
)  # fmt: skip
KMH = 1 / 3.6
FASTEST = 350 * KMH


def train(line: Data, draw: Random) -> Data:
    """Return what a scenario says of its train."""
    contact = line["contact_wire"]
    length = length_of(line)
    if contact.get("kind") == "conductor_rail":
        speed, models = draw.uniform(60, 140) * KMH, ("tsg-18f", "dsa-250")
    else:
        waves = sqrt(contact["tension"] / contact["mass"])
        speed, models = min(draw.uniform(0.35, 0.7) * waves, FASTEST), PANTOGRAPHS
    if "bridle" in line:
        speed = draw.uniform(30, 80) * KMH
    model = draw.choice(models)
    count = draw.choice([1, 2, 2, 3])
    apart = spacing(speed) if draw.random() < 0.5 else draw.uniform(8, 150)
    # What lies between the first and the last one is taken off the analysis section.
    apart = min(apart, 0.25 * length / max(1, count - 1))
    force = forces(line, model, speed, draw)
    return {
        "pantographs": [
            {"model": model, "distance": round(i * apart, 2), **force} for i in range(count)
        ],
        "speed": speed,
        "contact": {"stiffness": draw.choice([50e3, 50e3, 82.3e3, 30e3])},
    }


def spacing(speed: float) -> float:
    """Return the spacing in m that TSI ENE, 4.2.13 asks for at a speed in m/s."""
    if speed >= 250 * KMH:
        return 200.0
    if speed > 120 * KMH:
        return 85.0
    return 15.0 if speed > 80 * KMH else 8.0


def forces(line: Data, model: str, speed: float, draw: Random) -> Data:
    """Return a mean force by the rule of the supply, or a static force; N."""
    if model == "tsg-18f" or "bridle" in line or draw.random() < 0.3:
        return {"static_force": draw.uniform(60, 100)}
    base = 110.0 if line["design"]["supply"].startswith("DC") else 70.0
    return {"mean_force": base + 0.00097 * (speed / KMH) ** 2}
