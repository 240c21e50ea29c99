"""Pantographs in a run: matrices, lift tables, roof motion, bump stops, four at once."""

from collections.abc import Callable
from math import inf, pi
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from arcless.errors import ModelError
from arcless.model import Scenario, load_pantograph
from arcless.results import Result
from arcless.simulate.setup import pantographs, stops_and_friction, trajectory

Run = Callable[..., Result]
Short = Callable[..., Scenario]
Data = dict[str, Any]

MODEL = "pantographs.0.model"
ROOF = "pantographs.0.roof_motion"
# 150 m at 160 km/h.
DURATION = 3.375


def force(result: Result) -> np.ndarray:
    return result.dataset["contact_force"].values


def as_matrices(model: Data) -> Data:
    """Return a pantograph's matrices, formed as a chain forms them."""
    made = pantographs.data(load_pantograph(model), 0.0)
    (strip,) = made.strips[0].vectors
    size = len(strip)
    square = {
        name: np.reshape(getattr(made, name), (size, size)).tolist()
        for name in ("mass", "damping", "stiffness")
    }
    return {
        "name": model["name"],
        "matrices": {**square, "strip": strip, "preload": made.preload, "lift": made.lift},
    }


def test_a_chain_written_as_matrices_gives_the_same_bits(run: Run, placement: Data) -> None:
    model = {**placement["model"]}
    model["masses"] = [{**model["masses"][0], "aerodynamic": 0.01}, model["masses"][1]]
    shaking = {ROOF: {"time": [0, 1, 2, 4], "displacement": [0, 0.02, -0.01, 0]}}
    for more in ({}, shaking):
        chain = run(**{MODEL: model}, **more)
        matrices = run(**{MODEL: as_matrices(model)}, **more)
        for name in ("contact_force", "mass_displacement", "dropper_force"):
            assert (
                chain.dataset[name].values.tobytes() == matrices.dataset[name].values.tobytes()
            ), name


def test_coordinates_do_not_matter(run: Run, placement: Data) -> None:
    """Return a pantograph in the coordinates (height of the base mass, stroke of the head)."""
    chain = as_matrices(placement["model"])["matrices"]
    turn = np.array([[1.0, 0.0], [1.0, 1.0]])  # u = turn q
    matrices = {
        name: (turn.T @ np.array(chain[name]) @ turn).tolist()
        for name in ("mass", "damping", "stiffness")
    }
    vectors = {name: (turn.T @ np.array(chain[name])).tolist() for name in ("strip", "preload")}
    general = {"name": "turned", "matrices": {**matrices, **vectors, "raised": [1.0, 0.0]}}
    roof = {ROOF: {"time": [0, 1, 2, 4], "displacement": [0, 0.02, -0.01, 0]}}
    plain, turned = run(**roof), run(**{MODEL: general}, **roof)
    # Rounding, which droppers that slacken a step earlier or later may let grow.
    np.testing.assert_allclose(force(turned), force(plain), rtol=0, atol=1e-6)
    stroke = plain.dataset["mass_displacement"].diff("mass").values[:, 0, 0]
    np.testing.assert_allclose(
        turned.dataset["mass_displacement"].values[:, 0, 1], stroke, rtol=0, atol=1e-9
    )


def lifted(placement: Data, **head: Any) -> Data:
    model = placement["model"]
    return {**model, "masses": [model["masses"][0], {**model["masses"][1], **head}]}


def test_a_lift_table_of_the_square_law_is_the_square_law(run: Run, placement: Data) -> None:
    speed = 160 / 3.6
    table = {"speed": [0.0, speed, 60.0], "force": [0.0, 0.01 * speed**2, 36.0]}
    square = run(**{MODEL: lifted(placement, aerodynamic=0.01)})
    listed = run(**{MODEL: lifted(placement, lift=table)})
    # At a point of the table: rounding only.
    np.testing.assert_allclose(force(listed), force(square), rtol=0, atol=1e-6)
    assert np.max(np.abs(force(run()) - force(square))) > 10.0


