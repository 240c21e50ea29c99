"""Tables of pages that say what records of the evidence say, compared without a run."""

import re

import pytest

from arcless.validate import CASES
from tests.support.pages import DOCS, cells, table
from tests.support.records import load


def test_published_ranges_are_as_recorded() -> None:
    compared = 0
    for page, topic in (("en50318-2002", "en50318_2002"), ("ac-simple", "ac_simple")):
        rows = {row.what: row for row in load("references", topic).rows}
        for speed, quantity, _, value, verdict, mark in cells(table(page, "ranges")):
            row = rows[f"{quantity.rpartition(' (')[0]}, {speed}"]
            assert verdict.strip("*") == row.verdict
            assert mark == row.mark
            # One printed decimal, and what the rounding of another processor may grow to.
            assert float(value) == pytest.approx(row.value, rel=0.01, abs=0.3), quantity
            compared += 1
    assert compared == sum(len(case.ranges) for case in CASES)


def test_conclusions_of_the_founding_paper_are_as_recorded() -> None:
    text = (DOCS / "validation" / "praks.md").read_text(encoding="utf-8")
    printed = re.findall(
        r"^\| \d [a-z ]+ \| (\d+ km/h: .+?) \| ([\d.]+) \| .+? \| (\w+) \|", text, re.M
    )
    rows = load("references", "hanger_joints").rows
    assert len(printed) == len(rows) > 10
    for (quantity, value, verdict), row in zip(printed, rows, strict=True):
        assert quantity == row.what + (f" ({row.unit})" if row.unit != "1" else "")
        assert verdict == row.verdict
        last = 10.0 ** -len(value.partition(".")[2])
        assert float(value) == pytest.approx(row.value, rel=0.01, abs=last), quantity


def test_stitched_lines_are_as_recorded() -> None:
    rows = {row.what: row.value for row in load("references", "stitched_lines").rows}
    printed = cells(table("lines", "stitch"))
    assert len(printed) == 7
    for line, with_, without, middle, plain, share, bare in printed:
        for what, one, other in (
            ("softer at the support by the factor", with_, without),
            ("mid-span against that without", middle, plain),
            ("non-uniformity against that without", share, bare),
        ):
            # Two printed decimals of some tenths, whole per cents of some ten.
            room = 0.04 if "non" not in what else 0.06
            assert float(one) / float(other) == pytest.approx(
                rows[f"{line}: {what}"], rel=room, abs=0.02
            )


def test_elasticities_are_as_recorded() -> None:
    rows = {row.what: row.value for row in load("references", "mean_elasticity").rows}
    printed = cells(table("lines", "elasticity"))
    assert len(printed) == 3
    for row in printed:
        assert float(row[7]) == pytest.approx(rows[f"mean elasticity, {row[0]}"], abs=0.011)


def test_dropper_lengths_are_as_recorded() -> None:
    rows = {row.what: row.value for row in load("references", "dropper_lengths").rows}
    differences = [abs(float(row[-1])) for row in cells(table("ac-simple", "lengths"))]
    assert len(differences) == 9
    found = 1e3 * rows["largest difference to a published length, as shipped"]
    assert max(differences) == pytest.approx(found, abs=0.051)
