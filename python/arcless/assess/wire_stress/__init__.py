"""Stress of the contact wire at clamps and supports over a passage, and its cycles."""

from arcless.assess.wire_stress.stress import PlaceStress, WireStress, wire_stress

__all__ = ["PlaceStress", "WireStress", "wire_stress"]
