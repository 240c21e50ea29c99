"""Loads of supports and steady arms in time, against statics, springs and momentum."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import arcless
from arcless.errors import ModelError
from arcless.results import Result

Run = Callable[..., Result]
HOLDING = (
    "support_force",
    "support_lateral_force",
    "messenger_uplift",
    "steady_arm_force",
    "steady_arm_angle",
)
SPATIAL = "en50318-ac-simple-320"
PLANAR = f"{SPATIAL}-planar"
STIFFNESS, DAMPING = 5e5, 1e3  # of the messenger supports of both lines, N/m and N s/m


@pytest.fixture(scope="module")
def spatial() -> Result:
    return arcless.run(arcless.load(SPATIAL))


@pytest.fixture(scope="module")
def planar() -> Result:
    return arcless.run(arcless.load(PLANAR).with_(**{"output.line_every": 1}))


def test_the_first_row_is_the_line_at_rest(spatial: Result) -> None:
    data = spatial.dataset
    # Far ahead of the pantograph nothing moves in the first milliseconds.
    far = data["support_x"].values > 700.0
    far[-1] = False
    for name, at_rest in (
        ("support_force", "support_force_static"),
        ("steady_arm_force", "steady_arm_force_static"),
    ):
        # The pantograph far away stretches the wires between their fixed ends: 0.07 N of 1300.
        np.testing.assert_allclose(data[name][0, far], data[at_rest][far], atol=0.1)
    lateral = [
        one["messenger_wire_lateral_force_N"] for one in arcless.statics(spatial.scenario).supports
    ]
    # By the same stretch, 0.2 N of 16 kN · 4 · 0.2 m/55 m.
    np.testing.assert_allclose(
        data["support_lateral_force"][0, far], np.array(lateral, dtype=float)[far], atol=0.4
    )
    slope = spatial.scenario.line.steady_arm.slope
    # The design keeps the arm's slope at its node; wires settle by micrometres on 1 m.
    np.testing.assert_allclose(data["steady_arm_angle"][0, far], slope, atol=1e-3)
    assert np.isnan(data["support_force"][:, [0, -1]]).all()
    # Where wires are anchored nothing is held, at rest either.
    for name in ("support_force_static", "steady_arm_force_static"):
        np.testing.assert_array_equal(
            np.flatnonzero(np.isnan(data[name])), [0, data[name].size - 1]
        )


def test_a_planar_line_has_no_lateral_loads_nor_arms(planar: Result) -> None:
    there = [name for name in HOLDING if name in planar.dataset]
    assert there == ["support_force", "messenger_uplift"]


def test_the_load_is_that_of_spring_and_damper(planar: Result) -> None:
    """F = F₀ − k w − c ẇ with the motion w of the messenger wire."""
    data = planar.dataset
    middle, h = 10, float(data["line_time"].diff("line_time")[0])
    w, load = data["messenger_uplift"].values[:, middle], data["support_force"].values[:, middle]
    rate = np.gradient(w, h)
    expected = float(data["support_force_static"][middle]) - STIFFNESS * w - DAMPING * rate
    change = np.std(load)
    assert change > 50.0
    # The rate by differences over two steps misses 5 % of what is above 100 Hz, of 2 % of the load;
    # the damper acts on the node of the mesh, which moves 15 % more than the wire.
    assert np.std(load - expected) < 0.02 * change
    # Without the damper the difference shows.
    assert np.std(load - expected - DAMPING * rate) > 1.2 * np.std(load - expected)


def test_supports_and_arms_together_lose_what_the_pantograph_carries() -> None:
    """Momentum: over a passage, ∫ ΔF dt of a support and its arm is F_m L/v.

    Slowly, so that no waves remain at the end of the run.
    """
    data = arcless.run(arcless.load(SPATIAL).with_(speed="60 km/h")).dataset
    time, inner = data["line_time"].values, range(6, 13)
    lost = data["support_force_static"].values - data["support_force"].values
    arm, angle = data["steady_arm_force"].values, data["steady_arm_angle"].values
    # Row 0: the pantograph stands at the first supports.
    lift = (arm - arm[0]) * np.sin(angle[0]) + arm[0] * (np.sin(angle) - np.sin(angle[0]))
    expected = float(data["contact_force"].mean()) * 55.0 / (60 / 3.6)
    for i in inner:
        load = np.trapezoid(lost[:, i], time)
        # The arm turns by some degrees, of which this takes the first order: 4 N s of 560.
        assert load - np.trapezoid(lift[:, i], time) == pytest.approx(expected, rel=0.01)
        assert load < 0.97 * expected


@pytest.mark.parametrize("name", [PLANAR, SPATIAL])
def test_explicit_and_implicit_steps_agree(name: str) -> None:
    made = [
        arcless.run(arcless.load(name).with_(**{"solver.scheme": scheme})).dataset
        for scheme in ("central-difference", "generalised-alpha")
    ]
    for variable in HOLDING[: 2 if name == PLANAR else None]:
        if variable not in made[0]:
            continue
        times = made[1]["line_time"].values
        times = times[times < float(made[0]["line_time"][-1])]
        one, other = (
            np.interp(times, data["line_time"].values, data[variable].values[:, 10])
            for data in made
        )
        # Chains of points against cubic elements: 2 % of the variation, its highest waves apart.
        assert np.std(one - other) < 0.1 * np.std(one), variable


def test_updated_kinematics_have_the_forces_of_linearised_ones() -> None:
    """At an uplift of some centimetres the geometry changes an arm's force by a per cent."""
    base = arcless.load(SPATIAL).with_(
        **{
            "line.spans": [{"type": "standard", "count": 4}],
            "travel": {"start": "80 m", "end": "130 m"},
            "analysis": {"from": "90 m", "to": "120 m"},
            "solver.time_step": "2 ms",
            "solver.contact_wire_element": "1.5 m",
            "solver.messenger_wire_element": "3 m",
            "solver.scheme": "generalised-alpha",
            "solver.residual_flexibility": False,
        }
    )
    one, other = (
        arcless.run(base.with_(**{"solver.kinematics": kind})).dataset
        for kind in ("linearised", "updated")
    )
    for variable in HOLDING:
        a, b = one[variable].values[:, 2], other[variable].values[:, 2]
        if variable == "support_lateral_force":
            # Its change is of second order, as is the difference: a per cent of the force.
            np.testing.assert_allclose(a, b, rtol=0.01)
            continue
        # An arm of a metre turns by 3° at 5 cm of uplift, which changes a fifth of what changes;
        # a force with the wrong sign or stiffness would be off by all of it.
        assert np.std(a - b) < 0.25 * np.std(a), variable


