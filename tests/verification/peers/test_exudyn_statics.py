"""EN 50318:2002 line at rest, in Exudyn

Exudyn (J. Gerstmayr, University of Innsbruck) is a multibody program with a wire element of its
own, the planar ANCF cable. It gets the line of `en50318-2002-250` from the model file: masses,
EA, EI, stiffness of droppers and supports. From Arcless it gets what a design says to those who
build: lengths of wires and droppers, height of the springs at the supports. It starts from the
wires as drawn and finds the equilibrium itself. If the design is right, the line then hangs as
designed: contact wire at 5.3 m at each dropper, nominal tensions.

The one known difference is the law of the wire. Exudyn has `N = EA (λ − 1)`, Arcless
`N = EA ½ (λ² − 1) λ` with λ the stretch. Wires are cut to be equal at the nominal tension T. At
another tension T + ΔT their strains differ by `3 T ΔT / (EA)²`. In the messenger wire ΔT is up to
28 N (it is steeper near a support); that is 1e-8 or less of its length, 0.6 µm in a span.

Both use elements of 1.5 m (contact wire) and 3 m (messenger wire) and the same cubic shapes, so
refining changes nothing here. The messenger wire has hinges at
its supports, as in Arcless. The record was written with Exudyn 1.13.6.
"""

import numpy as np
import pytest

import arcless
from arcless.equilibrium import equilibrium
from tests.support.faults import Fault, gravity, scaled

pytest.importorskip("exudyn", reason="Exudyn is not installed: `make peers`")

import exudyn as exu

from tests.support.exudyn_built import Built
from tests.support.exudyn_line import Coordinates, Line

ELEMENTS = {
    "solver.scheme": "generalised-alpha",
    "solver.residual_flexibility": False,
    "solver.contact_wire_element": 1.5,
    "solver.messenger_wire_element": 3.0,
}
LAW = "another law of the wire moves it by about 1 µm (above); five times that"


def both_at_rest() -> tuple[equilibrium.Equilibrium, Line, Coordinates]:
    scenario = arcless.load("en50318-2002-250").with_(**ELEMENTS)
    found = equilibrium.find(scenario)
    line = Line(scenario, Built.of(scenario, found))
    return found, line, line.settle()


def test_line_hangs_as_designed(evidence) -> None:
    found, line, settled = both_at_rest()
    here = found.arrays["positions"].reshape(-1, 2)
    for name, nodes in (
        ("contact wire", found.mesh.contact_nodes),
        ("messenger wire", found.mesh.messenger_nodes),
    ):
        apart = [
            settled[place][line.up] - here[place[0], line.up]
            for place in settled
            if place[0] in nodes
        ]
        assert len(apart) > 200
        evidence.below(
            f"height of the {name}, largest difference", float(np.abs(apart).max()), 5e-6,
            unit="m", reason=LAW,
        )  # fmt: skip
    drawn = [settled[d.nodes[1], d.nodes[1]][line.up] - 5.3 for d in found.mesh.droppers]
    evidence.below(
        "height of the contact wire at the 90 droppers, off the 5.3 m of the model file",
        float(np.abs(drawn).max()), 5e-6, unit="m", reason=LAW,
    )  # fmt: skip
    forces = line.pulls(line.droppers)
    assert forces.size == 90
    apart = np.abs(forces - found.of_droppers("link_tension"))
    evidence.below(
        "dropper force, largest difference of 90", float(apart.max()), 2e-3, unit="N",
        reason="a height that is 1 µm off between droppers 6.5 m apart changes the force by"
        " 20 kN · 1 µm · 2 / 6.5 m = 6 mN at most; most of it is common to neighbours",
    )  # fmt: skip


def mean_tension(line: Line, cable: object) -> float:
    """Mean over the length of a cable by Gauss; within it, cubics make the tension swing by 3 N."""
    length = line.system.GetObject(cable)["length"]
    kind, swing = exu.OutputVariableType.ForceLocal, np.sqrt(0.15)
    places = (0.5 - swing, 0.5, 0.5 + swing)
    found = [
        np.ravel(line.system.GetObjectOutputBody(cable, kind, localPosition=[x * length, 0, 0]))[0]
        for x in places
    ]
    return float(np.dot([5 / 18, 8 / 18, 5 / 18], found))


def test_tensions_are_nominal(evidence) -> None:
    found, line, _ = both_at_rest()
    pulls = [mean_tension(line, cable) for cable in line.cables["contact_wire"]]
    assert len(pulls) > 400
    evidence.close(
        "tension of the contact wire, mean", float(np.mean(pulls)), 20e3, unit="N", relative=5e-6,
        reason="slopes of up to 2e-3 make the tension larger than its horizontal part by 1e-6",
    )  # fmt: skip
    on_contact = set(found.mesh.contact_nodes)
    rows = [
        row
        for row, (node, component) in enumerate(found.mesh.parts["springs"][["node", "component"]])
        if node not in on_contact and component == line.up
    ]
    assert len(rows) == 9
    held = [
        line.system.GetObjectOutput(line.springs[row], exu.OutputVariableType.Force) for row in rows
    ]
    apart = np.abs(np.abs(np.ravel(held)) - found.arrays["spring_force"][rows])
    evidence.below(
        "force on a messenger support, largest difference of 9", float(apart.max()), 20e-3,
        unit="N", reason="50 kN/m times a height that is 0.4 µm off",
    )  # fmt: skip


FAULTS = [
    Fault("EA of the wires 0.1 % too high", scaled("wires", "EA", 1.001),
          test_tensions_are_nominal),
    Fault("mass of the wires 0.1 % too high", scaled("wires", "mass", 1.001),
          test_line_hangs_as_designed),
    Fault("EI of the wires 10 % too low", scaled("wires", "EI", 0.9), test_line_hangs_as_designed),
    Fault("springs 0.1 % too stiff", scaled("springs", "stiffness", 1.001),
          test_tensions_are_nominal),
    Fault("gravity 0.1 % too low", gravity(0.999), test_line_hangs_as_designed),
]  # fmt: skip
