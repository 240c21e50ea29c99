"""Ticked runs and measurements → tables and figures of their comparison."""

from collections.abc import Mapping, Sequence
from dataclasses import asdict
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

from arcless.comparison import compare
from arcless.comparison.content import comparison_content
from arcless.figures.comparison import MOST_RUNS
from arcless.figures.description import Figure
from arcless.figures.description.tokens import of_series
from arcless.measurements import is_measured
from arcless.studio.answers.answers import Refused
from arcless.studio.answers.page_words import in_page_words
from arcless.studio.charts.measured_as import MeasuredAs, measured_as
from arcless.studio.charts.plain.charted import Charted
from arcless.studio.charts.plain.drawable import heads

if TYPE_CHECKING:
    from arcless.comparison import Comparison


# Characters of the name of a run: that of its scenario, and what differs.
LONGEST_NAME = 300


class ChartedComparison(Charted):
    """A comparison whose figures are asked for piece by piece.

    Parameters
    ----------
    *files
        Folders of runs, their files, or CSV files of measurements.
    names
        What each is called; without, names of the comparison itself.
    measured
        What is given of each file that is a measurement; None of a run.
    """

    def __init__(
        self,
        *files: Path,
        names: tuple[str, ...] | None = None,
        measured: tuple[MeasuredAs | None, ...] = (),
    ) -> None:
        super().__init__()
        given = measured or (None,) * len(files)
        read = [how.read(file) if how is not None and is_measured(file) else file
                for file, how in zip(files, given, strict=True)]  # fmt: skip
        self.comparison: Comparison = compare(read, names=names)

    @cached_property
    def figures(self) -> dict[str, list[Figure]]:
        """Overlays by their keys."""
        return self.comparison.figures

    def told(self) -> dict[str, Any]:
        """Return names, what differs, tables, remarks, and heads of the figures."""
        compared = self.comparison
        with self.lock:
            content = comparison_content(compared, self.figures)
            told = heads(self.figures)
        sections = [
            {"key": key, "title": title, "rows": [told[name] for name in names]}
            for key, title, names, _ in content["sections"]
        ]
        kept = (
            "title", "names", "runs", "count", "verdicts", "several", "placement",
            "bands", "acceptance", "simulated", "main", "numbers", "differences_read",
            "numbers_read", "placement_reads", "placed_on", "changes", "bands_read",
            "acceptance_reads", "left_out", "same",
        )  # fmt: skip
        return {
            **{name: content[name] for name in kept},
            "warnings": [in_page_words(text) for text in content["warnings"]],
            "fields": [asdict(one) for one in content["fields"]],
            "colours": [of_series(run) for run in range(len(compared.names))],
            "sections": sections,
            "section_m": list(compared.sides[0].assessment.section_m),
        }

    @property
    def bytes(self) -> int:
        """Memory of the arrays of the runs that were read, and of pyramids, in bytes."""
        read = [getattr(one.result.recorded, "read_bytes", 0)
                for one in self.comparison.sides if one.result is not None]  # fmt: skip
        return sum(read) + self.pyramid_bytes


def checked(subjects: object) -> list[str]:
    """Return the paths of what is to be compared.

    Raises
    ------
    Refused
        They are no list of texts, fewer than two, or more than are told apart in one figure.
    """
    if not isinstance(subjects, list) or not all(isinstance(one, str) for one in subjects):
        raise Refused(400, "`subjects` is not a list of paths")
    if len(subjects) > MOST_RUNS:
        raise Refused(400, f"{len(subjects)} are ticked; one figure shows at most {MOST_RUNS}")
    return subjects


def names_of(question: Mapping[str, Any]) -> tuple[str, ...] | None:
    """Return what the page calls the subjects of a question; None where it does not say.

    Raises
    ------
    Refused
        They are no list of short texts.
    """
    names = question.get("names")
    if names is None:
        return None
    if not isinstance(names, list) or not all(
        isinstance(one, str) and len(one) <= LONGEST_NAME for one in names
    ):
        raise Refused(400, "`names` is not a list of short texts")
    return tuple(names)


def measured_of(question: Mapping[str, Any], subjects: Sequence[str]) -> tuple[Any, ...]:
    """Return what is given of each subject by its path in `measured`; None of one without.

    Raises
    ------
    Refused
        It is no object, or one part is none of a measurement.
    """
    given = question.get("measured", {})
    if not isinstance(given, dict):
        raise Refused(400, "`measured` is not an object")
    return tuple(measured_as(given[path]) if path in given else None for path in subjects)