def test_a_dense_lift_table_follows_the_square_law_of_a_changing_speed(
    run: Run, placement: Data
) -> None:
    profile = {"speed_profile": {"time": [0, 4], "speed": [30, 45]}}
    speeds = np.linspace(30.0, 45.0, 151)
    table = {"speed": speeds.tolist(), "force": (0.01 * speeds**2).tolist()}
    square = run(**{MODEL: lifted(placement, aerodynamic=0.01)}, **profile)
    listed = run(**{MODEL: lifted(placement, lift=table)}, **profile)
    # Chords of 0.1 m/s miss 0.01 · 0.1²/8 N; droppers that slacken make it ten times as much.
    np.testing.assert_allclose(force(listed), force(square), rtol=0, atol=1e-3)


@pytest.mark.parametrize(
    ("speed", "change"),
    [
        ([0, 40], {}),
        ([45, 50], {}),
        ([10, 50], {"speed_profile": {"time": [0, 9], "speed": [5, 30]}}),
    ],
)
def test_a_table_that_ends_before_the_speed_is_refused(
    short: Short, placement: Data, speed: list[float], change: Data
) -> None:
    model = lifted(placement, lift={"speed": speed, "force": [0, 10]})
    with pytest.raises(ModelError, match=r"masses\.1\.lift\.speed: the table does not reach"):
        short(**{MODEL: model}, **change)


def test_the_roof_follows_a_spline_and_its_derivative(short: Short) -> None:
    omega, points = 2 * pi * 1.5, np.linspace(0.0, 4.0, 401)
    over_time = {"time": points.tolist(), "displacement": (0.01 * np.sin(omega * points)).tolist()}
    scenario = short(**{ROOF: over_time})
    travel = trajectory.motion(scenario)
    base = pantographs.excitations(scenario, travel)[0].base
    assert base is not None
    height, rate = base.displacement, base.rate
    times = travel.time_step * np.arange(travel.steps + 1)
    assert base.influence == [1.0, 1.0]
    # Error of the spline: 5/384 (ωΔ)⁴ = 1e-6 of the amplitude; of its slope (ωΔ)³/24 = 4e-5.
    np.testing.assert_allclose(height, 0.01 * np.sin(omega * times), rtol=0, atol=2e-8)
    np.testing.assert_allclose(
        rate, 0.01 * omega * np.cos(omega * times), rtol=0, atol=5e-5 * 0.01 * omega
    )
    # The same wave over the line is met at the same times.
    speed = scenario.speed or 0.0
    over_line = {"position": (50 + speed * points).tolist(), **over_time, "time": None}
    scenario = short(**{ROOF: over_line})
    along = pantographs.excitations(scenario, travel)[0].base
    assert along is not None
    # Round-off of places of 1e2 m times slopes of 1e-2, and of rates 1e3 times that.
    np.testing.assert_allclose(along.displacement, height, rtol=0, atol=1e-12)
    np.testing.assert_allclose(along.rate, rate, rtol=0, atol=1e-9)


def test_trailing_pantographs_meet_the_roof_motion_of_their_own_place(short: Short) -> None:
    bump = {"position": [0, 60, 61, 300], "displacement": [0, 0, 0.01, 0]}
    scenario = short(**{ROOF: bump})
    travel = trajectory.motion(scenario)
    assert scenario.pantographs[0].roof_motion is not None
    near, _ = pantographs.roof(scenario.pantographs[0].roof_motion, travel, 0.0)
    far, _ = pantographs.roof(scenario.pantographs[0].roof_motion, travel, 10.0)
    behind = round(10.0 / (travel.positions[1] - travel.positions[0]))
    # 10 m are not whole steps: less than half a step of 0.09 m on slopes below 0.02.
    np.testing.assert_allclose(far[behind:], near[:-behind], rtol=0, atol=1e-3)


