"""Dataset → Assessment: the numbers an engineer signs, and the verdict on each."""
# ruff: noqa: N815 - the names carry their units

import json
from collections.abc import Mapping
from dataclasses import asdict, dataclass, fields, replace
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from arcless.assess.certainty import COVERAGE, RUN_KEYS, Draw, Draws, numbers_of, student_factor
from arcless.assess.criteria import NOT_JUDGED, OF_RUN, Criterion, evaluate, verdict_of
from arcless.assess.facts import criteria_facts, lateral_mm, speed_notes, supply_notes, uplift_notes
from arcless.assess.rules import decides
from arcless.assess.section import (
    ForceRecord,
    Section,
    checked_cutoff,
    checked_section,
    extreme_inside,
    force_record,
    ran_over,
    section_notes,
    short_reasons,
    spans_run_over,
)
from arcless.assess.statistics import PantographAssessment, pantograph_assessment
from arcless.assess.tables import Headline, card, data_frame, headline, title_of
from arcless.assess.wear import WearRates, wear_notes, wear_rates
from arcless.dataset.metadata import metadata
from arcless.errors import ResultFormatError

if TYPE_CHECKING:
    import pandas

    from arcless.dataset.plain_dataset import Dataset


WEAR_KEYS = tuple(field.name for field in fields(WearRates))


@dataclass(frozen=True)
class Assessment:
    """Indicators and criteria of a run, or of a measurement, over one section.

    The names carry the units. A number that the record does not hold is None, and `notes` says why.
    """

    scenario: str
    version: str
    speed_m_s: float
    section_m: list[float]
    low_pass_Hz: float
    band_split_Hz: float
    pantographs: list[PantographAssessment]
    max_uplift_at_support_mm: float | None
    slack_droppers_max: int | None
    min_dropper_force_N: float | None
    energy_residual_relative: float | None
    steps: int | None
    """None of a measurement, as are the next three."""
    setup_time_s: float | None
    wall_time_s: float | None
    real_time_factor: float | None
    supply: str
    """Supply whose limits were taken."""
    criteria: list[Criterion]
    notes: list[str]
    certainty: dict[str, dict[str, float | None]] | None = None
    """Spread and discretisation of the numbers of the run, by key; None where nobody asked."""
    certainty_method: dict[str, Any] | None = None
    """Method by which they were found, see `arcless.assess.certainty`."""
    measurement: dict[str, Any] | None = None
    """Sampling of a measurement, and what of it was left out; None of a run."""
    ran_over_m: list[float] | None = None
    """Part of the section that the pantographs ran over; None where it is the whole of it."""
    stopped_m: float | None = None
    """Position of the first pantograph where the run stopped early; None of a whole run."""

    @property
    def passed(self) -> bool:
        """True when no deciding limit was missed; criteria too close to tell count as met."""
        return not any(criterion.fails for criterion in self.criteria)

    @property
    def is_judged(self) -> bool:
        """True when there is a verdict by a limit that decides, or one too close to tell."""
        return any(
            decides(one.mark) and verdict_of(asdict(one)) != NOT_JUDGED for one in self.criteria
        )

    @property
    def headline(self) -> Headline:
        """Verdict over all criteria in words; of a run that stopped early that of a part."""
        found = headline(self.criteria)
        if self.stopped_m is None:
            return found
        return replace(found, text=f"Of the part up to {self.stopped_m:.1f} m: {found.text}")

    @property
    def _in_words(self) -> str:
        found = self.headline
        return f"{found.text}; {found.rest}" if found.rest else found.text

    @property
    def section_words(self) -> str:
        """The section in words, and the part of it that was run over where it is not the whole."""
        begin, end = self.section_m
        text = f"{begin:.1f} m to {end:.1f} m"
        if self.ran_over_m is not None:
            first, last = self.ran_over_m
            text += f", of which {first:.1f} m to {last:.1f} m were run over"
        stop = (
            "" if self.stopped_m is None else f"; the run stopped early at {self.stopped_m:.1f} m"
        )
        return text + stop

    def to_dict(self) -> dict[str, Any]:
        """Return the assessment as plain values, ready for JSON.

        `verdict` is the headline over all criteria. Without coefficients of wear in the scenario
        there are no keys of wear; `certainty` is there where somebody asked for it, `measurement`
        where it is one, `ran_over_m` where that is a part of the section, `stopped_m` where the
        run stopped early.
        """
        data = {**asdict(self), "verdict": self._in_words}
        asked = ("certainty", "certainty_method", "measurement", "ran_over_m", "stopped_m")
        for part in (data, *data["pantographs"], *data["criteria"]):
            for name in asked:
                if name in part and part[name] is None:
                    del part[name]
        for pantograph in data["pantographs"]:
            if pantograph["wear_mechanical_mm3_km"] is None:
                for name in WEAR_KEYS:
                    del pantograph[name]
        return data

    @classmethod
    def from_dict(cls, data: Mapping[str, Any]) -> "Assessment":
        """Return the assessment whose `to_dict` is `data`.

        The headline follows from the criteria, so `verdict` is not read.

        Raises
        ------
        KeyError, TypeError
            Where fields are missing, or there are others.
        """
        nested: dict[str, Any] = {
            "pantographs": [PantographAssessment(**each) for each in data["pantographs"]],
            "criteria": [Criterion(**each) for each in data["criteria"]],
        }
        plain = {name: value for name, value in data.items() if name not in (*nested, "verdict")}
        return cls(**plain, **nested)

    def to_json(self) -> str:
        """Return the assessment as JSON text; it never holds a NaN."""
        return json.dumps(self.to_dict(), indent=2, ensure_ascii=False, allow_nan=False)

    def to_dataframe(
        self, table: Literal["quantities", "criteria"] = "quantities"
    ) -> "pandas.DataFrame":
        """Return quantities over pantographs by their keys, or the criteria, as a data frame.

        Raises
        ------
        OutputError
            There is no such table.
        """
        return data_frame(self.to_dict(), table)

    def __repr__(self) -> str:
        return f"<Assessment {title_of(vars(self))}: {self.headline.text}>"

    def _repr_html_(self) -> str:
        return card(self.to_dict(), self.headline)


