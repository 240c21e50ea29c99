"""Tables of reference pages and guides that the program itself has."""

from arcless.assess.criteria import markdown_table
from arcless.control.laws import FORMAT as LAW_FORMAT
from arcless.dataset.schema import RESULT_FORMAT, markdown_tables
from arcless.figures.run import FIGURES
from arcless.model import MARKS, Line, Pantograph, Scenario
from arcless.simulate.runs.checkpoint import STATE_FORMAT
from arcless.study import Study
from arcless.units import KINDS, spell

FORMATS = {
    **{
        what: str(model.model_fields["format"].default)
        for what, model in {
            "line": Line, "pantograph": Pantograph, "scenario, and variant of one": Scenario,
            "study": Study,
        }.items()
    },
    "result": RESULT_FORMAT,
    "state of a run": STATE_FORMAT,
    "learned law of a controller": LAW_FORMAT,
}  # fmt: skip


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


def formats() -> str:
    """Return what each format of files is, and the version that is written."""
    rows = [f"| {what} | `{name}` |" for what, name in FORMATS.items()]
    return "\n".join(["| file | format that is written and read |", "|---|---|", *rows])


QUICK = {
    "reference/versions": {"formats": formats},
    "reference/model-files": {"marks": marks, "units": units},
    "reference/results": {"contents": markdown_tables},
    "guide/figures": {"keys": figure_keys},
    "guide/assessment": {"criteria": markdown_table},
}
