"""Contacts of the core → channels of the pantographs, and of each contact where there are several.

A contact is a strip of a pantograph on a lane of the line. What a pantograph has several of is
brought to one value: the sum of the forces; the smallest gap; height and lateral position at the
contact with the largest force, or with the smallest gap where all are open.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

# Reduction of the values of several contacts to that of their pantograph, by series of the core; in
# the result its name is `contact_` + that of the series.
REDUCTIONS = {
    "force": "sum",
    "gap": "smallest",
    "height": "of the chosen",
    "lateral": "of the chosen",
}


def total_force(raw: dict[str, Any], pantographs: int) -> Floats:
    """Return the contact force (time, pantograph) in N."""
    force, owners = _columns(raw, "force"), _owners(raw)
    if len(owners) == pantographs:
        return force
    return np.column_stack([force[:, owners == j].sum(axis=1) for j in range(pantographs)])


def channels(raw: dict[str, Any], pantographs: int) -> dict[str, Floats]:
    """Return the contact variables of the result; single contacts only where one has several."""
    owners = _owners(raw)
    each = {name: _columns(raw, name) for name in REDUCTIONS}
    if len(owners) == pantographs:
        return {f"contact_{name}": values for name, values in each.items()}
    own = [
        _reduced({name: values[:, owners == j] for name, values in each.items()})
        for j in range(pantographs)
    ]
    out = {f"contact_{name}": np.column_stack([one[name] for one in own]) for name in REDUCTIONS}
    out["wire_contact_force"] = each["force"]
    out["wire_contact_gap"] = np.where(np.isinf(each["gap"]), np.nan, each["gap"])
    out["wire_contact_lateral"] = each["lateral"]
    return out


def _reduced(own: dict[str, Floats]) -> dict[str, Floats]:
    """Return one column for the contacts of a pantograph, by `REDUCTIONS`."""
    rows = np.arange(len(own["force"]))
    # A contact that has no wire in reach has an infinite gap, and is never the chosen one.
    chosen = np.where(
        (own["force"] > 0.0).any(axis=1),
        np.argmax(own["force"], axis=1),
        np.argmin(own["gap"], axis=1),
    )
    reduce = {
        "sum": lambda values: values.sum(axis=1),
        "smallest": lambda values: values.min(axis=1),
        "of the chosen": lambda values: values[rows, chosen],
    }
    return {name: reduce[REDUCTIONS[name]](values) for name, values in own.items()}


def label(numbers: Sequence[int], pantographs: Sequence[str]) -> str:
    """Name a contact, given pantograph, strip and lane from 0: P1 strip 1 wire 2."""
    pantograph, strip, lane = numbers
    return f"{pantographs[pantograph]} strip {strip + 1} wire {lane + 1}"


def labels(raw: dict[str, Any], pantographs: Sequence[str]) -> list[str]:
    """Return the names of the contacts; none where every pantograph has one."""
    if len(raw["contacts"]) == len(pantographs):
        return []
    return [label(numbers, pantographs) for numbers in raw["contacts"]]


def _columns(raw: dict[str, Any], name: str) -> Floats:
    return np.asarray(raw[name]).reshape(-1, len(raw["contacts"]))


def _owners(raw: dict[str, Any]) -> NDArray[np.int64]:
    """Return the number of the pantograph of each contact."""
    return np.array([pantograph for pantograph, _, _ in raw["contacts"]], dtype=np.int64)
