"""The object that `arcless.run` and `arcless.open` return."""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from arcless.dataset.metadata import metadata
from arcless.dataset.netcdf.store import open_plain, save
from arcless.dataset.plain_dataset import Plain
from arcless.dataset.recorded_series import Place, asked_for, passage
from arcless.dataset.schema import VARIABLES
from arcless.display import cards
from arcless.display.frames import frame
from arcless.errors import ModelError
from arcless.results.kept_runs.places import run_file

if TYPE_CHECKING:
    import pandas
    import xarray
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure as Drawing

    from arcless.assess import Assessment
    from arcless.assess.wire_stress import WireStress
    from arcless.dataset.plain_dataset import Dataset
    from arcless.explanation import Explanation, Sensitivities
    from arcless.figures.description import Figure
    from arcless.figures.description.tokens import Scheme
    from arcless.model import Scenario
    from arcless.results.instrument.instrument import Instrument
    from arcless.results.instrument.readings import Readings


@dataclass(frozen=True, eq=False)
class Result:
    """A run, finished or stopped early: its dataset, and what follows from it.

    Attributes
    ----------
    recorded
        Everything that was recorded, as an xarray dataset or as arrays by name.
    scenario
        The resolved scenario that was run.
    """

    recorded: "Dataset"
    scenario: "Scenario"

    @cached_property
    def dataset(self) -> "xarray.Dataset":
        """Everything that was recorded, with units; see the results reference."""
        recorded = self.recorded
        return recorded.dataset() if isinstance(recorded, Plain) else recorded

    @property
    def latest(self) -> "Dataset":
        """Current `dataset`, with the changes made to it, or arrays by name without one."""
        return self.dataset if "dataset" in self.__dict__ else self.recorded

    # The two stages below are imported when asked for, so that reading a result waits for neither.
    @cached_property
    def assessment(self) -> "Assessment":
        """The run's indicators and criteria over its own analysis section."""
        from arcless.assess import assess

        return assess(self.latest)

    @cached_property
    def figures(self) -> "dict[str, list[Figure]]":
        """Figures of the run by their keys: a list for each, empty where nothing was recorded."""
        from arcless.figures.run import RunData, figures

        return figures(RunData(self.latest, self.assessment))

    def explain(self, sensitivities: "Sensitivities | None" = None) -> "Explanation":
        """Explain the standard deviation σ of the contact force over the analysis section.

        Parameters
        ----------
        sensitivities
            As `arcless.sensitivities` returns them, told with the rest.

        Returns
        -------
        Explanation
            Parts of σ² by what repeats, deviation by span, places, sentences.

        Raises
        ------
        ExplanationError
            The section has less than two spans, or a force is constant.
        """
        from arcless.explanation import explain

        return explain(self.latest, self.assessment, self.scenario, sensitivities)

    def plot(
        self,
        key: str = "lead",
        axes: "Axes | None" = None,
        *,
        scheme: "Scheme" = "light",
        width_mm: float | None = None,
    ) -> "Drawing":
        """Draw one of the figures by matplotlib, as in a notebook.

        Parameters
        ----------
        key
            A key of `figures`, for the first figure of it, or that of a single one: ``"lead-2"`` is
            that of the second pantograph.
        axes
            Axes to draw in; without them a new figure is made.
        scheme
            Colours: ``"light"`` or ``"dark"``.
        width_mm
            Width of a new figure in mm; 160, the text of an A4 page, without one.

        Returns
        -------
        matplotlib.figure.Figure
            The figure drawn in.

        Raises
        ------
        FigureError
            There is no such figure, or matplotlib is not installed.
        """
        from arcless.figures import paper

        return paper.plot(self.figures, key, axes, scheme=scheme, width_mm=width_mm)

    def write_report(self, path: str | Path, **options: Any) -> None:
        """Write the HTML report; the options are those of `arcless.report.write`."""
        from arcless import report

        report.write(self, path, **options)

    def write_pdf(
        self, path: str | Path, *, fields: Mapping[str, str] | None = None, **options: Any
    ) -> None:
        """Write the report on paper: one PDF file, PDF/UA-1 and PDF/A-2a, the same bytes anywhere.

        Parameters
        ----------
        path
            The file to write, which ends with ``.pdf``; one that exists is replaced.
        fields
            Fields of the cover by their names, in the order in which they are to stand there:
            ``author`` also stands in the properties of the file, ``document`` in the head of each
            page; ``prepared``, ``checked`` and ``approved`` at the lines for signatures.
        **options
            `assessment` and `reference_rows` of `arcless.report.write`.

        Raises
        ------
        OutputError
            The file does not end with ``.pdf``, a package is not installed, a field is empty or too
            long, or the file cannot be written; nothing half-written stays behind.
        """
        from arcless.report.paper import run_paper

        run_paper.write(self, path, fields=fields, **options)

    def filtered_force(self) -> "xarray.DataArray":
        """Return the contact force in N after the low-pass of the scenario.

        Indicators of the assessment are of this force; `dataset` has the unfiltered one.

        Returns
        -------
        xarray.DataArray
            Over time and pantograph, with the cut-off in Hz as the attribute `low_pass_Hz`.

        Raises
        ------
        ModelError
            The low-pass does not fit the record.
        """
        from arcless.results.export.tables import FILTERED, filtered_force

        force = self.dataset["contact_force"]
        cutoff_Hz = self.scenario.analysis.low_pass
        made = force.copy(data=filtered_force(self.latest, self.scenario)).rename(FILTERED)
        made.attrs = {
            "units": "N", "long_name": f"contact force, {cutoff_Hz:g} Hz low-pass",
            "low_pass_Hz": cutoff_Hz,
        }  # fmt: skip
        return made

    def to_dataframe(
        self, table: Literal["contact channels", "droppers", "supports"] = "contact channels"
    ) -> "pandas.DataFrame":
        """Return a table of the run as a data frame; columns are named as in exported files.

        Parameters
        ----------
        table
            ``"contact channels"``: channels of each pantograph over time, the filtered contact
            force among them. ``"droppers"``, ``"supports"``: what is known of each.

        Raises
        ------
        OutputError
            There is no such table.
        """
        from arcless.results.export import tables

        made = {
            "contact channels": lambda: tables.contact_channels(self),
            "droppers": lambda: tables.places(self, "dropper"),
            "supports": lambda: tables.places(self, "support"),
        }
        return frame(made, table, "time" if table == "contact channels" else None)

    def passage(self, place: Place, name: str, quantity: str | None = None) -> "xarray.DataArray":
        """Return a quantity of one dropper or one support over time.

        Parameters
        ----------
        place
            "dropper" or "support".
        name
            As the dimension of that name has it, such as "span 3 dropper 5".
        quantity
            Of a support ``support_uplift`` in m (without a name), ``support_force``,
            ``support_lateral_force`` and ``steady_arm_force`` in N, ``steady_arm_angle`` in rad,
            ``messenger_uplift`` in m; of a dropper ``dropper_force`` in N.

        Returns
        -------
        xarray.DataArray
            Over `line_time`: of a long line while the pantographs are near, else of the whole run.

        Raises
        ------
        ModelError
            There is no such place, or nothing of the kind was recorded.
        """
        import xarray

        index, channel = asked_for(self.dataset, place, name, quantity)
        rows, values = passage(self.dataset, place, index, channel)
        times = self.dataset["line_time"][rows]
        units = VARIABLES[channel].units
        return xarray.DataArray(
            values, {"line_time": times}, ("line_time",), channel, {"units": units}
        )

    def wire_stress(
        self,
        *,
        area: float | str | None = None,
        tension: float | str | None = None,
        exponent: float | str | None = None,
    ) -> "WireStress":
        """Return the stress of the contact wire at clamps and supports, and its cycles.

        See `arcless.assess.wire_stress.wire_stress`: area in m², tension in N, both also as texts
        with a unit, exponent m of a Wöhler line, and what is refused: a run that stopped early,
        among others.
        """
        from arcless.assess.wire_stress import wire_stress

        return wire_stress(
            self.latest, self.scenario, area=area, tension=tension, exponent=exponent
        )

    @cached_property
    def metadata(self) -> dict[str, Any]:
        """The dataset's attributes as plain Python values."""
        return metadata(self.latest)

    @property
    def is_complete(self) -> bool:
        """True when the run went to its end; otherwise `arcless.resume` continues it."""
        return self.metadata["state"] is None

    def save(self, path: str | Path) -> None:
        """Save the dataset as NetCDF, whole or not at all."""
        save(self.latest, path)

    def export(self, path: str | Path) -> None:
        """Write the run for other programs: CSV, Excel, MATLAB or Parquet, by the ending.

        Parameters
        ----------
        path
            ``.csv`` and ``.parquet`` have contact channels over time, ``.mat`` droppers, supports
            and these over time too, ``.xlsx`` assessment and criteria as well. A file that exists
            is replaced.

        Raises
        ------
        OutputError
            The ending is unknown, a package is not installed, or the file cannot be written.
        """
        from arcless.results.export.files import export

        export(self, path)

    def as_measured(self, instrument: "Instrument", pantograph: str | None = None) -> "Readings":
        """Return the run as an instrumented pantograph would have measured it.

        Parameters
        ----------
        instrument
            The sensors, such as ``Instrument(force_noise_N=2.0)`` of `arcless.results`.
        pantograph
            Name of the pantograph; the first in the direction of travel without.

        Raises
        ------
        ModelError
            There is no such pantograph, or the instrument does not fit it or the record.
        ResultFormatError
            The displacements of the pantograph's masses were not recorded.
        """
        from arcless.results.instrument.readings import read_off

        return read_off(self.latest, self.scenario, instrument, pantograph)

    def __repr__(self) -> str:
        facts = self.metadata
        return f"<Result {facts['scenario_name']}: {facts['simulated_time_s']:.2f} s simulated>"

    def _repr_html_(self) -> str:
        from arcless.assess.tables import parts, title_of

        facts = self.metadata
        about = f"{facts['simulated_time_s']:.2f} s simulated, Arcless {facts['arcless_version']}"
        if not self.is_complete:
            about += "; stopped early, arcless.resume continues it"
        try:
            told, over_all = self.assessment.to_dict(), self.assessment.headline
        except ModelError as error:
            return cards.card(facts["scenario_name"], about=f"{about}; not assessed: {error}")
        return cards.card(title_of(told), *parts(told, over_all), about=about)


def open_result(path: str | Path) -> Result:
    """Open a saved result.

    Parameters
    ----------
    path
        A file written by `Result.save` or ``arcless run``, or the folder of a run.

    Raises
    ------
    ResultFormatError
        The file is missing, damaged, or of another format version, or the place is no run: a study,
        say.
    """
    from arcless.model import load
    from arcless.model.scenario.as_typed import restore

    dataset = open_plain(run_file(path))
    facts = metadata(dataset)
    scenario = load(facts["scenario"])
    restore(scenario, facts["as_typed"])
    return Result(dataset, scenario)


def explain(
    run: Result | str | Path, sensitivities: "Sensitivities | None" = None
) -> "Explanation":
    """Explain the standard deviation σ of a run's contact force.

    Parameters
    ----------
    run
        A result, the folder of a run, or its file.
    sensitivities
        As `arcless.sensitivities` returns them, told with the rest.

    Raises
    ------
    ExplanationError
        The section has less than two spans, or a force is constant.
    ResultFormatError
        The file is missing, damaged, or of another format version.
    """
    found = run if isinstance(run, Result) else open_result(run)
    return found.explain(sensitivities)
