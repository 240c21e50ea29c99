"""Dropper lengths of the AC simple line against the published ones (mark A)."""

from collections.abc import Callable
from itertools import pairwise

import numpy as np
import pytest

from arcless.simulate import StaticsResult
from arcless.validate.reference import DROPPERS

AtRest = Callable[..., StaticsResult]


def lengths(found: StaticsResult, span: int = 10) -> np.ndarray:
    return np.array([d["length_m"] for d in found.droppers if d["span"] == span])


def test_nine_lengths_within_3_mm(at_rest: AtRest) -> None:
    found = lengths(at_rest(DROPPERS.scenario))
    # 3 mm: the source prints whole millimetres, and does not say how its droppers were stretched.
    np.testing.assert_allclose(found, DROPPERS.lengths, rtol=0, atol=3e-3)


def test_lengths_do_not_depend_on_the_mesh(at_rest: AtRest) -> None:
    solver = at_rest(DROPPERS.scenario).scenario.solver
    halved = {
        f"solver.{wire}_wire_element": getattr(solver, f"{wire}_wire_element") / 2
        for wire in ("contact", "messenger")
    }
    coarse, fine = lengths(at_rest(DROPPERS.scenario)), lengths(at_rest(DROPPERS.scenario, halved))
    # Half of the tolerance above, so that no choice of mesh decides whether it is met.
    np.testing.assert_allclose(coarse, fine, rtol=0, atol=1.5e-3)


def test_inner_spans_are_alike(at_rest: AtRest) -> None:
    found = at_rest(DROPPERS.scenario)
    inner = [lengths(found, span) for span in range(3, 19)]
    # The ends are fixed, so equal spans differ only by what is left of the ends: below a
    # hundredth of a millimetre, which no workshop cuts to.
    for left, right in pairwise(inner):
        np.testing.assert_allclose(left, right, rtol=0, atol=1e-5)
    np.testing.assert_allclose(inner[0], inner[0][::-1], rtol=0, atol=1e-5)


def test_as_built_from_the_design_gives_the_design_back(at_rest: AtRest) -> None:
    design = at_rest(DROPPERS.scenario)
    rest = [d["unstretched_length_m"] for d in design.droppers if d["span"] == 10]
    built = at_rest(DROPPERS.scenario, {"line.span_types.standard.droppers.lengths": rest})
    heights = [
        [s["contact_wire_height_m"] for s in found.supports][5:16] for found in (design, built)
    ]
    # The lengths of an inner span serve all spans here, so the end spans are not quite the design.
    np.testing.assert_allclose(heights[1], heights[0], rtol=0, atol=1e-4)
    assert lengths(built) == pytest.approx(lengths(design), abs=1e-4)
