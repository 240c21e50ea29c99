"""Whole runs on a short line: records, options, contact laws, several pantographs."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import arcless
from arcless.model import Scenario
from arcless.results import Result

Short = Callable[..., Scenario]
Run = Callable[..., Result]


def test_shapes_and_names(run: Run) -> None:
    data = run().dataset
    steps = run().metadata["steps"]
    assert data.sizes["time"] == steps + 1 or data.sizes["time"] == steps
    assert data["mass_displacement"].shape == (data.sizes["time"], 1, 2)
    assert data.sizes["dropper"] == 30
    assert data["support"].values.tolist() == [f"support {i}" for i in range(1, 8)]
    assert data["pantograph"].values.tolist() == ["P1"]
    assert np.all(np.diff(data["position"].values[:, 0]) > 0)
    assert data["speed"].values == pytest.approx(160 / 3.6)


def test_decimation_takes_every_nth(run: Run) -> None:
    whole, thin = run().dataset, run(**{"output.contact_every": 4, "output.line_every": 20}).dataset
    np.testing.assert_array_equal(thin["time"], whole["time"][::4][: thin.sizes["time"]])
    kept = np.isin(whole["time"].values, thin["time"].values)
    np.testing.assert_array_equal(thin["contact_force"], whole["contact_force"][kept])
    assert abs(thin.sizes["line_time"] * 4 - whole.sizes["line_time"]) <= 4
    # Extremes come from every step, whatever is recorded.
    for name in ("support_uplift_max", "dropper_force_max", "dropper_force_min"):
        np.testing.assert_array_equal(thin[name], whole[name])


def test_channels_can_be_left_out(run: Run) -> None:
    data = run(**{"output.droppers": False, "output.supports": False}).dataset
    assert "dropper_force" not in data
    assert "support_uplift" not in data
    assert data["dropper_force_max"].size == 30


def test_points(run: Run) -> None:
    data = run(**{"output.points": ["100 m", "115 m"]}).dataset
    assert data["point"].values.tolist() == ["100 m", "115 m"]
    uplift = data["point_uplift"].values
    # The point at the third support is that support.
    np.testing.assert_allclose(uplift[:, 0], data["support_uplift"].values[:, 2], atol=1e-12)
    # When the pantograph passes the dropper at 115 m, the strip is at that point of the wire,
    # which hangs 5.3 m high at rest; 4 mm are what the wire moves between two records.
    passing = (115.0 - 50.0) / (160 / 3.6)
    at_point = np.interp(passing, data["line_time"], uplift[:, 1])
    at_strip = np.interp(passing, data["time"], data["contact_height"].values[:, 0])
    assert 5.3 + at_point == pytest.approx(at_strip, abs=4e-3)


@pytest.mark.parametrize(
    ("wanted", "scheme", "kept"),
    [
        ("auto", "generalised-alpha", False),
        ("auto", "trapezoidal", True),
        ("always", "generalised-alpha", True),
        ("never", "trapezoidal", False),
    ],
)
def test_energy_ledger_is_kept_when_asked_for(
    run: Run, wanted: str, scheme: str, kept: bool
) -> None:
    result = run(**{"output.energy": wanted, "solver.scheme": scheme})
    assert ("energy_kinetic" in result.dataset) is kept
    residual = result.metadata["energy_residual_relative"]
    assert (residual is not None) is kept
    if kept:
        assert residual <= 1e-9  # the project's bound


def test_the_ledger_changes_no_result(run: Run) -> None:
    with_, without = run(**{"output.energy": "always"}), run(**{"output.energy": "never"})
    for name in ("contact_force", "contact_height", "dropper_force"):
        np.testing.assert_array_equal(with_.dataset[name], without.dataset[name])


def test_the_run_starts_in_equilibrium(run: Run) -> None:
    data = run(**{"pantographs.0.static_force": 75.0}).dataset
    force = data["contact_force"].values[:, 0]
    # One step of 2 ms at full speed after the static contact with 75 N.
    assert force[0] == pytest.approx(75.0, rel=0.02)
    assert np.max(np.abs(data["mass_displacement"].values[0])) < 1e-3
    assert data["contact_gap"].values.max() == 0.0


def test_aerodynamic_force_adds_to_the_static_one(run: Run, placement: dict[str, Any]) -> None:
    head = {**placement["model"]["masses"][1], "aerodynamic": 0.01}
    masses = [placement["model"]["masses"][0], head]
    data = run(**{"pantographs.0.model.masses": masses}).dataset
    lift = 0.01 * (160 / 3.6) ** 2
    # The first record is one step after rest, when the line has begun to move: 0.1 %.
    assert data["contact_force"].values[0, 0] == pytest.approx(80.0 + lift, rel=0.02)


@pytest.mark.parametrize("target", [60.0, 90.0])
def test_mean_force_is_reached(run: Run, target: float) -> None:
    result = run(**{"pantographs.0.mean_force": target})
    mean = result.assessment.pantographs[0].mean_force_N
    assert mean == pytest.approx(target, abs=0.02)  # the tolerance the search documents
    assert result.metadata["static_force_found"]["P1"] != target


def test_mean_force_search_leaves_no_trace(run: Run) -> None:
    searched = run(**{"pantographs.0.mean_force": 90.0})
    found = searched.metadata["static_force_found"]["P1"]
    given = run(**{"pantographs.0.static_force": found})
    # The force is stored with six decimals, so the runs differ by less than a millionth of it.
    difference = searched.dataset["contact_force"] - given.dataset["contact_force"]
    assert float(np.abs(difference).max()) < 1e-3


def test_pantographs_with_different_numbers_of_masses(run: Run, placement: dict[str, Any]) -> None:
    three = {"model": "ac-simple", "static_force": 80.0, "distance": "30 m", "name": "rear"}
    data = run(pantographs=[{**placement, "name": "front"}, three], travel={"end": "250 m"}).dataset
    assert data["pantograph"].values.tolist() == ["front", "rear"]
    assert data["mass_displacement"].shape[1:] == (2, 3)
    assert np.all(np.isnan(data["mass_displacement"].values[:, 0, 2]))
    assert np.all(np.isfinite(data["mass_displacement"].values[:, 1]))
    position = data["position"].values
    np.testing.assert_allclose(position[:, 0] - position[:, 1], 30.0)
    assert np.all(data["contact_force"].values[:, 1] >= 0)
    assert not np.allclose(data["contact_force"].values[:, 0], data["contact_force"].values[:, 1])


def test_trailing_pantograph_may_ask_for_a_mean_force(run: Run, placement: dict[str, Any]) -> None:
    rear = {**placement, "static_force": None, "mean_force": 70.0, "distance": 60.0, "name": "rear"}
    result = run(
        pantographs=[{**placement, "name": "front"}, rear],
        travel={"end": "250 m"},
        analysis={"from": "120 m", "to": "185 m"},
    )
    forces = result.metadata["static_force_found"]
    assert forces["front"] == 80.0
    # What the search for a mean force promises.
    assert result.assessment.pantographs[1].mean_force_N == pytest.approx(70.0, abs=0.02)


def test_rigid_contact(run: Run) -> None:
    # With a spectral radius of 0.9 both ring, and 10 MN/m and 10.001 MN/m already differ by 2 %.
    quiet = {"solver.scheme": {"name": "generalised-alpha", "spectral_radius": 0.0}}
    rigid = run(**{"contact.law": "rigid"}, **quiet)
    stiff = run(**{"contact.stiffness": "10 MN/m"}, **quiet)
    force = rigid.dataset["contact_force"].values
    assert np.all(np.isfinite(force))
    assert np.all(force >= 0)
    gap = rigid.dataset["contact_gap"].values
    assert np.all((gap == 0) | (force == 0))
    one, other = (r.assessment.pantographs[0] for r in (rigid, stiff))
    # A contact of 10 MN/m is 200 times stiffer than the usual one: the limit is near.
    assert one.mean_force_N == pytest.approx(other.mean_force_N, rel=1e-4)
    assert one.std_force_N == pytest.approx(other.std_force_N, rel=5e-3)


def test_friction_pulls_the_wire_along(run: Run) -> None:
    plain = run(**{"output.energy": "always"})
    rubbed = run(**{"output.energy": "always", "contact.friction_coefficient": 0.3})
    assert np.all(plain.dataset["energy_work_friction"] == 0)
    assert float(np.abs(rubbed.dataset["energy_work_friction"]).max()) > 0
    means = [r.assessment.pantographs[0].mean_force_N for r in (plain, rubbed)]
    # Friction is no vertical force; the wire's slope, below 1e-3, makes a little of one of it.
    assert means[1] == pytest.approx(means[0], rel=1e-3)


def test_speed_profile_runs(run: Run) -> None:
    profile = {"time": [0.0, 1.0, 4.0], "speed": ["80 km/h", "160 km/h", "120 km/h"]}
    data = run(speed_profile=profile, analysis={"from": 60, "to": 150}).dataset
    speed = data["speed"].values
    # The knot of the profile may lie between two records of 2 ms.
    assert speed.max() == pytest.approx(160 / 3.6, rel=1e-3)
    moved = np.diff(data["position"].values[:, 0])
    # Knots are on the grid, so the trapezium is exact: rounding of places of 1e2 m over 0.1 m.
    np.testing.assert_allclose(moved, (speed[1:] + speed[:-1]) / 2 * 2e-3, rtol=1e-6)


def test_droppers_that_cannot_slacken_stay_taut(run: Run) -> None:
    push = {"pantographs.0.static_force": 250.0}
    limp, stiff = run(**push), run(**push, **{"line.dropper.slackens": False})
    assert limp.metadata["slack_droppers_max"] > 0
    assert float(limp.dataset["dropper_force_min"].min()) >= -1e-6
    assert stiff.metadata["slack_droppers_max"] == 0
    assert float(stiff.dataset["dropper_force_min"].min()) < 0


def test_progress_rises_and_ends_with_1(short: Short) -> None:
    told: list[tuple[float, str]] = []
    found = arcless.run(short(), progress=lambda fraction, text: told.append((fraction, text)))
    assert told[-1] == (1.0, "done")
    phases = list(dict.fromkeys(text.partition(",")[0] for _, text in told))
    assert phases == [
        "finding the line at rest", "preparing the steps", "stepping",
        "finding the elasticity of the line", "done",
    ]  # fmt: skip
    length = found.metadata["simulated_time_s"]
    for fraction, text in told:
        if text.startswith("stepping"):
            assert text == f"stepping, {fraction * length:.1f} of {length:.1f} s"
    fractions = [fraction for fraction, _ in told]
    assert fractions == sorted(fractions)
    assert all(0 <= fraction <= 1 for fraction in fractions)


def test_cancel_ends_the_run(short: Short) -> None:
    asked: list[int] = []

    def cancel() -> bool:
        asked.append(1)
        return len(asked) > 2

    with pytest.raises(KeyboardInterrupt):
        arcless.run(short(), cancel=cancel)
    assert len(asked) == 3


def test_metadata_tells_how_to_run_again(run: Run) -> None:
    facts = run().metadata
    assert facts["simulated_time_s"] == pytest.approx(facts["steps"] * 2e-3)
    assert facts["real_time_factor"] > 0
    assert facts["section_m"] == [60.0, 190.0]
    again = arcless.load(facts["scenario"])
    assert again.line == run().scenario.line
