"""What an equilibrium may leave out of balance."""

import arcless
from arcless.simulate import equilibrium
from tests.support.line_types import scenario_data
from tests.support.overlaps import plain_data


def test_what_is_left_of_rounding_is_no_failure() -> None:
    """Twin wires with cubic elements of 0.35 m leave 1.003 of what a wire by itself may."""
    twin = {"separation": 0.04, "droppers": "paired"}
    damping = {"alpha": 0.0125, "beta": 1e-4}
    line = plain_data(10, twin_contact_wires=twin, contact_wire__damping=damping)
    data = scenario_data(
        line,
        speed="250 km/h",
        travel={"start": 130.0, "end": 480.0},
        solver__kinematics="updated",
    )
    found = equilibrium.find(arcless.load(data))
    assert found.positions.shape[0] > 3000
