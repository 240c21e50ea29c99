"""The collector head: where the wire lies, and where friction wears the strip."""

from dataclasses import replace

import numpy as np
import pytest

from arcless.assess import assess
from arcless.figures.description import Bars, Curve, Rules
from arcless.figures.run import head
from arcless.figures.run.run_data import RunData
from tests.support.synthetic import scenario_data, synthetic_dataset

SECTION = (100.0, 500.0)


def run_of(lateral, force=lambda t: np.full_like(t, 100.0), **more) -> RunData:
    dataset = synthetic_dataset(section=SECTION, stagger_m=0.2, force=force, **more)
    x = dataset["position"].values
    dataset["contact_lateral"].values[:] = lateral(x)
    return RunData(dataset, assess(dataset))


def zigzag(x):
    """From -200 to 200 mm over 100 m and back: each place as long as any other."""
    return 0.2 * (2.0 * np.abs((x / 100.0) % 2.0 - 1.0) - 1.0)


def test_even_zigzag_wears_evenly() -> None:
    (figure,) = head.wear_pattern(run_of(zigzag))
    (bars,) = [layer for layer in figure.layers if isinstance(layer, Bars)]
    inside = bars.high[(bars.left >= -200.0 - 1e-9) & (bars.right <= 200.0 + 1e-9)]
    # 20 parts of 20 mm; a sample of 0.02 m more or less in a part of 5 m, four times.
    np.testing.assert_allclose(inside, 100.0 / 20.0, rtol=5e-3)
    assert bars.high.sum() == pytest.approx(100.0, rel=1e-12)  # rounding


def test_twice_the_force_wears_twice_as_much() -> None:
    # 150 N where the wire is on the left, 75 N on the right; the distances stay the same.
    run = run_of(zigzag, lambda t: np.where(zigzag(20.0 * t) > 0.0, 150.0, 75.0))
    (figure,) = head.wear_pattern(run)
    (bars,) = [layer for layer in figure.layers if isinstance(layer, Bars)]
    left, right = bars.high[bars.left >= -1e-9].sum(), bars.high[bars.right <= 1e-9].sum()
    assert left / right == pytest.approx(2.0, rel=5e-3)  # samples at the ends, as above
    (distance,) = [layer for layer in figure.layers if isinstance(layer, Curve)]
    assert distance.y[distance.x > 0.0].sum() == pytest.approx(
        distance.y[distance.x < 0.0].sum(), rel=5e-3
    )


def test_limits_are_drawn_where_there_are_some() -> None:
    def limits(run: RunData) -> list[Rules]:
        (figure,) = head.lateral(run)
        rules = [layer for layer in figure.layers if isinstance(layer, Rules)]
        return [layer for layer in rules if layer.name.startswith("limit")]

    assert limits(run_of(zigzag)) == []  # the drawn pantograph has no head
    data = scenario_data()
    data["pantographs"][0]["model"]["head_width"] = 1.6
    (limit,) = limits(run_of(zigzag, scenario=data))
    np.testing.assert_allclose(limit.at, [-400.0, 400.0])


def test_a_planar_run_has_no_lateral_position() -> None:
    run = run_of(zigzag)
    planar = [vars(p) | {"max_lateral_position_mm": None} for p in run.assessment.pantographs]
    assessment = replace(
        run.assessment, pantographs=[type(run.assessment.pantographs[0])(**p) for p in planar]
    )
    assert head.lateral(RunData(run.dataset, assessment)) == []
    assert head.wear_pattern(RunData(run.dataset, assessment)) == []
