"""Generated parts of pages: found, compared, written."""

from pathlib import Path

import fragments
import pytest
from fragments import Fragment


@pytest.mark.parametrize(
    ("line", "printed", "same"),
    [
        ("12.3", "12.4", True),  # a unit of the last digit
        ("12.3", "12.9", False),
        ("1.05e-12", "3.1e-13", True),  # rounding errors: of no size
        ("115.2!", "115.2", False),  # another verdict
        ("| 10 to 20 |", "| 10 to 21 |", True),
        ("inside", "outside", False),
        ("200.0", "203.0", True),  # 2 %: contact that is lost a step later
        ("200.0", "210.0", False),
        ("+0.31", "-0.31", False),
    ],
)
def test_lines_are_compared_as_they_are_printed(line: str, printed: str, same: bool) -> None:
    assert fragments.alike(line, printed) is same


@pytest.fixture
def page(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A page with two fragments."""
    monkeypatch.setattr(fragments, "DOCS", tmp_path)
    file = tmp_path / "page.md"
    text = "a\n<!-- table: one -->\n\n| 1.00 |\n| 2.0 |\n\n<!-- end -->\n"
    file.write_text(text + "b\n<!-- table: two -->\n\nx\n\n<!-- end -->\n", "utf-8")
    return file


def test_a_fragment_is_written_between_its_marks(page: Path) -> None:
    assert fragments.names("page") == ["one", "two"]
    before = page.read_text("utf-8")
    fragments.put("page", "one", "y\nz")
    assert fragments.shown("page", "one") == "y\nz"
    assert page.read_text("utf-8") == before.replace("| 1.00 |\n| 2.0 |", "y\nz")


def test_rounding_leaves_what_is_printed(page: Path) -> None:
    made = Fragment("page", "one", lambda: "| 1.01 |\n| 2.3 |").made()
    assert made == "| 1.00 |\n| 2.3 |"
    assert fragments.changes(fragments.shown("page", "one"), made) == ["-| 2.0 |", "+| 2.3 |"]
    exact = Fragment("page", "one", lambda: "| 1.01 |\n| 2.0 |", computed=False).made()
    assert exact == "| 1.01 |\n| 2.0 |"


def test_a_place_without_an_end_is_told(page: Path) -> None:
    page.write_text("<!-- table: one -->\n", "utf-8")
    with pytest.raises(SystemExit, match="no end"):
        fragments.names("page")
    with pytest.raises(SystemExit, match="no place"):
        fragments.shown("page", "two")
