"""The reference page shows the very table that the code uses."""

from pathlib import Path

from arcless.dataset.schema import markdown_tables

PAGE = Path(__file__).parents[3] / "docs" / "reference" / "results.md"


def test_the_page_holds_the_tables_of_the_code() -> None:
    # To update: paste the output of arcless.dataset.schema.markdown_tables().
    assert markdown_tables() in PAGE.read_text(encoding="utf-8")
