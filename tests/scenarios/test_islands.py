"""Tension lengths that no pantograph touches are not stepped, and nobody can tell."""

import numpy as np

import arcless
from arcless.equilibrium.equilibrium import find
from arcless.model import load
from tests.support.line_types import scenario_data
from tests.support.overlaps import overlap_data

LINE = overlap_data(3, ends=(5, 8), spans=11)


def test_nodes_are_numbered_tension_length_by_tension_length() -> None:
    mesh = find(load(scenario_data(LINE))).mesh
    upper, lower = mesh.parts["links"]["nodes"].T
    number = {d.link: int(d.name.split()[2]) for d in mesh.droppers}
    of_nodes = sorted((int(n), number[i]) for i in number for n in (upper[i], lower[i]))
    assert [length for _, length in of_nodes] == sorted(length for _, length in of_nodes)
    assert {length for _, length in of_nodes} == {1, 2, 3}


def test_force_is_the_same_where_lengths_left_behind_are_laid_to_rest() -> None:
    short = {"travel__start": 70.0, "travel__end": 560.0, "output__points": [130.0, 500.0]}
    whole = arcless.run(load(scenario_data(LINE, **short))).dataset
    near = arcless.run(load(scenario_data(LINE, **short, output__around="40 m"))).dataset
    for name in ("contact_force", "contact_height", "mass_displacement", "point_uplift"):
        np.testing.assert_array_equal(whole[name].values, near[name].values, err_msg=name)
    # The one with the first point goes on; the second, which ends at 480 m, is at rest again.
    highest, of_near = (d["support_uplift_max"].values for d in (whole, near))
    assert (of_near <= highest).all()
