"""The wave of the synthetic motion is a solution of the wave equation."""

import numpy as np
import pytest

from arcless.studio.motion.synthetic import SyntheticMotion

WAVE = SyntheticMotion(nodes=400, every_s=0.01, end_s=2.0)


def test_it_runs_at_the_wave_speed_and_keeps_its_form() -> None:
    [early] = WAVE.moments(1.0, 1.0, 0.0)
    [late] = WAVE.moments(1.5, 1.5, 0.0)
    # 0.5 s at 100 m/s are 50 nodes of 1 m; singles have 7 digits.
    np.testing.assert_allclose(late[0].values[150:], early[0].values[100:350], rtol=1e-5)


def test_its_top_is_above_the_pantograph() -> None:
    for wire, pantograph in WAVE.moments(0.0, 2.0, 0.1):
        assert int(wire.values.argmax()) == pytest.approx(float(pantograph.values[0]), abs=0.5)


def test_times_are_those_asked_for() -> None:
    times = [moment[0].time_s for moment in WAVE.moments(0.5, 1.0, 0.05)]
    assert times == pytest.approx(np.arange(0.5, 1.01, 0.05))
