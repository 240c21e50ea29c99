"""Write the pages of docs/validation that the tests' records make: `python docs/make_evidence.py`.

`make evidence` runs all checks, which write the records, and then this. No page has a number that
is not in a record; `tests/unit/validate/test_evidence_pages.py` compares both.
"""

from pathlib import Path

from validation import evidence_index, evidence_topic

from arcless.validate.evidence import GROUPS, Topic, recorded

PAGES = Path(__file__).parent / "validation"


def pages() -> dict[str, str]:
    """Return the text of each page by its file name."""
    topics = recorded()
    made = {
        evidence_index.page_name(group): evidence_topic.page(group, own)
        for group in GROUPS
        if (own := [topic for topic in topics if topic.group == group])
    }
    return {evidence_index.NAME: evidence_index.page(topics), **made}


def orphans(topics: list[Topic]) -> list[str]:
    """Return the pictures that no topic shows."""
    used = {figure["file"] for topic in topics for figure in topic.figures}
    folder = PAGES.parent / "images" / "validation"
    return sorted(path.name for path in folder.glob("*.svg") if path.name not in used)


if __name__ == "__main__":
    for name, text in pages().items():
        (PAGES / name).write_text(text, encoding="utf-8")
