"""Tables of reference pages and guides that the program itself has."""

from arcless.assess.criteria import markdown_table
from arcless.dataset.schema import markdown_tables
from arcless.figures.run import FIGURES
from arcless.model import MARKS
from arcless.units import KINDS, spell


def marks() -> str:
    rows = [f"| {mark} | {meaning} |" for mark, meaning in MARKS.items()]
    return "\n".join(["| mark | meaning |", "|---|---|", *rows])


def units() -> str:
    """Return the units of each physical kind, SI first."""
    rows = []
    for kind in KINDS.values():
        shown = ", ".join(f"`{spell(unit)}`" for unit in kind.units if unit)
        rows.append(f"| {kind.name.partition(' ')[2]} | {shown} |")
    return "\n".join(["| kind | units |", "|---|---|", *rows])


def figure_keys() -> str:
    """Return what each key of `Result.figures` shows, as its function says it."""
    rows = []
    for key, make in FIGURES.items():
        words = (make.__doc__ or "").partition("\n")[0].removeprefix("Return ").removesuffix(".")
        rows.append(f"| `{key}` | {words} |")
    return "\n".join(["| key | shows |", "|---|---|", *rows])


QUICK = {
    "reference/model-files": {"marks": marks, "units": units},
    "reference/results": {"contents": markdown_tables},
    "guide/figures": {"keys": figure_keys},
    "guide/assessment": {"criteria": markdown_table},
}
