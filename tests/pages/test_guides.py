"""Guides print what is found."""

import re
from collections.abc import Callable

import numpy as np

from arcless.simulate import StaticsResult
from tests.support.pages import DOCS

AtRest = Callable[..., StaticsResult]
PLAIN = {"line.bridle": None, "line.steady_arm": {"kind": "none"}}


def printed(page: str, name: str) -> list[float]:
    """Return the numbers of a row of a guide's tables."""
    text = (DOCS / "guide" / f"{page}.md").read_text(encoding="utf-8")
    (row,) = re.findall(rf"\| {re.escape(name)} \| (.*) \|", text)
    return [float(value) for value in row.split(" | ")]


def test_line_types(at_rest: AtRest) -> None:
    columns = [at_rest("norway-s25-250"), at_rest("norway-s25-250", {"line.stitch_wire": None})]
    elasticities = [1e3 * np.array(found.elasticity_m_per_N) for found in columns]
    for name, values in (
        ("elasticity at the support, mm/N", [e[0] for e in elasticities]),
        ("lowest elasticity, mm/N", [e.min() for e in elasticities]),
        ("elasticity in the middle of the span, mm/N", [e[len(e) // 2] for e in elasticities]),
    ):
        # Two printed decimals.
        np.testing.assert_allclose(printed("line-types", name), values, atol=0.0051)


def test_simple_lines(at_rest: AtRest) -> None:
    wires = [at_rest("trolley-bridles-60", PLAIN), at_rest("trolley-bridles-60")]
    rails = [at_rest(f"conductor-rail-{number}-120") for number in (1, 2, 3)]
    for name, values, last_digit in (
        ("sag, mm", [1e3 * f.contact_wire_sag_m for f in wires], 0.51),
        ("highest elasticity, mm/N", [1e3 * max(f.elasticity_m_per_N) for f in wires], 0.0051),
        ("lowest elasticity, mm/N", [1e3 * min(f.elasticity_m_per_N) for f in wires], 0.0051),
        ("sag in the middle span, mm", [1e3 * f.contact_wire_sag_m for f in rails], 0.051),
        ("highest elasticity, µm/N", [1e6 * max(f.elasticity_m_per_N) for f in rails], 0.051),
        ("lowest elasticity, µm/N", [1e6 * min(f.elasticity_m_per_N) for f in rails], 0.0051),
        ("first natural frequency, Hz", [f.natural_frequencies_Hz[0] for f in rails], 0.0051),
    ):
        np.testing.assert_allclose(printed("simple-lines", name), values, atol=last_digit)
