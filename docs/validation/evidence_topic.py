"""A page of evidence: topics of one group, each with its values, its pictures, its faults."""

from validation import evidence_sizes
from validation.runs import escaped, table

from arcless.validate.evidence import GROUPS, Measurement, NoticedFault, Topic

GROUP_TEXTS = {
    "closed_forms": """The program against formulas: each section has the equation, its source, how
the program was asked, and what it answered.""",
    "orders": """How fast errors fall when elements and time steps are halved, against what theory
says of each wire model and each scheme.""",
    "limits": """What is computed by default against its limit: two families of elements that share
no error of discretisation, refined until they agree. Differences are in percent, those of minima in
percent of the mean force.""",
    "conservation": """What must stay the same: energy, and the result when the line is mirrored,
moved, scaled, run in two halves, or beside others.""",
    "peers": """The same models in programs that others wrote. These tests need the packages of
`make peers`; without them they are skipped, and the values below are from when they last ran.""",
    "references": """Runs of shipped lines against what is published about them. Marks: A, read in
the source named; B, C, C\\*: second hand or from memory, hence unverified.""",
}
# The unit of what is held against a limit by several goals at once.
GOAL = "of its goal"
HEAD = """Written by the tests (`make evidence`). *Used* is the part of the tolerance that the value
uses up. Values marked † are measured by `make evidence` only, all others in every `make test`,
which compares them with this page. Of the faults of a section `make test` tries the first that has
no †, `make evidence` all.
"""


def page(group: str, topics: list[Topic]) -> str:
    """Return the text of the page of a group."""
    sections = [_section(topic) for topic in topics]
    head = f"# {GROUPS[group]}\n\n{GROUP_TEXTS[group]}\n\n{HEAD}"
    return "\n".join([head, *sections])


def _section(topic: Topic) -> str:
    file = f"tests/verification/{topic.group}/test_{topic.name}.py"
    parts = [f"## {topic.title}", topic.text]
    parts += [
        f"![{figure['title']}](../images/validation/{figure['file']})" for figure in topic.figures
    ]
    beside = [row for row in topic.rows if row.table and row.unit == GOAL]
    sized, others = evidence_sizes.split(topic.rows)
    parts.append(_kinds(others) if beside else _values(others))
    parts.append(evidence_sizes.tables(sized))
    parts += [_order(row) for row in topic.rows if row.table and row not in beside]
    parts.append(_beside(beside))
    if topic.faults:
        parts.append("Broken on purpose, and noticed:")
        parts.append(_faults(topic.faults))
    parts.append(f"[`{file}`](../../{file})")
    return "\n\n".join(part for part in parts if part) + "\n"


def _values(rows: list[Measurement]) -> str:
    if not rows:
        return ""
    marked = any(row.mark for row in rows)
    head = ["value", "measured", "reference", "allowed", "used", "verdict", "why this tolerance"]
    if marked:
        head[-1] = "why this tolerance, or source"
        head.append("mark")
    return table(head, [[*_cells(row), *([row.mark] if marked else [])] for row in rows])


def _cells(row: Measurement) -> list[str]:
    unit = "" if row.unit == "1" else f" {row.unit}"
    verdict = row.verdict if row.verdict == "inside" else f"**{row.verdict}**"
    return [
        escaped(row.what) + (" †" if row.slow else ""),
        f"{row.value:.5g}{unit}",
        "" if row.reference is None else f"{row.reference:.5g}",
        escaped(row.allowed),
        "" if row.share is None or row.verdict != "inside" else f"{100 * row.share:.0f} %",
        verdict,
        escaped(row.reason),
    ]


def _order(row: Measurement) -> str:
    unit = row.unit.removeprefix("order in ")
    lines = [
        [f"{size:.5g}", f"{error:.3g}", *(f"{order:.2f}" for order in local or [])]
        + [""] * (not local)
        for size, error, *local in row.table
    ]
    return f"{row.what}:\n\n" + table([unit, "error", "local order"], lines)


def _kinds(rows: list[Measurement]) -> str:
    """Return the values of many scenarios that are held against the same, kind by kind."""
    kinds: dict[str, list[Measurement]] = {}
    for row in rows:
        kinds.setdefault(row.what.rpartition(": ")[2], []).append(row)
    head = ["value †", "scenarios", "inside", "most used", "allowed", "why this tolerance"]
    return table(head, [[kind, *_summary(own)] for kind, own in kinds.items()])


def _summary(rows: list[Measurement]) -> list[str]:
    inside = sum(row.verdict == "inside" for row in rows)
    used = max((row.share or 0.0 for row in rows), default=0.0)
    first = rows[0]
    texts = [escaped(first.allowed), escaped(first.reason)]
    return [str(len(rows)), str(inside), f"{100 * used:.0f} %", *texts]


def _beside(rows: list[Measurement]) -> str:
    """Return what runs are and by how much they are off; `tests/support/limit_rows.py` says how."""
    if not rows:
        return ""
    head = ["", "strip", "mean N", "off %", "σ N", "off %", "max N", "off %", "min N", "off %"]
    head += ["uplift mm", "off %", "elasticity %", "droppers %", "arms %", "families %", "spread"]
    return "By pantograph:\n\n" + table(head, [line for row in rows for line in _lines(row)])


def _lines(row: Measurement) -> list[list[str]]:
    (uplift, off, *rest, scattered), *strips = row.table
    line = [f"{uplift:.1f}", f"{off:+.2f}", *(f"{value:.2f}" for value in rest), f"{scattered:g}"]
    found = []
    for number, strip in enumerate(strips, start=1):
        numbers, errors = strip[: len(strip) // 2], strip[len(strip) // 2 :]
        pairs = zip(numbers, errors, strict=True)
        cells = [cell for own, error in pairs for cell in (f"{own:.1f}", f"{error:+.2f}")]
        name = escaped(row.what.removesuffix(": run")) if number == 1 else ""
        found.append([name, str(number), *cells, *(line if number == 1 else [""] * len(line))])
    return found


def _faults(faults: list[NoticedFault]) -> str:
    return table(
        ["broken", "noticed by", "found there; allowed"],
        [
            [escaped(f.fault) + (" †" if f.slow else ""), escaped(f.row), escaped(f.found)]
            for f in faults
        ],
    )
