"""Where a force changes fastest, on forces that were drawn."""

import numpy as np
import pytest

from arcless.validate.hanger_joints import PIECE, joint_changes

SECTION = (50.0, 140.0)
JOINTS = np.arange(5.0, 300.0, 10.0)


def positions(step: float = PIECE) -> np.ndarray:
    return np.arange(5.0, 150.0 + step / 2, step)


def steps_at(x: np.ndarray, places: np.ndarray, size: float = 50.0) -> np.ndarray:
    """A force that rises by `size` over one element at each place, and falls slowly between."""
    since = (x - places[0]) % 10.0
    rise = np.minimum(since / PIECE, 1.0)
    return 100.0 + size * (rise - np.maximum(since - PIECE, 0.0) / (10.0 - PIECE))


def test_two_wires_held_at_one_place_have_one_joint_there() -> None:
    x = positions()
    force = steps_at(x, JOINTS)
    pairs = np.repeat(JOINTS, 2)
    assert joint_changes(x, force, pairs, SECTION) == joint_changes(x, force, JOINTS, SECTION)


@pytest.mark.parametrize("late", [-0.5, -0.25, 0.0, 0.25])
def test_steps_at_joints_are_located(late: float) -> None:
    x = positions()
    found = joint_changes(x, steps_at(x, JOINTS + late), JOINTS, SECTION)
    assert [joint.x for joint in found.joints] == list(range(55, 136, 10))
    assert found.located == 9
    for joint in found.joints:
        # The middle of the element that begins where the step does; exact up to round-off of x.
        assert joint.fastest == joint.place == pytest.approx(joint.x + late + PIECE / 2, abs=1e-9)
        assert joint.change == pytest.approx(50.0, rel=1e-9)
        assert joint.elsewhere == pytest.approx(50.0 / 39, rel=1e-9)  # 39 further elements
    assert found.least_ratio == pytest.approx(39.0, rel=1e-9)


@pytest.mark.parametrize("late", [-5.0, -0.75, 0.5, 2.0])
def test_steps_beside_joints_are_not(late: float) -> None:
    x = positions()
    found = joint_changes(x, steps_at(x, JOINTS + late), JOINTS, SECTION)
    assert found.located == 0
    assert found.least_ratio < 1.0
    assert found.rms_ratio < 1.0


def test_one_joint_without_its_change_is_told_from_eight_with_it() -> None:
    x = positions()
    force = steps_at(x, JOINTS)
    force[(x > 80.0) & (x < 90.0)] = 100.0
    found = joint_changes(x, force, JOINTS, SECTION)
    assert found.located == 8
    assert found.least_ratio < 1.0 < found.rms_ratio


@pytest.mark.parametrize("period", [2.5, 5.0, 10.0, 90.0])
@pytest.mark.parametrize("phase", np.linspace(0.0, np.pi, 7))
def test_a_sine_of_the_place_is_never_fast(period: float, phase: float) -> None:
    x = positions()
    force = 100.0 + 40.0 * np.sin(2 * np.pi * x / period + phase)
    # √2 from steepest place to root mean square; to that of the rest, without what is near, more.
    assert joint_changes(x, force, JOINTS, SECTION).rms_ratio < 1.6


def test_noise_is_not_located() -> None:
    x = positions()
    force = np.random.default_rng(3).normal(100.0, 20.0, x.size)
    found = joint_changes(x, force, JOINTS, SECTION)
    assert found.located < 5  # one in ten by chance: 5 of 9 has a probability of 0.001
    assert found.rms_ratio < 1.5


def test_a_finer_record_gives_the_same_numbers() -> None:
    coarse, fine = (
        joint_changes(x, steps_at(x, JOINTS), JOINTS, SECTION)
        for x in (positions(), positions(0.05))
    )
    # The finer record lies on the same straight pieces: round-off of differences, 1e-10.
    assert fine.rms_ratio == pytest.approx(coarse.rms_ratio, rel=1e-9)
    assert fine.least_ratio == pytest.approx(coarse.least_ratio, rel=1e-9)


def test_a_constant_force_changes_nowhere() -> None:
    x = positions()
    found = joint_changes(x, np.full_like(x, 100.0), JOINTS, SECTION)
    assert (found.located, found.least_ratio, found.rms_ratio) == (0, 0.0, 0.0)


def test_a_section_without_joints_has_none() -> None:
    x = positions()
    found = joint_changes(x, steps_at(x, JOINTS), JOINTS, (56.0, 64.0))
    assert found.joints == ()
    assert found.rms_ratio == 0.0
