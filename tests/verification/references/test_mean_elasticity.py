"""Elasticity of three lines against what is remembered of them

Mean elasticities remembered to a digit or two (mark C) for layouts of droppers that are not known
to be the same: Re 200 between 0.9 and 1.1 mm/N, System 25's relative Re 250 0.55 mm/N, Re 330 0.40
mm/N. And for the AC simple line of 55 m the rule of thumb `e = L/(k ΣT)` in mid-span with k from
3.5 to 4 (from memory), and 0.204 and 0.419 mm/N at support and mid-span from an independent linear
program (mark D) whose droppers and supports were not stated.

Asked as the shipped lines at rest.
"""

from collections.abc import Callable

import numpy as np
import pytest

import arcless
from arcless.simulate import StaticsResult
from tests.support.evidence import Evidence

AtRest = Callable[..., StaticsResult]
REMEMBERED = {"germany-re-200": 1.0, "norway-s25": 0.55, "germany-re-330": 0.40}
SOFT = {"line.steady_arm.vertical_stiffness": 267.36}


@pytest.mark.parametrize("line", REMEMBERED)
def test_remembered(evidence: Evidence, line: str) -> None:
    found = arcless.statics(arcless.load("norway-s25-250").with_(line=line))
    evidence.close(
        f"mean elasticity, {line}",
        1e3 * float(np.mean(found.elasticity_m_per_N)),
        REMEMBERED[line],
        unit="mm/N",
        relative=0.10,
        mark="C",
        reason="remembered to a digit or two, for other layouts of droppers",
    )


def test_rule_of_thumb(evidence: Evidence, at_rest: AtRest) -> None:
    found = at_rest("en50318-ac-simple-320")
    line, e = found.scenario.line, found.elasticity_m_per_N
    assert line.messenger_wire is not None
    total = line.contact_wire.tension + line.messenger_wire.tension
    evidence.within(
        "k of the rule of thumb, AC simple, mid-span",
        55.0 / (total * e[len(e) // 2]),
        3.5,
        4.0,
        unit="1",
        mark="C",
        reason="the rule's own bracket, from memory",
    )


def test_scratch_program(evidence: Evidence, at_rest: AtRest) -> None:
    e = at_rest("en50318-ac-simple-320", SOFT).elasticity_m_per_N
    for place, value, other in (("support", e[0], 0.204), ("mid-span", e[len(e) // 2], 0.419)):
        evidence.close(
            f"elasticity at the {place}, arm of 267 N/m",
            1e3 * value,
            other,
            unit="mm/N",
            relative=0.1,
            mark="D",
            reason="droppers and supports of the other program were not stated: no factor is "
            "missing, no more",
        )
