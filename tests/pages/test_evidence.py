"""Pages of the evidence: pictures are there, and runs next to their limit are shown."""

from validation import evidence, evidence_topic

from arcless.validate.evidence import Topic, recorded
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
