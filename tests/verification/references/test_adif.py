"""Spanish lines: elasticities and uplifts of FOM/1630/2015 and Adif

Elasticities that FOM/1630/2015 quotes for CA-160 and CA-220 (mark A, S20), and the uplifts of
eight systems of Adif's fiches for two pantographs at the highest speed, S0 at the steady arm and fs
within the span (mark A, S13). Neither says with which pantograph, at which spacing, or with one
contact wire or both. What disagrees stays so: no model was changed to meet it.

Elasticity is asked with both contact wires lifted, uplift with two DSA 250 at the spacing of the
TSI, 85 m, under the law of the mean force of each supply. The product's elasticity in mid-span must
be that of one string of all tensions (page lines) within a quarter. And the published one is a
rule's: 3 l/(8 ΣT), to the digits that are given (mark D: found here).
"""

import pytest

from tests.support.docs import from_docs
from tests.support.evidence import Evidence
from tests.support.faults import Fault, forgotten
from tests.support.python_faults import tension, wrong

adif = from_docs("adif")

# Published values are met to this share, where they are met: the pantograph is not named.
ROOM = 0.10
SYSTEMS = list(adif.systems())


@pytest.mark.parametrize("scenario", adif.PUBLISHED)
def test_elasticity(evidence: Evidence, scenario: str) -> None:
    title, found = adif.TITLES[scenario], adif.elasticities(scenario, "product")
    for where, value, known in zip(
        ("mid-span", "support"), found, adif.PUBLISHED[scenario], strict=True
    ):
        evidence.published(
            f"elasticity, {title}, {where}", value, (1 - ROOM) * known, (1 + ROOM) * known,
            unit="mm/N", mark="A", source="± 10 % of FOM/1630/2015 as noted in S20",
        )  # fmt: skip
    evidence.close(
        f"elasticity, {title}, mid-span, against one string l/(4 ΣT)",
        found[0], adif.share(scenario) / 4.0, unit="mm/N", relative=0.25,
        reason="droppers some metres apart and arms that yield soften lines by 4 to 22 %",
    )  # fmt: skip
    known = adif.PUBLISHED[scenario][0]
    evidence.close(
        f"published mid-span of {title}, 3 l/(8 ΣT) of the line's data",
        3.0 * adif.share(scenario) / 8.0, known, unit="mm/N", absolute=0.005, mark="A",
        reason="half of the last digit given",
    )  # fmt: skip


@pytest.mark.evidence
@pytest.mark.parametrize("name", SYSTEMS)
def test_uplift(evidence: Evidence, name: str) -> None:
    own, found = adif.systems()[name], adif.uplifts(name)
    for what, value, known in zip(("S0", "fs"), found, (own.support, own.span), strict=True):
        evidence.published(
            f"{what}, {name}", value, (1 - ROOM) * known, (1 + ROOM) * known, unit="mm", mark="A",
            source="± 10 % of Adif's fiche as noted in S13",
        )  # fmt: skip
    evidence.within(
        f"fs over S0, {name}", found[1] / found[0], 1.0, 3.0, unit="1",
        reason="a span is softer than its support, and twice as soft at rest",
    )  # fmt: skip


FAULTS = [
    Fault("all tensions 25 % too low", [forgotten(adif.elasticities), tension(0.75)],
          test_elasticity, scenario=adif.CA160),
    Fault("one contact wire left out of ΣT",
          [forgotten(adif.elasticities), wrong(adif, "share", lambda share: 1.4 * share)],
          test_elasticity, scenario=adif.CA160),
    Fault("uplifts at support and in mid-span swapped",
          wrong(adif, "uplifts", lambda pair: pair[::-1]), test_uplift, name=SYSTEMS[0],
          slow=True),
]  # fmt: skip
