"""The pages of docs/validation say what the program says."""

import re
from collections.abc import Callable
from pathlib import Path

import pytest

from arcless.results import Result
from arcless.validate import CASES, compare, seed
from arcless.validate.observation import observe

PAGES = Path(__file__).parents[2] / "docs" / "validation"
RunOnce = Callable[..., Result]


def page_of(scenario: str) -> str:
    return "en50318-2002.md" if "2002" in scenario else "ac-simple.md"


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.scenario)
def test_values_are_current(run_once: RunOnce, case) -> None:
    text = (PAGES / page_of(case.scenario)).read_text(encoding="utf-8")
    speed = case.title.rpartition(", ")[2]
    printed = re.findall(rf"\| {speed} \| (.+?) \| .+? \| (-?[\d.]+) \|", text)
    rows = compare(case, run_once(case.scenario).assessment.to_dict())
    assert len(printed) == len(rows)
    for (quantity, value), row in zip(printed, rows, strict=True):
        assert quantity == f"{row.quantity} ({row.unit})"
        # One printed decimal, and what the rounding of another processor may grow to.
        assert float(value) == pytest.approx(row.value, rel=0.01, abs=0.3), quantity


NO_MASS = {"line.dropper.clamp_mass_contact_wire": 0.0}


def test_conclusions_are_current(run_once: RunOnce) -> None:
    text = (PAGES / "praks.md").read_text(encoding="utf-8")
    rows = seed.rows([observe(run_once(name)) for name in seed.SCENARIOS])
    printed = re.findall(
        r"^\| \d [a-z ]+ \| (\d+ km/h: .+?) \| ([\d.]+) \| .+? \| (\w+) \|", text, re.M
    )
    assert len(printed) == len(rows)
    for (quantity, value, verdict), row in zip(printed, rows, strict=True):
        assert quantity == row.quantity + (f" ({row.unit})" if row.unit else "")
        assert verdict == row.verdict
        # One unit of the last decimal, and what the rounding of another processor may grow to.
        assert float(value) == pytest.approx(row.value, rel=0.01, abs=10**-row.digits), quantity


@pytest.mark.parametrize(
    ("title", "changes"), [("**2.5 kg, as shipped**", {}), ("no mass at hanger joints", NO_MASS)]
)
def test_sensitivity_is_current(run_once: RunOnce, title: str, changes: dict[str, float]) -> None:
    text = (PAGES / "praks.md").read_text(encoding="utf-8")
    line = next(line for line in text.splitlines() if line.startswith(f"| {title} |"))
    cells, words = line.split(" | ")[1:5], line.strip("| ").split(" | ")[5:]
    seen = [observe(run_once(name, changes)) for name in seed.SCENARIOS]
    for cell, one in zip(cells, seen, strict=True):
        low, high, *gap = [float(number) for number in re.findall(r"[\d.]+", cell)]
        # Printed without decimals; impacts repeat to a per cent.
        assert (low, high) == pytest.approx((one.low, one.high), rel=0.01, abs=1.0)
        assert (gap or [0.0, 0.0]) == pytest.approx([one.gap, one.loss], rel=0.1, abs=0.06)
    holds = seed.held(seed.rows(seen)).values()
    assert [word.startswith("yes") for word in words] == list(holds)


@pytest.mark.parametrize(
    "page",
    [
        "en50318-2002",
        "ac-simple",
        "convergence",
        "convergence-published",
        "energy",
        "praks",
        "lines",
        "library",
    ],
)
def test_pages_say_how_they_were_made(page: str) -> None:
    text = (PAGES / f"{page}.md").read_text(encoding="utf-8")
    assert f"python docs/make_validation.py {page}" in text
    assert text.count("<!-- table: ") == text.count("<!-- end -->") > 0
    for name in re.findall(r"\]\((\w[\w-]*\.md)\)", text):
        assert (PAGES / name).is_file()
