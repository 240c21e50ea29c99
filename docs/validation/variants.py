"""What is varied in the sensitivity tables of these pages: a title, and changes by dotted path."""

from typing import Any

import numpy as np

Changes = dict[str, Any]
WIRES = ("contact_wire", "messenger_wire")


def rayleigh(alpha: float, beta: float) -> Changes:
    both = {"alpha": alpha, "beta": beta}
    return {f"line.{wire}.damping": both for wire in WIRES} | {"line.dropper.rayleigh": both}


def bending(contact: float, messenger: float) -> Changes:
    return {
        "line.contact_wire.bending_stiffness": contact,
        "line.messenger_wire.bending_stiffness": messenger,
    }


def elements(contact: float) -> Changes:
    return {"solver.contact_wire_element": contact, "solver.messenger_wire_element": 2 * contact}


def presag(depth: float) -> Changes:
    """Parabola between the first and the last dropper, `depth` in m at mid-span."""
    x = np.array([5, 10.5, 17, 23.5, 30, 36.5, 43, 49.5, 55])
    sag = depth * 4 * (x - 5) * (55 - x) / 50**2
    return {"line.span_types.standard.droppers.presag": [float(z) for z in sag.round(5)]}


def force(value: float) -> Changes:
    return {"pantographs.0.static_force": value}


def en_variants() -> list[tuple[str, Changes]]:
    return [
        ("**as shipped**", {}),
        ("EI 0", bending(0.0, 0.0)),
        ("support 5e5 N/m vertical", {"line.support.vertical_stiffness": 5e5}),
        ("support free along the track", {"line.support.longitudinal_stiffness": 0.0}),
        ("motion across the track only", {"solver.motion": "across"}),
        ("damping S3: α 0.0125, β 1e-4", rayleigh(0.0125, 1e-4)),
        ("damping α 0.0125, β 5e-4", rayleigh(0.0125, 5e-4)),
        ("damping S5: 0.5 % (α 0.057, β 1.45e-4)", rayleigh(0.057, 1.45e-4)),
        ("damping 2 % (α 0.228, β 5.8e-4)", rayleigh(0.228, 5.8e-4)),
        ("pre-sag 10 mm", presag(0.010)),
        ("pre-sag 15 mm", presag(0.015)),
        ("pre-sag 30 mm", presag(0.030)),
        ("spans 4–7 assessed", {"analysis.spans": [4, 7]}),
        ("spans 5–8 assessed", {"analysis.spans": [5, 8]}),
        ("static force 115 N", force(115.0)),
        ("static force 120 N", force(120.0)),
        ("steady arm of 1 kg", {"line.steady_arm.mass": 1.0}),
        ("elements 1.45 m / 2.9 m", elements(1.45)),
        ("elements 0.4 m / 0.8 m", elements(0.4)),
    ]


# AC simple steps explicitly by default. A matrix in its place, and cubic elements.
BY_MATRIX: Changes = {"solver.scheme": "generalised-alpha"}


def ac_variants() -> list[tuple[str, Changes]]:
    planar = {f"en50318-ac-simple-{v}": f"en50318-ac-simple-{v}-planar" for v in (275, 320)}
    arm = {"line.steady_arm.vertical_stiffness": 267.36}
    undamped = {"line.dropper.rayleigh": {"alpha": 0.0, "beta": 0.0}}
    return [
        ("**as shipped**", {}),
        ("planar, arm 2673.58 N/m, as shipped", {"scenario": planar}),
        ("planar, arm 267 N/m", {"scenario": planar, **arm}),
        ("EI of S2", bending(179.05, 111.15)),
        ("EI 0", bending(0.0, 0.0)),
        ("no damping in droppers", undamped),
        ("20 N s/m dampers in droppers", {**undamped, "line.dropper.damping": 20.0}),
        ("damping 1 %, as EN 50318:2002", rayleigh(0.114, 2.9e-4)),
        (
            "messenger wire held along the track, 1e6 N/m",
            {"line.support.longitudinal_stiffness": 1e6},
        ),
        (
            "pantograph of S1 as it ships, c = 0",
            {f"pantographs.0.model.masses.{i}.damping": 0.0 for i in range(3)},
        ),
        ("start one span later", {"travel.start": 110.0}),
        ("spans 8–13 assessed", {"analysis.spans": [8, 13]}),
        ("a matrix, elements 1.45 m / 2.9 m", {**BY_MATRIX, **elements(1.45)}),
        ("a matrix, elements 0.725 m / 1.45 m", {**BY_MATRIX, **elements(0.725)}),
    ]
