"""Pages of the evidence: pictures are there, and runs next to their limit are shown."""

import re

from validation import evidence, evidence_topic

from arcless.validate.evidence import INSIDE, Topic, recorded
from tests.support.evidence import Evidence


def test_pictures_are_there_and_used() -> None:
    topics = recorded()
    assert evidence.missing(topics) == evidence.orphans(topics) == []


def test_runs_beside_their_limit_are_shown_by_pantograph() -> None:
    table = [[50.0, 0.4, 0.1, 0.2, 0.0, 0.3, 1.0]]
    table += [[100.0, 20.0, 160.0, 40.0, 0.0, 0.5, -0.25, 0.75]] * 2
    evidence = Evidence("test")
    evidence.below("seed 1: run", 0.75, 1.0, unit="of its goal", reason="a goal", table=table)
    evidence.same("seed 1: verdicts", compared=9, differing=0, reason="a reason")
    page = evidence_topic.page("limits", [Topic("limits", "x", "X", rows=evidence.rows)])
    assert "| run | 1 | 1 | 75 % | ≤ 1 of its goal | a goal |" in page
    assert "| seed 1 | 1 | 100.0 | +0.00 | 20.0 | +0.50 | 160.0 | -0.25 | 40.0 | +0.75 |" in page
    assert page.count("| 2 | 100.0 |") == 1


def test_errors_over_element_length_are_a_line_with_their_order() -> None:
    evidence = Evidence("test")
    for size in (0.4, 0.2, 0.1):
        what = f"error, 275 km/h, chain of {size:g} m"
        evidence.below(what, 3.0 * size**2, 1.0, unit="mm", reason="a reason")
    evidence.below("error, 275 km/h, cubic of 0.4 m", 0.25, 1.0, unit="mm", reason="alone")
    page = evidence_topic.page("limits", [Topic("limits", "x", "X", rows=evidence.rows)])
    line = "| error, 275 km/h, mm | 0.48 ≤ 1 | 0.12 ≤ 1 | 0.03 ≤ 1 | 2.0 | inside |"
    assert line in page
    assert page.count("a reason") == 1
    assert "| error, 275 km/h, cubic of 0.4 m | 0.25 mm |" in page


def test_reasons_of_errors_over_element_length_keep_the_order_of_the_values() -> None:
    evidence = Evidence("test")
    reasons = [f"reason {letter}" for letter in "hgfedcba"]
    for size, reason in zip((0.8, 0.7, 0.6, 0.5, 0.4, 0.3, 0.2, 0.1), reasons, strict=True):
        evidence.below(f"error, chain of {size:g} m", size, 1.0, unit="mm", reason=reason)
    page = evidence_topic.page("limits", [Topic("limits", "x", "X", rows=evidence.rows)])
    found = [page.index(reason) for reason in reasons]
    assert found == sorted(found)


def test_the_first_screen_says_what_is_verified_what_disagrees_and_what_is_not_verified() -> None:
    page = evidence.pages()["index"]
    heads = [
        "What is verified",
        "What disagrees",
        "What is not verified",
        "How these pages are made",
    ]
    places = [page.index(f"## {head}") for head in heads]
    assert places == sorted(places)
    assert places[-1] < page.index("## [Closed forms]")
    rows = [row for topic in recorded() for row in topic.rows]
    outside = sum(row.verdict != INSIDE for row in rows)
    listed = page[places[1] : places[2]]
    assert sum(int(n) for n in re.findall(r"\| (\d+) of \d+ \|", listed)) == outside > 0
    assert f"{len(rows)} values" in page


def test_reach_of_the_evidence_names_topics_and_counts_them() -> None:
    page = evidence.pages()["index"]
    assert page.count("| behind another pantograph |") == 1
    (line,) = [
        line for line in page.splitlines() if line.startswith("- **Behind another") and ";" in line
    ]
    assert "Two pantographs on one wire" in line
