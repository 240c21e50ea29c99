"""Elasticity in mid-span of all shipped lines against the rule e = l/(k ΣT)

A textbook's rule: span l over the sum ΣT of all tensions and k = 4.0, with stitch wires k = 3.5
(Kiessling, Puschmann, Schmieder, Contact Lines for Electric Railways, 9.5.2.1, as a Chinese edition
of it is quoted; mark A'). Lines within 15 % are left at that.

Beyond it the line is computed once more, without what the rule leaves out. With k = 4 it is the
middle of one string of the tension ΣT between two supports: its droppers are so close that all
wires move as one, and all wires are held at the supports. So droppers are put 1 m apart, of the
same mass by metre, arms made not to yield (10 kN/mm), and stitch wires taken away. What is left
must be l/(4 ΣT).

Asked as every shipped line with a messenger wire at rest.
"""

import pytest

from arcless.model import load_line
from tests.support.docs import from_docs
from tests.support.evidence import Evidence
from tests.support.faults import Fault, forgotten
from tests.support.python_faults import tension

mid_span = from_docs("mid_span")

QUICK = "norway-s20b"
LINES = [
    name if name == QUICK else pytest.param(name, marks=pytest.mark.evidence)
    for name in mid_span.lines()
]


@pytest.mark.parametrize("name", LINES)
def test_rule(evidence: Evidence, name: str) -> None:
    line, found = load_line(name), mid_span.mid_span(name)
    rule = mid_span.rule(line)
    evidence.published(
        f"mid-span, {name}", found, (1.0 - mid_span.ALLOWED) * rule,
        (1.0 + mid_span.ALLOWED) * rule, unit="mm/N", mark="A'",
        source="± 15 % of the rule, as quoted",
    )  # fmt: skip
    if abs(found / rule - 1.0) > mid_span.ALLOWED:
        evidence.close(
            f"mid-span as one string held at its supports, {name}",
            mid_span.mid_span(name, mid_span.as_one_string(line)),
            mid_span.one_string(line), unit="mm/N", relative=0.03,
            reason="the sag of the messenger wire stiffens it by 1 to 2 %, and droppers 1 m apart "
            "leave the contact wire 1 % between them",
        )  # fmt: skip


FAULTS = [
    Fault("all tensions 10 % too low", [forgotten(mid_span.mid_span), tension(0.9)], test_rule,
          name=QUICK),
]  # fmt: skip
