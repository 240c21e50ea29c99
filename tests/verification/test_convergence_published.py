"""The published and the default method tend to the same contact force; the page has more of it."""

from collections.abc import Callable, Iterator
from itertools import pairwise
from math import log2
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest

import arcless
from arcless.model.settings import Solver

DOCS = Path(__file__).parents[2] / "docs"
DEFAULT = ("hermite", "generalised-alpha", "linearised")
PUBLISHED = ("lumped", "backward-difference", "updated")
Smooth = Callable[..., Any]


@pytest.fixture(scope="module")
def converging() -> Iterator[ModuleType]:
    """What makes the tables of the page."""
    with pytest.MonkeyPatch.context() as patch:
        patch.syspath_prepend(str(DOCS))
        from validation import converging

        yield converging


@pytest.fixture(scope="module")
def smooth(converging: ModuleType) -> Smooth:
    """Run the line of the page by a method, once for the same one."""
    return converging.smooth


def printed(table: str) -> list[list[str]]:
    """Cells of a table of the page, without its head."""
    page = (DOCS / "validation/convergence-published.md").read_text(encoding="utf-8")
    _, _, rest = page.partition(f"<!-- table: {table} -->")
    lines = rest.partition("<!-- end -->")[0].strip().splitlines()[2:]
    return [line.strip("| ").split(" | ") for line in lines]


def apart(one: Any, other: Any) -> float:
    return float(np.sqrt(np.mean((one.force - other.force) ** 2)))


def orders(errors: list[float]) -> list[float]:
    return [log2(a / b) for a, b in pairwise(errors)]


def test_default_method_is_the_default() -> None:
    solver = Solver()
    assert (solver.wire_model, solver.scheme.name, solver.kinematics) == DEFAULT
    own = arcless.load("praks-250").solver
    assert (own.wire_model, own.scheme.name, own.kinematics) == PUBLISHED


def test_wire_models_agree_to_second_order(smooth: Smooth) -> None:
    reference = smooth(DEFAULT, 0.25, 2e-4)
    lumped = ("lumped", *DEFAULT[1:])
    errors = [apart(smooth(lumped, ell, 2e-4), reference) for ell in (0.5, 0.25, 0.125)]
    # Elements of 0.5 m are longer than the wire's bending length of 0.34 m, and the reference has
    # an error of its own of 0.01 N beside 0.13 N: 0.2 on either side of 2.
    assert orders(errors) == pytest.approx([2.0, 2.0], abs=0.2)


def test_schemes_agree_to_first_order(smooth: Smooth) -> None:
    reference = smooth(DEFAULT, 0.25, 2e-4)
    backward = ("hermite", "backward-difference", "linearised")
    errors = [apart(smooth(backward, 0.25, tau), reference) for tau in (4e-4, 2e-4, 1e-4)]
    # Backward differences damp like β = τ, the line has β = 4 ms: the error falls short of being
    # proportional to τ by about τ/β, 10 % and 5 % here.
    assert orders(errors) == pytest.approx([1.0, 1.0], abs=0.15)
    assert orders(errors)[1] > orders(errors)[0]


def test_kinematics_differ_by_what_geometry_adds(smooth: Smooth) -> None:
    updated = (*DEFAULT[:2], "updated")
    more = {"solver.gravity": 0.0}
    differences = []
    for force in (100.0, 200.0):
        changes = {**more, "pantographs.0.static_force": force}
        runs = [smooth(way, 0.5, 8e-4, **changes) for way in (DEFAULT, updated)]
        differences.append(apart(*runs))
    # A straight line looks the same from above and below, so nothing quadratic can follow the
    # linear term. The next one after the cubic is smaller by the wire's slope squared.
    assert differences[1] / differences[0] == pytest.approx(8.0, rel=0.01)
    assert differences[0] < 3e-4 * 100.0  # tension grows by less than that: half the slope squared


def test_published_method_tends_to_the_default_one(smooth: Smooth) -> None:
    reference = smooth(DEFAULT, 0.25, 2e-4)
    speed = 250 / 3.6
    ladder = [smooth(PUBLISHED, ell, ell / speed) for ell in (0.5, 0.25, 0.125)]
    errors = [apart(found, reference) for found in ladder]
    # One element per step: order 1 of the scheme, not yet reached with steps of 2 to 7 ms beside
    # 4 ms of damping; the page has 0.61 and 0.66.
    assert all(0.5 < found < 1.0 for found in orders(errors))
    # As printed there; the reference is finer there by 0.01 N.
    page = [float(row[2]) for row in printed("published")[:3]]
    assert errors == pytest.approx(page, abs=0.02)
    # What is left without the first order of τ: the chain of 0.125 m, 0.13 N (second order in ℓ,
    # above), the kinematics, 0.03 N, and second orders of τ, 0.03 N. A quarter more than their sum.
    long, short = (smooth(PUBLISHED, 0.125, tau).force for tau in (4e-4, 2e-4))
    left = np.sqrt(np.mean((2 * short - long - reference.force) ** 2))
    assert left < 0.25
    assert left < 0.02 * reference.force.std()


def test_oscillator_is_the_one_of_the_page(converging: ModuleType) -> None:
    rows = printed("oscillator")
    assert rows == [list(row) for row in converging.oscillator_table()[1]]
    for _, _, damping, damped, period, longer in rows:
        assert (damping, period) == (damped, longer)  # measured and closed form, all digits
