"""Run → Explanation: which part of σ repeats with what, and where the force deviates most."""

from dataclasses import dataclass
from math import inf
from typing import TYPE_CHECKING, Any

import numpy as np

from arcless.assess import Assessment
from arcless.assess.section import force_record, run_over
from arcless.dataset.metadata import metadata
from arcless.display import cards
from arcless.display.numbers import number
from arcless.explanation import tables
from arcless.explanation.landmarks import Landmarks
from arcless.explanation.pantograph_explanation import PantographExplanation, Passage, explained
from arcless.explanation.sensitivity import Sensitivities
from arcless.explanation.signals.line_coordinate import LineCoordinate
from arcless.explanation.signals.orders import ABOVE_LOW_PASS, MOST_ORDERS
from arcless.explanation.signals.span_deviations import whole_spans
from arcless.model import Scenario
from arcless.pantograph.natural_modes import Band, PantographMode, modes, why_no_modes
from arcless.units import plain

if TYPE_CHECKING:
    from arcless.dataset.plain_dataset import Dataset

FORMAT = "arcless-explanation/1"


@dataclass(frozen=True)
class Explanation:
    """Explanation of the standard deviation σ of a run's contact forces.

    Attributes
    ----------
    scenario
        Name of the scenario.
    speed_m_s, section_m, low_pass_Hz
        As assessed.
    pantographs
        One for each pantograph.
    notes
        Sentences on what could not be told, and why.
    sensitivities
        Sensitivities of σ; None where they were not computed.
    """

    scenario: str
    speed_m_s: float
    section_m: tuple[float, float]
    low_pass_Hz: float  # noqa: N815 - unit in the name
    pantographs: tuple[PantographExplanation, ...]
    notes: tuple[str, ...]
    sensitivities: Sensitivities | None = None

    @property
    def sentences(self) -> list[str]:
        """The explanation in words; of several pantographs each sentence names its own."""
        return [
            f"{one.name}: {text}" if len(self.pantographs) > 1 else text
            for one in self.pantographs
            for text in one.sentences(self.sensitivities)
        ]

    def tables(self) -> list[dict[str, Any]]:
        """Return sentences and tables of each pantograph as text, for pages."""
        return tables.tables(self.pantographs, self.sensitivities)

    def __repr__(self) -> str:
        deviations = [one.std_force_N for one in self.pantographs]
        least, most = number(min(deviations)), number(max(deviations))
        whose = "1 pantograph" if len(deviations) == 1 else f"{len(deviations)} pantographs"
        told = least if least == most else f"{least} to {most}"
        speed = f"{3.6 * self.speed_m_s:.1f} km/h"
        return f"<Explanation {plain(self.scenario)} at {speed}: {whose}, σ = {told} N>"

    def _repr_html_(self) -> str:
        shown = [
            part
            for one in self.pantographs
            for part in (
                cards.listed([f"{one.name}: {text}" for text in one.sentences(self.sensitivities)]),
                cards.table(tables.GROUPS, tables.group_rows(one), numbers=tables.GROUPS[1:]),
            )
        ]
        return cards.card(f"Why σ is as it is: {self.scenario}", *shown)

    def to_dict(self) -> dict[str, Any]:
        """Return plain values, ready for JSON; see docs/guide/why-sigma.md."""
        known = self.sensitivities
        return {
            "format": FORMAT,
            "scenario": self.scenario,
            "speed_m_s": self.speed_m_s,
            "section_m": list(self.section_m),
            "low_pass_Hz": self.low_pass_Hz,
            "sentences": self.sentences,
            "pantographs": [one.to_dict() for one in self.pantographs],
            "sensitivities": None if known is None else known.to_dict(),
            "notes": list(self.notes),
        }


def explain(
    dataset: "Dataset",
    assessment: Assessment,
    scenario: Scenario,
    sensitivities: Sensitivities | None = None,
) -> Explanation:
    """Explain σ of a run's contact forces over its assessed section.

    Parameters
    ----------
    dataset
        As built by a run or opened from a file.
    assessment
        Assessment whose section and filter are taken.
    scenario
        Scenario that was run.
    sensitivities
        Sensitivities of σ, told with the rest.

    Raises
    ------
    ExplanationError
        The section has less than two spans, or a force is constant.
    """
    begin, end = assessment.section_m
    section = (begin, end)
    record = force_record(dataset, section, assessment.low_pass_Hz, assessment.band_split_Hz)
    line, marks = LineCoordinate.of(scenario.line), Landmarks.of(scenario)
    notes = _notes(dataset, assessment, line)
    position, found = dataset["position"].values, []
    for i, placement in enumerate(scenario.pantographs):
        inside, path = record.inside[:, i], position[:, i]
        own, why = _modes(dataset, scenario, i)
        notes += [] if why is None else [f"no modes of pantograph {placement.name}: {why}"]
        ran = (float(path[0]), float(path[-1]))
        passage = Passage(
            name=str(dataset["pantograph"].values[i]),
            position=path[inside],
            force=record.bands.total[inside, i],
            rate_Hz=record.rate_Hz,
            low_pass_Hz=assessment.low_pass_Hz,
            speed=float(np.mean(dataset["speed"].values[inside])),
            ends=run_over(position, i, section),
            spans=whole_spans(line.supports, section, ran),
            modes=own,
        )
        found.append(explained(passage, line, marks))
    return Explanation(
        scenario.name, assessment.speed_m_s, section, assessment.low_pass_Hz, tuple(found),
        tuple(dict.fromkeys(notes)), sensitivities,
    )  # fmt: skip


def _modes(
    dataset: "Dataset", scenario: Scenario, number: int
) -> tuple[list[PantographMode], str | None]:
    """Return the modes of a pantograph on the line, or none and why."""
    why = why_no_modes(scenario.pantographs[number].model)
    if why is not None:
        return [], why
    if "elasticity" not in dataset:
        return [], "the record has no elasticity of the line"
    values = dataset["elasticity"].values
    mean = float(np.trapezoid(values) / (values.size - 1))
    elasticity = Band(float(values.min()), mean, float(values.max()))
    stiffness = inf if scenario.contact.law == "rigid" else scenario.contact.stiffness
    return modes(scenario.pantographs[number].model, elasticity, stiffness), None


def _notes(dataset: "Dataset", assessment: Assessment, line: LineCoordinate) -> list[str]:
    begin, end = assessment.section_m
    found = []
    if metadata(dataset)["state"] is not None:
        found.append("the run stopped early: the section is that part of it which was run over")
    if line.intervals_per_span(begin, end) is None:
        found.append("the line has no droppers that repeat within a span")
    passing = assessment.speed_m_s / float(np.diff(line.supports).mean())
    if ABOVE_LOW_PASS * assessment.low_pass_Hz > MOST_ORDERS * passing:
        shortest = float(np.diff(line.supports).mean()) / MOST_ORDERS
        found.append(f"waves shorter than {shortest:.2g} m belong to the rest")
    return found
