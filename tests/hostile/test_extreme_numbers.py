"""Numbers beyond all that is built: a model error, a clean failure to compute, or a result."""

import json
from pathlib import Path
from typing import Any

import pytest

import arcless
from arcless import _core
from arcless.equilibrium import equilibrium
from arcless.errors import ArclessError, EquilibriumError, ModelError
from arcless.simulate.runs.failures import preparing

SHORT = Path(__file__).parents[1] / "interface" / "data" / "short.yaml"
HUGE = (1e100, 1e308)
TINY = (5e-324, 1e-100)
FIELDS = [
    "line.contact_wire.mass", "line.contact_wire.axial_stiffness", "line.contact_wire.tension",
    "line.contact_wire.bending_stiffness", "line.contact_wire.damping.alpha",
    "line.contact_wire.damping.beta", "line.messenger_wire.damping.beta", "line.dropper.stiffness",
    "line.dropper.damping", "line.dropper.mass", "line.dropper.rayleigh.alpha",
    "line.dropper.rayleigh.beta", "line.dropper.clamp_mass_contact_wire",
    "line.support.vertical_stiffness", "line.support.vertical_damping", "line.support.mass",
    "line.steady_arm.vertical_stiffness", "line.steady_arm.vertical_damping",
    "pantographs.0.model.masses.0.mass", "pantographs.0.model.masses.1.damping",
    "pantographs.0.model.masses.1.stiffness", "pantographs.0.model.masses.0.aerodynamic",
    "contact.stiffness", "analysis.band_split", "analysis.low_pass",
]  # fmt: skip


def outcome(**changes: Any) -> str:
    """Run the short scenario with changes; tell what became of it."""
    try:
        result = arcless.run(arcless.load(SHORT).with_(**changes))
        assert "NaN" not in result.assessment.to_json()
    except ArclessError as error:
        assert "nan" not in str(error).split()
        return type(error).__name__
    return "done"


@pytest.mark.parametrize("field", FIELDS)
def test_huge_numbers_are_refused(field: str) -> None:
    for value in HUGE:
        with pytest.raises(ModelError, match=field.rpartition(".")[2]):
            arcless.load(SHORT).with_(**{field: value})


@pytest.mark.parametrize(
    "field", [f for f in FIELDS if f.endswith(("wire.mass", "wire.tension", "_split", "_pass"))]
)
def test_numbers_that_are_as_good_as_nothing_are_refused(field: str) -> None:
    for value in TINY:
        with pytest.raises(ModelError, match=field.rpartition(".")[2]):
            arcless.load(SHORT).with_(**{field: value})


@pytest.mark.parametrize(
    "changes",
    [
        {"line.contact_wire.damping": {"beta": 100.0}},
        {"line.contact_wire.damping": {"alpha": 1e4}, "line.messenger_wire.damping": {"beta": 100}},
        {"line.dropper.damping": 1e9},
        {"line.dropper.stiffness": 1e13, "line.dropper.damping": 1e9},
        {"line.dropper.rayleigh": {"beta": 100.0}},
        {"line.support.vertical_stiffness": 1e13, "line.support.mass": 1e6},
        {"pantographs.0.model.masses.0.mass": 1e6},
        {"pantographs.0.model.masses.1.stiffness": 1e13},
    ],
)
def test_the_largest_numbers_end_cleanly(changes: dict[str, Any]) -> None:
    for scheme in ("auto", "generalised-alpha"):
        # Explicit steps of 2 ms are too long for some of these.
        clean = {"done", "EquilibriumError", "NotConvergedError", "ContactError", "ModelError"}
        assert outcome(**{"solver.scheme": scheme}, **changes) in clean


def test_what_the_core_cannot_factorise_names_the_place() -> None:
    """Behind the bounds: a matrix that damping outweighs is singular to the core."""
    scenario = arcless.load(SHORT)
    found = equilibrium.find(scenario)
    singular = _core.NativeError("singular", "the stiffness of node 0 vanishes", {"node": 0})
    said = "equations of a step cannot be solved"
    with pytest.raises(EquilibriumError, match=said) as told, preparing(found.mesh, scenario):
        raise singular
    assert "wire at 0.00 m" in str(told.value)
    other = _core.NativeError("input", "input array lanes: none", {"array": "lanes", "reason": ""})
    with pytest.raises(EquilibriumError), preparing(found.mesh, scenario):
        raise other


@pytest.mark.parametrize(
    ("over", "points"),
    [
        ("position", [-1e5, 0, 1e200]),
        ("position", [0, 1e-7, 1e4]),
        ("time", [0, 100, 1e160]),
        ("time", [0, 5e-324, 100]),
        ("time", [0, 1e-9, 100]),
        ("time", [-1e300, 0, 100]),
    ],
)
def test_roofs_that_are_no_curves_are_refused(over: str, points: list[float]) -> None:
    roof = {over: points, "displacement": [0, 0.01, 0]}
    with pytest.raises(ModelError, match=f"roof_motion.{over}"):
        arcless.load(SHORT).with_(**{"pantographs.0.roof_motion": roof})


@pytest.mark.parametrize("points", [[0, 1e-6, 1e6], [-1e6, 5.0, 5.000001, 1e6]])
def test_roofs_at_the_limits_end_cleanly(points: list[float]) -> None:
    heights = [(-1.0) ** number for number in range(len(points))]
    roof = {"time": points, "displacement": heights}
    assert json.dumps(outcome(**{"pantographs.0.roof_motion": roof}))
