"""The pages of docs/validation that the tests' records make, and nothing else.

`make evidence` runs all checks, which write the records, and then `docs/make_pages.py`.
"""

from pathlib import Path

from validation import evidence_index, evidence_topic

from arcless.validate.evidence import GROUPS, Topic, recorded

PICTURES = Path(__file__).parents[1] / "images" / "validation"


def pages() -> dict[str, str]:
    """Return the text of each page by its name."""
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
    return sorted(path.name for path in PICTURES.glob("*.svg") if path.name not in used)


def missing(topics: list[Topic]) -> list[str]:
    """Return the pictures that topics show and that are not there."""
    files = [figure["file"] for topic in topics for figure in topic.figures]
    return [file for file in files if not (PICTURES / file).is_file()]
