"""Tables as Markdown, and where they go in docs/performance.md."""

from collections.abc import Sequence
from pathlib import Path

PAGE = Path(__file__).parents[1] / "docs" / "performance.md"


def table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """Return a Markdown table."""
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def put(name: str, text: str) -> None:
    """Write into the page what stands between the two marks of a name."""
    page = PAGE.read_text("utf-8")
    begin, end = f"<!-- bench: {name} -->\n", f"<!-- end: {name} -->"
    before, rest = page.split(begin)
    after = rest.split(end)[1]
    PAGE.write_text(f"{before}{begin}\n{text}\n\n{end}{after}", "utf-8")
