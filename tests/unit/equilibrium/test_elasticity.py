"""Elasticity of wires side by side, lifted together."""

from typing import Any

import numpy as np
import pytest

from arcless.equilibrium.equilibrium import Equilibrium, find
from arcless.errors import EquilibriumError
from arcless.model import load
from tests.support.line_types import scenario_data
from tests.support.overlaps import overlap_data, plain_data

DOUBLE = {"mass": 2.2, "axial_stiffness": 28e6, "bending_stiffness": 260.0, "tension": 30e3}


def rest(line: dict[str, Any], dimension: str = "planar") -> Equilibrium:
    return find(load(scenario_data(line, solver__dimension=dimension)))


def pair(droppers: str = "paired", separation: float = 1e-6) -> dict[str, Any]:
    return plain_data(6, twin_contact_wires={"separation": separation, "droppers": droppers})


@pytest.mark.parametrize("dimension", ["planar", "spatial"])
def test_a_pair_is_lifted_like_one_wire_of_twice_everything(dimension: str) -> None:
    single = plain_data(6, contact_wire=DOUBLE, steady_arm__vertical_stiffness=600.0)
    single["dropper"] = {"stiffness": 2e5, "mass": 0.2}
    two, one = rest(pair(), dimension), rest(single, dimension)
    x = one.elasticity_positions()
    # 400 N make droppers slack, so that the force decides; forces agree to some 1e-6 of them.
    for force in (0.0, 120.0, 400.0):
        np.testing.assert_allclose(two.elasticity(x, force), one.elasticity(x, force), rtol=1e-6)
    # Somewhere it does: 400 N lift a wire by more than in proportion.
    assert np.any(one.elasticity(x, 400.0) > 1.01 * one.elasticity(x))


def test_places_far_away_change_no_bit() -> None:
    """Elements beyond the places that are asked for are left out, and have no part in them."""
    found = rest(plain_data(6))
    x = found.elasticity_positions()
    ends = found.positions[found.mesh.contact_nodes, 0]
    together = np.concatenate([[ends.min()], x, [ends.max()]])
    for force in (0.0, 120.0):
        np.testing.assert_array_equal(
            found.elasticity(together, force)[1:-1], found.elasticity(x, force)
        )


def test_droppers_that_lean_hardly_matter() -> None:
    # 20 mm aside over 1.8 m: cosines of 6e-5 from one, and some 1e-4 of tension across.
    close, usual = (rest(pair(separation=s), "spatial") for s in (1e-6, 0.04))
    x = close.elasticity_positions()
    np.testing.assert_allclose(usual.elasticity(x), close.elasticity(x), rtol=2e-3)


def test_both_wires_are_stiffer_than_either_and_help_each_other_a_little() -> None:
    line = pair("alternating")
    # One on either wire, half a metre apart, so that both hang at one height.
    places = [x + aside for x in (5.0, 15.0, 25.0, 34.5, 44.5, 54.5) for aside in (0.0, 0.5)]
    line["span_types"]["span"]["droppers"] = {"positions": places}
    found = rest(line)
    x = found.elasticity_positions()
    both = found.elasticity(x)
    alone = np.array([found.core.elasticity([lane], x.tolist(), 0.0) for lane in found.mesh.lanes])
    # e = 1 / (1ᵀ W⁻¹ 1) grows with what one wire lifts the other: between two that know nothing of
    # each other, which share the force, and the stiffer one alone.
    assert np.all(both < alone.min(axis=0))
    assert np.all(both > 1.0 / (1.0 / alone).sum(axis=0))
    # Where both take part of a force that slackens droppers they rise more, and never less.
    assert np.all(found.elasticity(x, 400.0) >= both * (1.0 - 1e-9))


def test_of_wires_that_sag_by_turns_the_lower_one_is_touched() -> None:
    # Twenty metres from dropper to dropper, a wire sags by 1.1 · 9.81 · 20² / (8 · 15 000) = 36 mm.
    found = rest(pair("alternating"))
    x = np.array([125.0])  # where wire 1 hangs on a dropper, and wire 2 is in the middle of two
    assert found.elasticity(x).tolist() == found.core.elasticity(
        [found.mesh.lanes[1]], [125.0], 0.0
    )


def test_a_wire_that_is_raised_is_not_touched() -> None:
    found = rest(overlap_data(overlap__separation=0.0))
    first, second = found.mesh.lanes
    # Spans 5 to 7 overlap, 240 m to 420 m; 60 mm up and more beyond the middle one.
    for x, lanes in ((270.0, [first]), (330.0, [first, second]), (390.0, [second])):
        expected = found.core.elasticity(lanes, [x], 0.0)
        assert found.elasticity(np.array([x])).tolist() == expected
    # Behind the end of the first tension length there is the second one alone.
    assert found.elasticity(np.array([500.0])).tolist() == found.core.elasticity(
        [second], [500.0], 0.0
    )


def test_a_place_beyond_all_wires_is_refused() -> None:
    with pytest.raises(EquilibriumError, match="700"):
        rest(overlap_data(overlap__separation=0.0)).elasticity(np.array([700.0]))
