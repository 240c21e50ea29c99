"""Properties that any run must have: the same bits again, symmetry, distance, dimension."""

from collections.abc import Callable

import numpy as np

import arcless
from arcless.results import Result
from arcless.simulate import StaticsResult

RunOnce = Callable[..., Result]
AtRest = Callable[..., StaticsResult]

SHORT = {"travel.end": "600 m", "analysis.spans": [4, 9]}
FORCE = {"pantographs.0.static_force": 170.0}


def test_rerun_gives_the_same_bits(run_once: RunOnce) -> None:
    changes = {**FORCE, **SHORT}
    first = run_once("en50318-ac-simple-320", changes)
    second = arcless.run(arcless.load("en50318-ac-simple-320").with_(**changes))
    assert set(first.dataset) == set(second.dataset)
    for name in first.dataset:
        assert first.dataset[name].values.tobytes() == second.dataset[name].values.tobytes(), name


def test_mirrored_stagger_mirrors_the_run(run_once: RunOnce) -> None:
    runs = [
        run_once(
            "ac-simple-3d-320",
            {
                **FORCE,
                **SHORT,
                "line.geometry.stagger_contact_wire": [side, -side],
                "line.geometry.stagger_messenger_wire": [0.0],
            },
        ).dataset
        for side in (0.2, -0.2)
    ]
    lateral = [data["contact_lateral"].values for data in runs]
    assert np.ptp(lateral[0]) > 0.35  # the strip does sweep from side to side
    # Mirroring changes signs only; sums in another order leave rounding, which thousands of steps
    # and slack droppers make larger: a ten-thousandth of a newton is still nothing.
    np.testing.assert_allclose(lateral[0], -lateral[1], rtol=0, atol=1e-9)
    force = [data["contact_force"].values for data in runs]
    np.testing.assert_allclose(force[0], force[1], rtol=0, atol=1e-4)
