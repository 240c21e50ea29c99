"""The page of messages is what the program says today."""

import re

import pytest

from tests.support.pages import DOCS, maker

MAKER = maker("make_messages")
CASES = MAKER.mistakes()


def parts() -> list[str]:
    """Return the sections of the page."""
    text = (DOCS / "guide/messages.md").read_text(encoding="utf-8")
    return re.split(r"\n(?=## \d)", text)[1:]


@pytest.mark.parametrize("number", range(len(CASES)), ids=[case["title"] for case in CASES])
def test_the_page_has_what_the_program_says(number: int) -> None:
    case, section = CASES[number], parts()[number]
    message, code = MAKER.said(case)
    assert section.startswith(f"## {number + 1}. {case['title']}\n")
    assert f"```text\n{MAKER.typed(case)}\n```" in section
    assert f"```text\n{message}\n```\n\nExit code {code}. " in section, (
        "python docs/make_messages.py writes the page anew"
    )
    assert re.match("(error|warning): ", message)
    assert "Traceback" not in message


def test_there_are_twenty() -> None:
    assert len(CASES) == len(parts()) == 20
    assert "# Twenty mistakes" in (DOCS / "guide/messages.md").read_text(encoding="utf-8")
