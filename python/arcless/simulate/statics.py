"""Statics: the initial configuration of a line, and the speeds at which it may resonate."""

from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from arcless.display.frames import frame
from arcless.equilibrium import equilibrium
from arcless.equilibrium.initial_configuration import InitialConfiguration, Progress
from arcless.equilibrium.line_alone import LineAlone
from arcless.model import Line, Scenario
from arcless.simulate.schedules import (
    allowance,
    check_ending,
    dropper_schedule,
    support_schedule,
)
from arcless.storage.csv_files import Column, write_csv
from arcless.units import plain

if TYPE_CHECKING:
    import pandas
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure as Drawing

    from arcless.figures.description import Figure
    from arcless.figures.description.tokens import Scheme
    from arcless.simulate.resonance import ResonanceSpeeds


@dataclass(frozen=True)
class StaticsResult(InitialConfiguration):
    """Result of `arcless.statics`; `to_dict` gives the documented JSON. SI units unless named."""

    @cached_property
    def resonance_speeds(self) -> "ResonanceSpeeds":
        """Speeds at which line and pantographs may resonate; none of a line without these."""
        from arcless.simulate.resonance import resonance_speeds

        return resonance_speeds(self)

    @cached_property
    def figures(self) -> "dict[str, list[Figure]]":
        """Figures of the line at rest by their keys; without such parts a key has none."""
        from arcless.figures.statics import LineData, figures

        return figures(LineData(self))

    def plot(
        self,
        key: str = "side_view",
        axes: "Axes | None" = None,
        *,
        scheme: "Scheme" = "light",
        width_mm: float | None = None,
    ) -> "Drawing":
        """Draw one of the figures by matplotlib; the arguments are those of `Result.plot`."""
        from arcless.figures import paper

        return paper.plot(self.figures, key, axes, scheme=scheme, width_mm=width_mm)

    def to_dataframe(
        self, table: Literal["droppers", "supports", "elasticity"] = "droppers"
    ) -> "pandas.DataFrame":
        """Return droppers, supports, or the elasticity of the middle span, as a data frame.

        Raises
        ------
        ModelError
            The line has no droppers.
        OutputError
            There is no such table.
        """
        elasticity = [1e3 * one for one in self.elasticity_m_per_N]
        tables = {
            "droppers": lambda: dropper_schedule(self),
            "supports": lambda: support_schedule(self),
            "elasticity": lambda: [
                Column("position", "m", self.elasticity_x_m),
                Column("elasticity", "mm/N", elasticity),
            ],
        }
        return frame(tables, table, "position" if table == "elasticity" else None)

    def __repr__(self) -> str:
        spans = self.scenario.line.in_words()[0]
        droppers = len(self.equilibrium.mesh.droppers)
        return f"<StaticsResult {plain(self.scenario.line.name)}: {spans}, {droppers} droppers>"

    def _repr_html_(self) -> str:
        from arcless.report.statics_card import card

        return card(self)

    def write_droppers(self, path: str | Path, allowance_m: float | str = 0.0) -> None:
        """Write the dropper schedule as CSV: positions, lengths, cut lengths, forces at rest.

        Parameters
        ----------
        path
            The file, NAME.csv; one that exists is replaced.
        allowance_m
            Length that the cut length has beyond the unstretched length: in m, or a text with its
            unit such as "30 mm"; 1 m at most.

        Raises
        ------
        ModelError
            The line has no droppers; the allowance is no length, is negative, or above 1 m.
        OutputError
            The name does not end in .csv, or the file cannot be written.
        """
        check_ending(path)
        write_csv(path, dropper_schedule(self, allowance(allowance_m)))

    def write_supports(self, path: str | Path) -> None:
        """Write heights, stagger, loads, lateral and steady-arm forces at all supports as CSV.

        Parameters
        ----------
        path
            The file, NAME.csv; one that exists is replaced.

        Raises
        ------
        OutputError
            The name does not end in .csv, or the file cannot be written.
        """
        check_ending(path)
        write_csv(path, support_schedule(self))

    def to_dict(self) -> dict[str, Any]:
        """Return plain values, ready for JSON."""
        return {
            "scenario": self.scenario.name if isinstance(self.scenario, Scenario) else None,
            "line": self.scenario.line.name,
            "middle_span": self.middle_span,
            "droppers": self.droppers,
            "supports": self.supports,
            "spans": self.spans,
            "wires": self.wires,
            "stitch_wires": self.stitch_wires,
            "bridles": self.bridles,
            "elasticity": [
                {"x_m": x, "mm_per_N": 1e3 * e}
                for x, e in zip(self.elasticity_x_m, self.elasticity_m_per_N, strict=True)
            ],
            "elasticity_nonuniformity": self.elasticity_nonuniformity,
            "contact_wire_sag_m": self.contact_wire_sag_m,
            "contact_wire_lateral_max_m": self.contact_wire_lateral_max_m,
            "wave_speed_m_s": self.wave_speed,
            "natural_frequencies_Hz": self.natural_frequencies_Hz,
            "resonance_speeds": self.resonance_speeds.to_dict(),
            "as_built": self.as_built,
        }


def statics(source: Scenario | Line, progress: Progress | None = None) -> StaticsResult:
    """Find the initial configuration of a scenario's line, or of a line alone.

    Parameters
    ----------
    source
        A scenario, whose line, elements and `as_built` are used; or a line, which is found as it
        was designed, on cubic elements.
    progress
        Called with the fraction done and what is being done.

    Raises
    ------
    MeshError, EquilibriumError
        See `arcless.equilibrium.equilibrium.find`.
    """
    return StaticsResult.of(source, progress)


def check_at_rest(checked: Scenario | Line) -> None:
    """Find the line at rest, of a scenario or by itself as it was designed.

    Raises
    ------
    MeshError, EquilibriumError
        See `arcless.equilibrium.equilibrium.find`.
    """
    equilibrium.find(checked if isinstance(checked, Scenario) else LineAlone(checked))
