"""Collector heads in runs and in their matrices: shares, roll, bending, reach."""

from collections.abc import Callable
from math import pi
from typing import Any

import numpy as np
import pytest

from arcless.errors import ContactError
from arcless.model import Scenario, load_pantograph
from arcless.model.pantograph.head import CollectorHead
from arcless.pantograph.equation_of_motion import head_matrices
from arcless.results import Result
from arcless.simulate.setup import pantographs
from arcless.simulate.setup.collector_head import add_head

Run = Callable[..., Result]
Short = Callable[..., Scenario]
Data = dict[str, Any]

MODEL = "pantographs.0.model"
MASS: Data = {"mass": 9.0, "stiffness": 160.0, "damping": 100.0}
ROLL: Data = {"inertia": 0.8, "stiffness": 1700.0, "damping": 11.0}
STRIP: Data = {"half_length": 0.8, "mass": 3.75, "stiffness": 3500.0, "damping": 22.5}
# The speed of the short scenario is 160 km/h; this one makes 0.05 m of a step.
SPEED = 50.0


def pantograph(**head: Any) -> Data:
    return {"name": "head", "masses": [MASS], "head": {**STRIP, **head}}


def aside(y: float) -> Data:
    """Return changes by which a line runs straight at y from the track, m."""
    names = ("stagger_contact_wire", "stagger_messenger_wire")
    return {f"line.geometry.{name}": [y] for name in names}


def values(result: Result, name: str) -> np.ndarray:
    return result.dataset[name].values


def test_two_strips_share_the_force_and_their_sum_is_assessed(run: Run) -> None:
    result = run(**{MODEL: pantograph(strip_spacing=0.58)})
    shares = values(result, "wire_contact_force")
    assert shares.shape[1] == 2
    assert np.all(shares >= 0.0)
    np.testing.assert_array_equal(shares.sum(axis=1), values(result, "contact_force")[:, 0])
    # Something differs between them, or the second strip would be the first one.
    assert np.abs(shares[:, 0] - shares[:, 1]).max() > 1.0


def test_at_rest_in_the_middle_of_a_span_both_strips_carry_half(short: Short) -> None:
    import arcless

    # All but at rest, so both see the wire of mid-span mirrored.
    slow = short(
        **{
            MODEL: pantograph(strip_spacing=0.58),
            "speed": 1e-3,
            "travel": {"start": 125.0, "end": 125.00001},
            "analysis": {"from": 125.0, "to": 125.00001},
        }
    )
    shares = values(arcless.run(slow), "wire_contact_force")
    # A strip that is set in motion along a wire of slope 3e-3 (beside a dropper of 130 N) feels at
    # most m v z'/h = 3.75 kg · 1 mm/s · 3e-3 / 2 ms = 6 mN.
    np.testing.assert_allclose(shares[:, 0], shares[:, 1], atol=6e-3)
    assert shares.min() > 10.0


def test_a_roll_at_a_wire_aside_is_the_matrices_with_its_lever(run: Run) -> None:
    y = 0.2
    rolling = pantograph(strips=1, roll=ROLL)
    made = pantographs.data(load_pantograph(rolling), 0.0)
    matrices = {
        **{
            name: np.reshape(getattr(made, name), (3, 3)).tolist()
            for name in ("mass", "damping", "stiffness")
        },
        "strip": [0.0, 1.0, y],
        "preload": made.preload,
        "lift": made.lift,
        "raised": [1.0, 1.0, 0.0],
    }
    by_head = run(**{MODEL: rolling}, **aside(y))
    by_hand = run(**{MODEL: {"name": "lever", "matrices": matrices}}, **aside(y))
    # The wire is straight at y but for rounding of its equilibrium, 1e-12 m of 0.2 m.
    np.testing.assert_allclose(
        values(by_head, "contact_force"), values(by_hand, "contact_force"), rtol=1e-8
    )
    # The strip turns towards the wire's side: down there where the force grows.
    force = values(by_head, "contact_force")[:, 0]
    roll = values(by_head, "strip_roll")[:, 0, 0]
    assert np.corrcoef(force, roll)[0, 1] < 0.0


