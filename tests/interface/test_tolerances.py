"""Every tolerance in a test has its reason beside it."""

import re
from pathlib import Path

import pytest

TESTS = Path(__file__).parents[1]
TOLERANCE = re.compile(r"\b(?:rel|abs|rtol|atol)=[0-9.]*[1-9]")
ABOVE = 6  # lines: a reason may stand over a group of assertions
FILES = sorted(
    path
    for folder in ("unit", "interface", "verification", "drills", "hostile")
    for path in (TESTS / folder).rglob("test_*.py")
)


def bare(text: str) -> list[int]:
    """Lines with a tolerance and no comment beside or above it."""
    lines = text.splitlines()
    return [
        number + 1
        for number, line in enumerate(lines)
        if TOLERANCE.search(line) and "#" not in "".join(lines[max(0, number - ABOVE) : number + 1])
    ]


def test_there_is_something_to_check() -> None:
    assert sum(len(TOLERANCE.findall(path.read_text("utf-8"))) for path in FILES) > 100
    assert bare("a == approx(b, rel=0.1)") == [1]
    assert bare("# why\na == approx(b, rel=0.1)\na == approx(c, abs=1e-3)  # because") == []


@pytest.mark.parametrize("path", FILES, ids=lambda path: str(path.relative_to(TESTS)))
def test_tolerances_have_reasons(path: Path) -> None:
    lines = bare(path.read_text("utf-8"))
    assert not lines, f"{path.relative_to(TESTS)}: no reason beside the tolerances of lines {lines}"
