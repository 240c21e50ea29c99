"""Two pantographs: a run of one says which spacing is worst

The second pantograph, d behind, meets the displacement that the first one left, `w(x; d) = u(x,
(x + d)/v)`. To first order its force is `F₂ = F₁ − K w` with `1/K = 1/K_p + 1/(iΩZ) + 1/k_c`:
pantograph, wire without supports under a moving force, contact (derived here, D). Waves that run
back in the wake of a line of equal spans have `f = n v/(L (1 + v/c))`, a delay `d/(c + v)`, so σ²
goes up and down over d with the period v/f.

Asked of AC simple at 320 km/h, planar: one run of a single pantograph with the motion of the
wire, and runs of two pantographs at 20 spacings, which the wake knows nothing of. All lines of
the library are on the page spacing.
"""

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any
from unittest.mock import patch

import numpy as np
import pytest

from tests.support.docs import from_docs
from tests.support.evidence import Evidence
from tests.support.faults import Fault

lines, wake = from_docs("spacing_lines"), from_docs("wake")

SETTING = lines.Setting("en50318-ac-simple-320-planar")


def told() -> Any:
    """Return σ in N to first order at the spacings of the runs."""
    behind = lines.wake(SETTING)
    return np.array([behind.deviation(behind.second_force(d)) for d in SETTING.spacings])


@pytest.mark.evidence
def test_the_wake_of_one_says_what_two_do(evidence: Evidence) -> None:
    found, sigma = lines.curve(SETTING).trailing, told()
    evidence.within(
        "correlation of σ over 20 spacings with that of first order",
        float(np.corrcoef(sigma, found)[0, 1]),
        0.8,
        1.0,
        unit="1",
        reason="first order leaves out that the second pantograph swings the line, too; a curve"
        " half a span off has 0.2 or less",
    )
    evidence.within(
        "σ at the spacing that is worst to first order, over the worst found",
        float(found[np.argmax(sigma)] / found.max()),
        0.8,
        1.0,
        unit="1",
        reason="the crest is flat; the mean over all is 0.7",
    )
    evidence.within(
        "σ at the spacing that is best to first order, over the mean of all",
        float(found[np.argmin(sigma)] / found.mean()),
        0.2,
        0.8,
        unit="1",
        reason="it must lie in the trough",
    )


@pytest.mark.evidence
def test_the_frequency_of_the_wake_is_that_of_the_spacing(evidence: Evidence) -> None:
    behind, found = lines.wake(SETTING), lines.curve(SETTING)
    period = lines.spacing_period(found.spacings, found.trailing)
    evidence.close(
        "v over the period of σ² against f of the wake with one wave in a span",
        period.frequency(SETTING.speed),
        behind.frequency(1, lines.WAKE, SETTING.length),
        unit="Hz",
        relative=0.06,
        reason="20 spacings over two and a half periods: 190 m give a period to some per cent",
    )
    evidence.within(
        "f of the wake with three waves over three times v/(L (1 + v/c))",
        behind.frequency(3, lines.WAKE, SETTING.length) / (3.0 * lines.free_wave(SETTING)),
        1.0,
        1.15,
        unit="1",
        reason="droppers and the messenger wire make short waves faster than those of the free"
        " contact wire; waves that ran ahead would have a ratio above 4",
    )


_displacement = wake.Wake.displacement
_stiffness = wake.Wake.__dict__["stiffness"].func


def _later(self: Any, distance: float) -> Any:
    return _displacement(self, distance + 0.5 * SETTING.length)


def _upside_down(self: Any) -> Any:
    return -_stiffness(self)


@contextmanager
def _ahead() -> Iterator[None]:
    """Tell frequencies of another speed."""
    with patch.object(wake.Wake, "speed", 1.3 * SETTING.speed):
        yield


FAULTS = [
    Fault("the wake is met half a span too late", patch.object(wake.Wake, "displacement", _later),
          test_the_wake_of_one_says_what_two_do, slow=True),
    Fault("the wire pulls where it is raised",
          patch.object(wake.Wake, "stiffness", property(_upside_down)),
          test_the_wake_of_one_says_what_two_do, slow=True),
    Fault("the wake is met at 1.3 times the speed", _ahead(),
          test_the_frequency_of_the_wake_is_that_of_the_spacing, slow=True),
]  # fmt: skip