def assess(
    dataset: "Dataset",
    *,
    section: Section | None = None,
    low_pass_Hz: float | None = None,
) -> Assessment:
    """Assess a run.

    Parameters
    ----------
    dataset
        As built by a run or opened from a file.
    section
        From and to in m along the track; the scenario's own section if not given. Each
        pantograph is assessed while it is itself inside.
    low_pass_Hz
        Cut-off of the low-pass in Hz; the scenario's own if not given.

    Returns
    -------
    Assessment

    Raises
    ------
    ModelError
        A pantograph was never inside the section, or the low-pass does not fit the record.
    """
    facts = metadata(dataset)
    limits = checked_section(section if section is not None else facts["section_m"])
    cutoff_Hz, split_Hz = _frequencies(facts["scenario"], low_pass_Hz)
    record = force_record(dataset, limits, cutoff_Hz, split_Hz)
    pantographs = _pantographs(dataset, record, facts["scenario"])
    wear = _wear(facts["scenario"].get("wear"), dataset["speed"].values, record, pantographs)
    pantographs = [replace(p, **asdict(wear[p.name])) if wear else p for p in pantographs]
    line = _line_numbers(dataset, limits, facts)
    speed = dataset["speed"].values[record.inside[:, 0]]
    notes = section_notes(dataset, limits, record, split_Hz)
    notes += _absences(line, facts["scenario"])
    notes += wear_notes(facts["scenario"].get("wear"), wear)
    judged_by = criteria_facts(facts, speed, line["max_uplift_at_support_mm"])
    notes += supply_notes(judged_by) + speed_notes(judged_by)
    notes += uplift_notes(line["max_uplift_at_support_mm"])
    own = ("steps", "setup_time_s", "wall_time_s", "real_time_factor")
    draws, method, about_draws = _draws(facts, limits, cutoff_Hz)
    if draws is not None:
        pantographs = [replace(p, certainty=draws.of_pantograph(p)) for p in pantographs]
    spans = {p.name: spans_run_over(dataset, limits, i) for i, p in enumerate(pantographs)}
    reasons = replace(OF_RUN, of_verdict=short_reasons(spans))
    return Assessment(
        scenario=facts["scenario_name"],
        version=facts["arcless_version"],
        speed_m_s=float(np.mean(speed)),
        section_m=list(limits),
        low_pass_Hz=cutoff_Hz,
        band_split_Hz=split_Hz,
        pantographs=pantographs,
        supply=judged_by.supply,
        criteria=evaluate(judged_by, pantographs, draws, reasons),
        notes=notes + about_draws,
        certainty=None if draws is None else draws.of_run(line),
        certainty_method=method,
        ran_over_m=ran_over(dataset, limits),
        stopped_m=None if facts["state"] is None else facts["state"]["position_m"],
        **line,
        **{name: facts[name] for name in own},
    )


