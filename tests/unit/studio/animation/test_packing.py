"""Arrays as text: what comes back is what went in, to the step that is stated."""

from base64 import b64decode

import numpy as np
import pytest

from arcless.studio.animation.packing import FINEST, UNKNOWN, block, step_for


@pytest.mark.parametrize("largest", [1e-9, 3e-4, 0.05, 0.32767, 0.4, 12.0, 327.67])
def test_steps_are_plain_and_reach(largest: float) -> None:
    step = step_for(np.array([0.0, -largest, np.nan]))
    assert step >= FINEST
    assert largest / step <= 32767 * (1 + 1e-9)  # rounding of a quotient
    assert f"{step:e}"[0] in "125"
    # Not coarser than needed: a step of 1, 2, 5 is at most 2.5 times the least.
    assert step <= max(2.5 * largest / 32767, FINEST) * (1 + 1e-9)


def test_rows_of_different_lengths_come_back() -> None:
    values = np.array([[0.01, -0.02, 99.0], [0.03, np.nan, 0.0311]])
    packed = block("wire.0.up", np.array([4, 5]), np.array([2, 3]), values)
    integers = np.frombuffer(b64decode(packed["values"]), "<i2")
    assert len(integers) == 5
    assert integers[3] == UNKNOWN
    found = integers[[0, 1, 2, 4]] * packed["step"]
    # Rounded to the nearest integer.
    assert found == pytest.approx([0.01, -0.02, 0.03, 0.0311], abs=packed["step"] / 2 * (1 + 1e-9))
    assert np.frombuffer(b64decode(packed["count"]), "<u4").tolist() == [2, 3]
    assert np.frombuffer(b64decode(packed["first"]), "<u4").tolist() == [4, 5]


def test_positions_stay_singles() -> None:
    packed = block(
        "pantograph.0", np.array([0]), np.array([1]), np.array([[50_000.25]]), singles=True
    )
    assert packed["step"] is None
    assert np.frombuffer(b64decode(packed["values"]), "<f4").tolist() == [50_000.25]