def test_a_roof_that_shakes_is_felt_and_one_that_stands_is_not(run: Run, tmp_path: Path) -> None:
    still = run(**{ROOF: {"time": [0, 4], "displacement": [0.1, 0.1]}})
    # The preload is set with the roof where it starts.
    np.testing.assert_allclose(force(still), force(run()), rtol=0, atol=1e-6)
    times = np.linspace(0.0, 3.5, 176)
    height = 20 * np.sin(2 * pi * times)
    rows = [f"{1e3 * t:.0f}, {z!r}" for t, z in zip(times, height.tolist(), strict=True)]
    file = tmp_path / "roof.csv"
    file.write_text("\n".join(["# measured", "time [ms], displacement [mm]", *rows]), "utf-8")
    shaken = run(**{ROOF: {"file": str(file)}})
    kept = shaken.scenario.pantographs[0].roof_motion
    assert kept is not None and kept.time is not None
    assert kept.time[1] == 0.02 and len(kept.displacement) == 176
    # Damper and spring of the base: |50 + i ω 90| N/m · 20 mm = 11 N, less what the frame yields.
    added = np.max(np.abs(force(shaken) - force(run())))
    assert 2.0 < added < 40.0
    # Loaded again without the file: the points are part of the scenario.
    file.unlink()
    assert shaken.scenario.with_(speed="170 km/h").pantographs[0].roof_motion == kept


def test_bump_stops_limit_the_stroke(run: Run, placement: Data) -> None:
    weak = {"stiffness": 800.0}
    free = run(**{MODEL: lifted(placement, **weak)})
    assert free.metadata.get("stop_force_max") is None
    gaps = {"below": "4 mm", "above": "6 mm"}
    limits = {"stops": {**gaps, "stiffness": "2 MN/m"}}
    held = run(**{MODEL: lifted(placement, **weak, **limits)})

    def stroke(result: Result) -> np.ndarray:
        return result.dataset["mass_displacement"].diff("mass").values[:, 0, 0]

    highest = held.metadata["stop_force_max"]["P1"]
    assert np.min(stroke(free)) < -6e-3, "without stops it goes further"
    assert highest > 5.0
    # The stop yields by force over stiffness.
    assert np.min(stroke(held)) > -4e-3 - highest / 2e6 - 1e-9
    assert np.max(stroke(held)) < 6e-3 + highest / 2e6 + 1e-9


def test_stops_open_by_the_motion_between_a_mass_and_what_is_below(placement: Data) -> None:
    limits = {"below": 0.01, "above": 0.02, "stiffness": 1e6}
    model = lifted(placement, stops=limits)
    model["masses"][0] = {**model["masses"][0], "stops": {"below": 0.3, "stiffness": "rigid"}}
    assert stops_and_friction.stops(load_pantograph(model)) == [
        ([1.0, 0.0], 0.3, inf),
        ([-1.0, 1.0], 0.01, 1e6),
        ([1.0, -1.0], 0.02, 1e6),
    ]


def test_four_pantographs_run(run: Run, placement: Data) -> None:
    line = {
        "line.spans": [{"type": "span", "count": 10}],
        "travel": {"start": "155 m", "end": "300 m"},
        "analysis": {"from": "160 m", "to": "185 m"},
    }
    spacings = [0.0, 30.0, 65.0, 100.0]
    four = [{**placement, "name": "", "distance": distance} for distance in spacings]
    result = run(**line, pantographs=four)
    assert list(result.dataset["pantograph"].values) == ["P1", "P2", "P3", "P4"]
    assert force(result).shape[1] == 4
    # Round-off of places of some 1e2 m.
    position = result.dataset["position"].values
    np.testing.assert_allclose(position[:, :1] - position, [spacings] * len(position), atol=1e-9)
    assert len(result.assessment.pantographs) == 4
    for index in range(4):
        # All start in equilibrium with the same force; the first instant is half a step later.
        assert force(result)[0, index] == pytest.approx(80.0, abs=2.0)
    # The base spring gives back 50 N/m times some centimetres.
    means = [entry.mean_force_N for entry in result.assessment.pantographs]
    np.testing.assert_allclose(means, 80.0, atol=4.0)