def draw_of(assessment: Assessment) -> Draw:
    """Return the numbers that are kept of an assessed run that served another one's certainty."""
    return Draw(
        {each.name: numbers_of(each) for each in assessment.pantographs},
        {key: getattr(assessment, key) for key in RUN_KEYS},
        {(c.name, c.pantograph): (c.value, c.limit) for c in assessment.criteria},
    )


def _draws(
    facts: Mapping[str, Any], section: Section, low_pass_Hz: float
) -> tuple[Draws | None, dict[str, Any] | None, list[str]]:
    """Return the additional runs, how they were made, and remarks about them."""
    found, asked = facts["certainty"], facts["scenario"].get("certainty")
    if found is None:
        missing = "the certainty of the numbers was requested, and is not computed here"
        return None, None, [missing] if asked else []
    own = [*facts["section_m"], facts["scenario"]["analysis"]["low_pass"]]
    if [*section, low_pass_Hz] != own:
        other = "how sure the numbers are is known for the scenario's own section and filter alone"
        return None, None, [other]
    try:
        draws = Draws.of(found)
    except (AttributeError, KeyError, TypeError, ValueError) as error:
        what = "what the result says of its companion runs is damaged"
        raise ResultFormatError(what, where="attribute `certainty`") from error
    method = {key: value for key, value in found.items() if key not in ("draws", "refined")}
    count = 1 + len(draws.starts)
    method |= {"runs": count, "coverage": COVERAGE}
    method["student_factor"] = student_factor(count - 1) if count > 1 else None
    return draws, method, list(found["notes"])


def _absences(line: Mapping[str, Any], scenario: Mapping[str, Any]) -> list[str]:
    """Return notes about quantities that are missing from a record and could be there."""
    solver = scenario["solver"]
    never = set()
    if scenario["line"].get("messenger_wire") is None:
        never.add("min_dropper_force_N")
    # A run with a ledger and updated kinematics is refused.
    if solver["kinematics"] == "updated":
        never.add("energy_residual_relative")
    return [_absent(n) for n, value in line.items() if value is None and n not in never]


def _absent(name: str) -> str:
    if name == "energy_residual_relative":
        return "no energy balance was kept; `output.energy: always` keeps one"
    return f"{name} is not in the record"


def _frequencies(scenario: Mapping[str, Any], low_pass_Hz: float | None) -> tuple[float, float]:
    analysis = scenario["analysis"]
    cutoff = analysis["low_pass"] if low_pass_Hz is None else low_pass_Hz
    return checked_cutoff(cutoff), float(analysis["band_split"])


def _pantographs(
    dataset: "Dataset", record: ForceRecord, scenario: Mapping[str, Any]
) -> list[PantographAssessment]:
    sways = {each["name"]: each.get("sway") or 0.0 for each in scenario["pantographs"]}
    gap, height = dataset["contact_gap"].values, dataset["contact_height"].values
    return [
        pantograph_assessment(
            str(name),
            record.inside[:, i],
            force=record.force[:, i],
            bands=record.bands.of(i),
            gap=gap[:, i],
            height=height[:, i],
            step_s=1.0 / record.rate_Hz,
            lateral_mm=lateral_mm(dataset, i, record.inside[:, i], sways.get(str(name), 0.0)),
        )
        for i, name in enumerate(dataset["pantograph"].values)
    ]


def _wear(
    given: Mapping[str, Any] | None,
    speed: Any,
    record: ForceRecord,
    pantographs: list[PantographAssessment],
) -> dict[str, WearRates]:
    """Return the wear by each pantograph, at its own mean speed in the section."""
    if given is None:
        return {}
    return {
        p.name: wear_rates(
            given,
            p.mean_force_N,
            p.contact_loss_percent,
            float(np.mean(speed[record.inside[:, i]])),
        )
        for i, p in enumerate(pantographs)
    }


def _line_numbers(dataset: "Dataset", section: Section, facts: Mapping[str, Any]) -> dict[str, Any]:
    uplift = extreme_inside(dataset, "support_uplift_max", "support_x", section, largest=True)
    return {
        "max_uplift_at_support_mm": None if uplift is None else 1e3 * uplift,
        "slack_droppers_max": facts["slack_droppers_max"],
        "min_dropper_force_N": extreme_inside(
            dataset, "dropper_force_min", "dropper_x", section, largest=False
        ),
        "energy_residual_relative": facts["energy_residual_relative"],
    }