def test_stiff_in_roll_is_level_and_soft_is_not(run: Run) -> None:
    level = values(run(**{MODEL: pantograph(strips=1)}, **aside(0.2)), "contact_force")
    stiff = {**ROLL, "stiffness": 1e9}
    like_it = values(
        run(**{MODEL: pantograph(strips=1, roll=stiff)}, **aside(0.2)), "contact_force"
    )
    soft = values(run(**{MODEL: pantograph(strips=1, roll=ROLL)}, **aside(0.2)), "contact_force")
    # y²/k_θ = 4e-11 m/N beside 2e-5 m/N of the contact.
    np.testing.assert_allclose(like_it, level, rtol=1e-4)
    assert np.abs(soft - level).max() > 1.0


def test_without_roll_the_lateral_place_does_not_matter(run: Run) -> None:
    # One strip without roll: nothing in the run knows y. Room for round-off only.
    one = run(**{MODEL: pantograph(strips=1)}, **aside(0.2))
    other = run(**{MODEL: pantograph(strips=1)}, **aside(-0.2))
    np.testing.assert_allclose(
        values(one, "contact_force"), values(other, "contact_force"), rtol=1e-9
    )


def test_the_second_strip_runs_behind_the_first(run: Run) -> None:
    zigzag = {
        "line.geometry.stagger_contact_wire": [0.2, -0.2],
        "line.geometry.stagger_messenger_wire": [0.0],
    }
    result = run(**{MODEL: pantograph(strip_spacing=0.5), "speed": SPEED}, **zigzag)
    first, second = values(result, "wire_contact_lateral").T
    # 0.5 m at 50 m/s are five steps of 2 ms, in which the wire goes 4 mm aside; meanwhile the wire
    # itself moves some tenths of a millimetre.
    np.testing.assert_allclose(second[5:], first[:-5], atol=1e-3)
    assert np.abs(second - first).max() > 3e-3


def test_a_force_beside_the_middle_turns_and_bends_the_strip() -> None:
    """Closed form: z = −F/k, θ = −F y/k_θ, and at the wire F (1/k + y²/k_θ + Σ φ²/m_q ω²)."""
    places = np.linspace(-0.8, 0.8, 33)
    shape = np.cos(2.2 * places) - 0.4
    head = CollectorHead(
        **STRIP,
        strips=1,
        roll=ROLL,
        shape_positions=places.tolist(),
        modes=[{"frequency": 60, "modal_mass": 1.9, "shape": shape.tolist()}],
    )
    added = add_head(head, 1)
    own = head_matrices(head, 1).stiffness[1:, 1:]  # the mass below is held
    knots, vectors = np.array(added.strips[0][2]), np.array(added.strips[0][3])
    for y in (-0.5, 0.0, 0.3):
        e = np.array([np.interp(y, knots, column) for column in vectors[:, 1:].T])
        # Round-off of a 2 × 2 solve.
        sunk = np.linalg.solve(own, -100.0 * e)
        assert sunk[0] == pytest.approx(-100.0 / 3500.0)
        assert sunk[1] == pytest.approx(-100.0 * y / 1700.0, abs=1e-15)
        phi = np.cos(2.2 * y) - 0.4
        flexibility = 1 / 3500 + y**2 / 1700 + phi**2 / (1.9 * (2 * pi * 60) ** 2)
        # These places are knots of the head's table: round-off.
        assert -e @ sunk == pytest.approx(100.0 * flexibility, rel=1e-9)


def test_what_the_strips_do_is_in_the_energy_ledger(run: Run) -> None:
    zigzag = {
        "line.geometry.stagger_contact_wire": [0.2, -0.2],
        "line.geometry.stagger_messenger_wire": [0.0],
    }
    model = pantograph(strip_spacing=0.5, roll=ROLL)
    result = run(**{MODEL: model, "solver.scheme": "trapezoidal"}, **zigzag)
    # Rounding over 1700 steps; a term left out would show with its own size, 1e-3 and more.
    assert result.dataset.attrs["energy_residual_relative"] < 1e-9


@pytest.mark.parametrize(
    "model",
    [
        pantograph(strips=1, half_length=0.15),
        {"name": "plain", "masses": [MASS], "half_length": 0.15},
    ],
)
def test_a_wire_beyond_the_strip_is_said_with_the_place(short: Short, model: Data) -> None:
    import arcless

    scenario = short(**{MODEL: model}, **aside(0.2))
    with pytest.raises(ContactError) as caught:
        arcless.run(scenario)
    for part in ("50.00 m", "pantograph P1", "got 0.200 m off", "0.150 m"):
        assert part in str(caught.value)
