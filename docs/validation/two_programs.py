"""Tables of the page in-space: every version of AC simple in space, side by side, from records."""

from collections.abc import Callable, Iterator, Sequence

from validation.runs import table

from arcless.validate.evidence import Measurement, recorded

FAMILIES = ("chains", "cubic elements")
CABLES = ("Exudyn, cables of 1.4 m", "Exudyn, cables of 0.7 m", "Exudyn, cables of 0.35 m")
# What the names of rows begin with once the version is gone, the head of the table, factor, digits.
AT_REST = (
    ("elasticity at 11 places", "elasticity, %", 100.0, 3),
    ("force of 9 droppers", "dropper force, %", 100.0, 3),
    ("pull of the arms", "pull of the arms, %", 100.0, 3),
    ("height of the contact wire", "height of the contact wire, mm", 1e3, 3),
    ("stagger at the arms", "stagger at the arms, mm", 1e3, 3),
)
VERSIONS = (
    "chains", "chains, halved", "cubic elements", "cubic elements, halved",
    "cubic elements, updated",
    "Exudyn, 0.72 m", "same equations, 0.72 m", "Exudyn, 0.36 m", "same equations, 0.36 m",
)  # fmt: skip
PANTOGRAPHS = ("alone", "first of two", "second of two")
STATISTICS = ("mean force", "standard deviation", "maximum", "minimum")
APART = (
    ("difference of the force", "rms of the difference, N", 1.0, 2),
    ("correlation of the force", "1 − correlation", 1.0, 6),
)
LIMIT = "Exudyn's limit"


def _rows(topic: str) -> list[Measurement]:
    return next(one.rows for one in recorded() if (one.group, one.name) == ("peers", topic))


def _found(rows: Sequence[Measurement], beginning: str) -> Measurement | None:
    return next((row for row in rows if row.what.startswith(beginning)), None)


def at_rest() -> str:
    """Return the largest differences at rest from cables of 0.175 m."""
    rows = _rows("exudyn_space_statics")
    lines = []
    for version in (*FAMILIES, *CABLES):
        cells = [_found(rows, f"{version}: {name}") for name, _, _, _ in AT_REST]
        lines.append([
            version,
            *(
                "" if cell is None else f"{factor * cell.value:.{digits}f}"
                for cell, (_, _, factor, digits) in zip(cells, AT_REST, strict=True)
            ),
        ])  # fmt: skip
    return table(("version", *(head for _, head, _, _ in AT_REST)), lines)


def running() -> str:
    """Return what is assessed of each pantograph, and how far each version is from the limit."""
    return "\n\n".join(_of_pantograph(name) for name in PANTOGRAPHS)


def _of_pantograph(name: str) -> str:
    rows = _rows("exudyn_space_run")
    head = (name, *(f"{one}, N" for one in STATISTICS), *(title for _, title, _, _ in APART))
    return table(head, _lines(rows, name))


def _lines(rows: Sequence[Measurement], name: str) -> Iterator[list[str]]:
    reference = [_found(rows, f"{FAMILIES[0]}, {name}: {one}") for one in STATISTICS]
    limits = [row.reference for row in reference if row is not None and row.reference is not None]
    yield [LIMIT, *(f"{value:.2f}" for value in limits), "", ""]
    for version in VERSIONS:
        cells = [_found(rows, f"{version}, {name}: {one}") for one in STATISTICS]
        apart = [_found(rows, f"{version}, {name}: {one}") for one, _, _, _ in APART]
        yield [
            version,
            *("" if cell is None else f"{cell.value:.2f}" for cell in cells),
            *(
                "" if cell is None else f"{factor * cell.value:.{digits}f}"
                for cell, (_, _, factor, digits) in zip(apart, APART, strict=True)
            ),
        ]


QUICK: dict[str, dict[str, Callable[[], str]]] = {
    "in-space": {"at-rest": at_rest, "running": running}
}
