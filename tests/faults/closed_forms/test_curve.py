"""Faults that the checks of a wire in a curve notice."""

from collections.abc import Callable

import pytest

from tests.support.evidence import Evidence
from tests.support.faults import curve_as_a_load, scaled
from tests.verification.closed_forms import test_curve as checks

Noticed = Callable[..., None]


@pytest.mark.parametrize("kind", checks.KINDS)
def test_curve_as_a_load(noticed: Noticed, kind: str) -> None:
    def one(evidence: Evidence) -> None:
        checks.test_one_span(kind, evidence)

    def two(evidence: Evidence) -> None:
        checks.test_two_spans(kind, 9.81, evidence)

    with curve_as_a_load():
        noticed(f"curves as loads, wires stretch as they seem to bend, {kind}, one span", one)
        noticed(f"the same, two spans, {kind}", two)


def test_curve_2_percent_tighter(noticed: Noticed) -> None:
    def two(evidence: Evidence) -> None:
        checks.test_two_spans("wires", 9.81, evidence)

    with scaled("turns", "turn", 1.02):
        noticed("track turns by 2 % more than the supports stand for", two)
