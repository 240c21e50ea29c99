"""Results → Comparison: a pure function of runs that are finished."""

from collections.abc import Mapping, Sequence
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Literal

from arcless.comparison import tables
from arcless.comparison.compared import Compared, data_of
from arcless.comparison.measured.placing import Aligning
from arcless.comparison.subjects.runs import Subject, opened
from arcless.comparison.subjects.sides import drawn
from arcless.display.frames import frame
from arcless.errors import ComparisonError
from arcless.measurements import Measurement
from arcless.results import Result

if TYPE_CHECKING:
    import pandas
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure as Drawing

    from arcless.figures.description import Figure
    from arcless.figures.description.tokens import Scheme


class Comparison(Compared):
    """Runs side by side; figures and page are made when they are asked for."""

    @cached_property
    def figures(self) -> "dict[str, list[Figure]]":
        """Overlays of the runs by their keys, one figure for each pantograph.

        Raises
        ------
        ComparisonError
            There are more runs than a reader tells apart in one figure.
        """
        from arcless.figures.comparison import MOST_RUNS, Overlaid, figures

        if len(self.sides) > MOST_RUNS:
            raise ComparisonError(
                "runs in one figure",
                got=str(len(self.sides)),
                expected=f"at most {MOST_RUNS}",
                hint="compare fewer runs, or leave the page out: the tables take any number",
            )
        many = Overlaid(self.names, drawn(self.sides))
        return figures(many, [(one.name, one.places) for one in self.pantographs])

    def plot(
        self,
        key: str = "force",
        axes: "Axes | None" = None,
        *,
        scheme: "Scheme" = "light",
        width_mm: float | None = None,
    ) -> "Drawing":
        """Draw one of the figures by matplotlib; the arguments are those of `Result.plot`."""
        from arcless.figures import paper

        return paper.plot(self.figures, key, axes, scheme=scheme, width_mm=width_mm)

    def write_report(self, path: str | Path) -> None:
        """Write the comparison as one HTML file that opens without a network.

        Raises
        ------
        ComparisonError
            There are more runs than can be overlaid.
        OutputError
            The file cannot be written; nothing half-written stays behind.
        """
        from arcless.comparison.page import write

        write(self, self.figures, path)

    def write_pdf(self, path: str | Path, *, fields: Mapping[str, str] | None = None) -> None:
        """Write the comparison on paper: one PDF file, as `Result.write_pdf` does for a run.

        Raises
        ------
        ComparisonError
            There are more runs than can be overlaid.
        OutputError
            As in `Result.write_pdf`.
        """
        from arcless.comparison.paper import write

        write(self, self.figures, path, fields)

    def to_dataframe(
        self, table: Literal["numbers", "criteria", "fields"] = "numbers"
    ) -> "pandas.DataFrame":
        """Return numbers with their differences, criteria, or changed fields, as a data frame.

        Raises
        ------
        OutputError
            There is no such table.
        """
        made = {
            "numbers": lambda: tables.number_columns(self),
            "criteria": lambda: tables.criterion_columns(self),
            "fields": lambda: tables.field_columns(self),
        }
        return frame(made, table)

    def _repr_html_(self) -> str:
        return tables.card(self)

    def __repr__(self) -> str:
        return f"<Comparison of {len(self.names)} runs: {'; '.join(self.names)}>"


def compare(
    runs: Subject | str | Path | Sequence[Subject | str | Path],
    *more: Subject | str | Path,
    aligning: Aligning | None = None,
    names: Sequence[str] | None = None,
) -> Comparison:
    """Compare runs and measurements with the first of them.

    Parameters
    ----------
    runs, *more
        At least two, one by one or as a list: results, folders of runs, result files,
        measurements, or CSV files of measurements.
    aligning
        How measurements are put on the line of the first run; by correlation without.
    names
        What runs and measurements are called in tables and figures, each by another name; without,
        names of scenarios, folders and files, or what differs between the runs.

    Raises
    ------
    ComparisonError
        There are fewer than two, names are too many, too few or twice the same, one is there
        twice, one is not a finished run, or a measurement cannot be aligned.
    MeasurementError
        A CSV file is no measurement, or too little of it is left in the section.
    ResultFormatError
        A file is missing, damaged, or of another format version.
    """
    first = [runs] if isinstance(runs, str | Path | Result | Measurement) else list(runs)
    subjects, files = opened([*first, *more])
    return Comparison(**data_of(subjects, files, aligning or Aligning(), names))
