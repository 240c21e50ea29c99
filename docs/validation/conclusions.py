"""What slow tables must agree with, looked up in what is printed: records of the tests, models."""

import re
from collections.abc import Iterator
from pathlib import Path

import numpy as np
from fragments import DOCS, cells, shown
from validation import library, spacing

from arcless.model import load_line
from arcless.model.shipped.library import shipped
from arcless.validate.evidence import Measurement, recorded

# Two printed decimals of some tenths, whole per cents of some ten.
OF_TENTHS, OF_PER_CENTS = 0.04, 0.06
DRILLS = Path(__file__).parents[2] / "tests" / "drills"


def complaints() -> Iterator[str]:
    """Say which page prints something else than is recorded, or concludes something else."""
    for said in (
        _founding_paper, _stitched_lines, _elasticities, _dropper_lengths, _models,
        _trailing_pantograph, _period, _spacings, _drills,
    ):  # fmt: skip
        for text in said():
            yield f"{said.__name__.strip('_').replace('_', ' ')}: {text}"


def _rows(topic: str) -> list[Measurement]:
    (known,) = (known for known in recorded() if known.name == topic)
    return known.rows


def _near(text: str, value: float, room: float = 0.01) -> bool:
    """Whether a printed number is a value, to its last digit or a share of it."""
    last = 10.0 ** -len(text.partition(".")[2])
    return abs(float(text) - value) <= max(1.01 * last, room * abs(value))


def _founding_paper() -> Iterator[str]:
    rows, printed = _rows("hanger_joints"), cells(shown("validation/praks", "conclusions"))
    if len(rows) != len(printed):
        yield f"{len(printed)} values, {len(rows)} are recorded"
    for row, (_, quantity, value, _, verdict, _) in zip(rows, printed, strict=False):
        known = row.what + (f" ({row.unit})" if row.unit != "1" else "")
        if (quantity, verdict) != (known, row.verdict) or not _near(value, row.value):
            yield f"{quantity} {value}, {verdict}; recorded {row.value:.4g}, {row.verdict}"


def _stitched_lines() -> Iterator[str]:
    known = {row.what: row.value for row in _rows("stitched_lines")}
    for line, *pairs in cells(shown("validation/lines", "stitch")):
        numbers = [float(cell) for cell in pairs]
        for place, (what, room) in enumerate(
            (
                ("softer at the support by the factor", OF_TENTHS),
                ("mid-span against that without", OF_TENTHS),
                ("non-uniformity against that without", OF_PER_CENTS),
            )
        ):
            share = numbers[2 * place] / numbers[2 * place + 1]
            if abs(share - known[f"{line}: {what}"]) > max(room * share, 0.02):
                yield f"{line}, {what}: {share:.3f}, recorded {known[f'{line}: {what}']:.3f}"


def _elasticities() -> Iterator[str]:
    known = {row.what: row.value for row in _rows("mean_elasticity")}
    for line, *_, mean, _ in cells(shown("validation/lines", "elasticity")):
        if not _near(mean, known[f"mean elasticity, {line}"]):
            yield f"{line}: {mean}, recorded {known[f'mean elasticity, {line}']:.3f}"


def _dropper_lengths() -> Iterator[str]:
    known = {row.what: row.value for row in _rows("dropper_lengths")}
    found = 1e3 * known["largest difference to a published length, as shipped"]
    printed = max(abs(float(row[-1])) for row in cells(shown("validation/ac-simple", "lengths")))
    if not _near(f"{printed:.1f}", found):
        yield f"{printed} mm, recorded {found:.2f}"


def _models() -> Iterator[str]:
    """Say which row of the page library is not a shipped line, or counts marks as it has not."""
    printed = {row[0]: row for row in cells(shown("validation/library", "lines"))}
    if set(printed) != set(shipped("line")):
        yield f"lines that differ: {sorted(set(printed) ^ set(shipped('line')))}"
    for name, row in printed.items():
        if name in shipped("line") and row[8:] != library.marks_of(load_line(name)):
            yield f"{name}: marks {row[8:]}, has {library.marks_of(load_line(name))}"


def _trailing_pantograph() -> Iterator[str]:
    """Demand that it is the worse one nearly everywhere."""
    for case, *_, places in cells(shown("validation/lines", "leading")):
        at, of = (int(word) for word in re.findall(r"\d+", places))
        if at < 0.85 * of:
            yield f"{case}: the worse one at {places}"


def _period() -> Iterator[str]:
    """Demand that it is that of the first band, to the half metre of the fit, not of the span."""
    for case, row in zip(spacing.CASES, cells(shown("validation/lines", "period")), strict=True):
        low, high = spacing.first_band(case)
        found, span, wave = float(row[1]), float(row[4]), float(row[5])
        if not 0.98 * low < float(row[2]) < 1.02 * high:
            yield f"{case.title}: {row[2]} Hz, the band is {low:.3f} to {high:.3f} Hz"
        if abs(found / span - 1) < 0.15 or abs(found / wave - 1) < 0.08:
            yield f"{case.title}: {found} m is that of the span after all"


def _spacings() -> Iterator[str]:
    """Demand that the published worst spacings are better somewhere than the published best."""
    rows = {
        row[0]: np.array([float(cell) for cell in row[1:]])
        for row in cells(shown("validation/lines", "spacing"))[1:]
    }
    worst = np.minimum(rows["90 m"], rows["150 m"])
    best = np.maximum(rows["200 m"], rows["210 m"])
    if not np.all(worst < best):
        yield f"90 or 150 m {worst}, 200 or 210 m {best}"


def _drills() -> Iterator[str]:
    text = (DOCS / "validation/failure-drills.md").read_text(encoding="utf-8")
    printed = set(re.findall(r"^\| `(test_\w+)` \|", text, re.MULTILINE))
    files = {path.stem for path in DRILLS.glob("test_*.py")}
    if printed != files:
        yield f"files that differ: {sorted(printed ^ files)}"