def test_near_and_streamed_rows_are_those_of_the_whole_record(
    tmp_path: Path, spatial: Result
) -> None:
    scenario = arcless.load(SPATIAL).with_(**{"output.around": "60 m"})
    near = arcless.run(scenario, to=tmp_path / "near.nc")
    for quantity in HOLDING:
        assert quantity not in near.dataset
        cut = near.passage("support", "support 9", quantity)
        everything = spatial.passage("support", "support 9", quantity)
        assert 50 < cut.size < everything.size
        assert (cut == everything.sel(line_time=cut["line_time"])).all()
        assert cut.attrs == everything.attrs
    with pytest.raises(ModelError, match="did you mean steady_arm_force"):
        spatial.passage("support", "support 9", "steady_arm")
    with pytest.raises(ModelError, match=r"unknown series of a support.*dropper_force"):
        spatial.passage("support", "support 9", "dropper_force")


def test_rows_near_the_pantographs_are_in_the_order_along_the_track() -> None:
    """In an overlap the supports of two tension lengths alternate along the track."""
    base = arcless.load("ac-simple-overlap-275")
    begin, end = base.analysis_range()
    middle = 0.5 * (begin + end)
    changes = {
        "travel": {"start": f"{middle - 80} m", "end": f"{middle + 80} m"},
        "analysis": {"from": f"{middle - 60} m", "to": f"{middle + 60} m"},
    }
    whole = arcless.run(base.with_(**changes))
    near = arcless.run(base.with_(**changes, **{"output.around": "90 m"}))
    order = near.dataset["support_order"].values
    assert list(order) != sorted(order)
    assert near.dataset.sizes["near_support"] < len(order)
    compared = 0
    for name in whole.dataset["support"].values:
        cut = near.passage("support", str(name), "support_force")
        everything = whole.passage("support", str(name), "support_force")
        np.testing.assert_array_equal(cut, everything.sel(line_time=cut["line_time"]))
        compared += int(cut.size > 0 and not np.isnan(cut).any())
    assert compared > 3


def test_a_run_in_two_parts_has_the_same_rows(tmp_path: Path, spatial: Result) -> None:
    first = arcless.run(arcless.load(SPATIAL), until="500 m")
    first.save(tmp_path / "first.nc")
    whole = arcless.resume(arcless.open(tmp_path / "first.nc")).dataset
    for name in HOLDING:
        np.testing.assert_array_equal(whole[name], spatial.dataset[name])


def test_loads_can_be_left_out(run: Run) -> None:
    data = run(**{"output.supports": False}).dataset
    assert not [name for name in data if name in HOLDING or f"near_{name}" in data]


def test_supports_of_a_plan_that_do_not_fit_are_refused(spatial: Result) -> None:
    from arcless import _core
    from arcless.simulate.runs import job
    from arcless.simulate.runs.job import Job
    from arcless.simulate.setup.controllers import Controllers

    scenario = arcless.load(SPATIAL)
    laid_out = job.lay_out(scenario, Controllers(scenario), lambda *_: None, None)
    plan = Job._plan

    for spoilt in ([], [(0, 0, 10**6)], [(10**6, None, None)]):

        def wrong(self: Job, *, full: bool, spoilt: Any = spoilt) -> Any:
            from arcless.simulate.setup.core_data import SupportParts

            given = plan(self, full=full)
            parts = [SupportParts(*one) for one in spoilt] or [given.supports[0]]
            one_each = parts * len(given.nodes) if spoilt else parts
            return given._replace(supports=one_each)

        with pytest.MonkeyPatch.context() as patch, pytest.raises(Exception, match="supports"):
            patch.setattr(Job, "_plan", wrong)
            laid_out.step([0.0], full=True)
    assert _core.SERIES
