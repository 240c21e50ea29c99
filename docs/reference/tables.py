"""Tables of reference pages and guides that the program itself has."""

from arcless.assess.criteria import markdown_table
from arcless.dataset.schema import markdown_tables
from arcless.model import MARKS


def marks() -> str:
    rows = [f"| {mark} | {meaning} |" for mark, meaning in MARKS.items()]
    return "\n".join(["| mark | meaning |", "|---|---|", *rows])


QUICK = {
    "reference/model-files": {"marks": marks},
    "reference/results": {"contents": markdown_tables},
    "guide/assessment": {"criteria": markdown_table},
}
