"""Rainflow counting, against the example of ASTM E1049."""

import importlib.util

import numpy as np
import pytest

from arcless.assess.wire_stress.cycles import Cycles
from arcless.errors import ModelError, OutputError

# The example of ASTM E1049-85, figure 6 (mark C), as many texts have it.
EXAMPLE = [-2.0, 1.0, -3.0, 5.0, -1.0, 3.0, -4.0, 4.0, -2.0]
COUNTS = {3.0: 0.5, 4.0: 1.5, 6.0: 0.5, 8.0: 1.0, 9.0: 0.5}


def test_the_example_of_the_standard() -> None:
    found = Cycles.of(EXAMPLE)
    by_range = {span: found.counts[found.ranges == span].sum() for span in set(found.ranges)}
    assert by_range == COUNTS
    assert found.largest == 9.0
    assert found.count == 4.0


def test_the_equivalent_range_of_known_cycles() -> None:
    # Ten full waves of 2 between two turning points that count as halves: 10 cycles in all.
    wave = np.sin(np.arange(0.0, 20.5 * np.pi, np.pi / 2.0)) * 1e6
    found = Cycles.of(wave)
    full = found.ranges > 1.5e6
    assert found.equivalent_range(5.0) == pytest.approx(
        2e6 * (found.counts[full].sum() + 0.5**5 * found.counts[~full].sum()) ** 0.2
    )
    by_hand = sum(count * span**3 for span, count in COUNTS.items()) ** (1.0 / 3.0)
    assert Cycles.of(EXAMPLE).equivalent_range(3.0) == pytest.approx(by_hand)
    # A steep line sees the largest range alone: its half cycle, (1/2)^(1/30).
    assert Cycles.of(EXAMPLE).equivalent_range(30.0) == pytest.approx(9.0, rel=0.03)


def test_nothing_cycles_in_a_constant() -> None:
    found = Cycles.of(np.full(100, 3e7))
    assert (found.largest, found.count, found.equivalent_range(5.0)) == (0.0, 0.0, 0.0)


@pytest.mark.parametrize("exponent", [0.0, -3.0, 31.0, float("nan"), float("inf")])
def test_what_is_no_exponent_is_refused(exponent: float) -> None:
    with pytest.raises(ModelError, match="expected a number, 1 to 30"):
        Cycles.of(EXAMPLE).equivalent_range(exponent)


def test_a_missing_package_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("arcless.assess.wire_stress.cycles.find_spec", lambda _name: None)
    with pytest.raises(OutputError, match=r"pip install 'arcless\[fatigue\]'"):
        Cycles.of(EXAMPLE)
    assert importlib.util.find_spec("rainflow") is not None
