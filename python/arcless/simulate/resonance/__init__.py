"""Resonance speeds of a line and its pantographs, from the line at rest."""

from arcless.pantograph.natural_modes import Band
from arcless.simulate.resonance.spacing_period import SpacingPeriod, spacing_period
from arcless.simulate.resonance.speeds import ResonanceSpeed, ResonanceSpeeds, resonance_speeds

__all__ = [
    "Band",
    "ResonanceSpeed",
    "ResonanceSpeeds",
    "SpacingPeriod",
    "resonance_speeds",
    "spacing_period",
]
