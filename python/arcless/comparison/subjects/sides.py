"""Runs and measurements that are compared, each over the section that they share."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from arcless.assess import Assessment
from arcless.assess import assess as assess_dataset
from arcless.assess.signals.filter import sample_rate_Hz
from arcless.comparison.alignment import Alignment
from arcless.comparison.measured.placed import Placed
from arcless.comparison.measured.placing import Aligning, Reference, place, signal_of, trace_of
from arcless.comparison.measured.signal import Signal, settled
from arcless.comparison.subjects.runs import Slot, Subject
from arcless.errors import ComparisonError
from arcless.figures.run import RunData
from arcless.measurements import Measurement
from arcless.measurements import assess as assess_measurement
from arcless.measurements.samples.settled import BAND_SPLIT_HZ, LOW_PASS_HZ, edge_s
from arcless.results import Result

# Ends of sections are the same within this, in m: less than any reading of a plan.
SAME_PLACE_M = 1e-3
# Beginning of the reader's note on a file without positions.
COUNTED = "no positions in the file"


@dataclass(frozen=True, eq=False)
class Side:
    """One run, or one measurement, of a comparison.

    Attributes
    ----------
    subject
        The run or the measurement.
    file
        Its file; None for a run that is in memory.
    assessment
        Its numbers over the section that is compared.
    placed
        The measurement on the line; None of a run.
    """

    subject: Subject
    file: Path | None
    assessment: Assessment
    placed: Placed | None = None

    @property
    def result(self) -> Result | None:
        """The run; None of a measurement."""
        return self.subject if isinstance(self.subject, Result) else None

    def signal(self, pantograph: int) -> Signal:
        """Return the force of a pantograph over the section that is compared."""
        begin, end = self.assessment.section_m
        if self.placed is not None:
            return self.placed.signal(pantograph, (begin, end), _margin_s(self.assessment))
        assert isinstance(self.subject, Result)
        return _signal_of_run(self.subject, pantograph, (begin, end))


def drawn(sides: Sequence[Side]) -> list[RunData]:
    """Return what figures take of each side; measurements stand over the supports of the first run.

    Parameters
    ----------
    sides
        The runs and measurements.
    """
    base = _reference_of([one.subject for one in sides])
    supports, reach = _supports(base), (-np.inf, np.inf)
    if isinstance(base, Result):
        position = base.latest["position"].values
        reach = float(position.min()), float(position.max())
    found: list[RunData] = []
    for one in sides:
        if one.placed is not None:
            margin = _margin_s(one.assessment)
            found.append(one.placed.drawn(one.assessment, supports, margin, reach))
        else:
            assert isinstance(one.subject, Result)
            found.append(RunData(one.subject.latest, one.assessment))
    return found


def sides_of(
    subjects: Sequence[Subject],
    files: Sequence[Path | None],
    slots: Sequence[Slot],
    how: Aligning,
) -> list[Side]:
    """Return runs and measurements, measurements on the line of the first run.

    Without a run, measurements are placed on the positions of the first one.

    Parameters
    ----------
    subjects, files
        What is compared, and their files.
    slots
        Pantographs, matched.
    how
        How measurements are aligned.

    Raises
    ------
    ComparisonError
        A measurement cannot be aligned, or has nothing in common with the others.
    ModelError
        A run does not pass the section that they share.
    """
    if all(isinstance(one, Result) for one in subjects):
        return [
            Side(one, file, one.assessment)
            for one, file in zip(subjects, files, strict=True)
            if isinstance(one, Result)
        ]
    base = _reference_of(subjects)
    number = next(place for place, one in enumerate(subjects) if one is base)
    placed = [
        _placed(one, base, slots, (number, place), how) if isinstance(one, Measurement) else None
        for place, one in enumerate(subjects)
    ]
    section = _common(base, placed)
    found = []
    for one, file, on_line in zip(subjects, files, placed, strict=True):
        if on_line is not None:
            found.append(Side(one, file, _assessed(on_line, base, section), on_line))
        elif isinstance(one, Result):
            found.append(Side(one, file, _over(one, section)))
    return found


def _reference_of(subjects: Sequence[Subject]) -> Subject:
    """Return the first run, or the first measurement where there is no run."""
    return next((one for one in subjects if isinstance(one, Result)), subjects[0])


def _supports(base: Subject) -> np.ndarray:
    if isinstance(base, Measurement) or "support_x" not in base.latest:
        return np.empty(0)
    found: np.ndarray = np.unique(base.latest["support_x"].values)
    return found


def _cutoff_Hz(base: Subject) -> float:  # noqa: N802 - the unit is part of the name
    return base.assessment.low_pass_Hz if isinstance(base, Result) else LOW_PASS_HZ


def _margin_s(assessment: Assessment) -> float:
    return edge_s(assessment.low_pass_Hz, BAND_SPLIT_HZ)


def _placed(
    one: Measurement, base: Subject, slots: Sequence[Slot], numbers: tuple[int, int], how: Aligning
) -> Placed:
    """Return a measurement with each pantograph aligned with that of the reference."""
    cutoff = _cutoff_Hz(base)
    margin = edge_s(cutoff, BAND_SPLIT_HZ)
    there, here = numbers
    if one is base:
        return Placed.of(one, [
            Alignment("reference", each.first_m, each.last_m < each.first_m, 0.0, 1.0)
            for each in one.pantographs
        ])  # fmt: skip
    alignments = []
    for index, pantograph in enumerate(one.pantographs):
        of_base = next((slot.places[there] for slot in slots if slot.places[here] == index), None)
        other = [base.pantographs[of_base or 0]] if isinstance(base, Measurement) else []
        channel = how.channel_of(pantograph, *other)
        trace = trace_of(_whole_signal(base, of_base or 0, channel, margin), cutoff)
        on = Reference(trace, _supports(base), cutoff, margin, channel)
        counted = any(note.startswith(COUNTED) for note in one.notes)
        alignments.append(place(pantograph, on, how, str(one.path), counted=counted))
    return Placed.of(one, alignments)


def _whole_signal(base: Subject, pantograph: int, channel: str, margin_s: float) -> Signal:
    """Return a channel of a pantograph over all of its record without the ends."""
    if isinstance(base, Measurement):
        return signal_of(base.pantographs[pantograph], channel, margin_s, str(base.path))
    data = base.latest
    key = {"force": "contact_force", "height": "contact_height"}[channel]
    values, rate = data[key].values[:, pantograph], sample_rate_Hz(data["time"].values)
    pieces = (slice(0, values.size),)
    return Signal(
        data["position"].values[:, pantograph], values, rate, pieces,
        settled(values.size, pieces, rate, margin_s), float(data["speed"].values.mean()),
    )  # fmt: skip


def _signal_of_run(run: Result, pantograph: int, section_m: tuple[float, float]) -> Signal:
    data = run.latest
    position = data["position"].values[:, pantograph]
    counted = (position >= section_m[0]) & (position <= section_m[1])
    return Signal(
        position, data["contact_force"].values[:, pantograph],
        sample_rate_Hz(data["time"].values), (slice(0, position.size),), counted,
        float(data["speed"].values[counted].mean()),
    )  # fmt: skip


def _common(base: Subject, placed: Sequence[Placed | None]) -> tuple[float, float]:
    """Return the section that all have: that of the first run, as far as measurements reach."""
    margin = edge_s(_cutoff_Hz(base), BAND_SPLIT_HZ)
    ends = [base.assessment.section_m] if isinstance(base, Result) else []
    reached = [one.reach_m(margin) for one in placed if one is not None]
    begin = max(low for low, _ in [*ends, *reached])
    end = min(high for _, high in [*ends, *reached])
    if begin < end:
        return begin, end
    own = "the runs" if not ends else f"a part of {ends[0][0]:.1f} to {ends[0][1]:.1f} m"
    raise ComparisonError(
        "the measurement does not reach into the analysis section",
        got=", ".join(f"{low:.1f} to {high:.1f} m" for low, high in reached),
        expected=own,
        hint="give another offset (--offset), or assess the run over another section",
    )


def _assessed(on_line: Placed, base: Subject, section: tuple[float, float]) -> Assessment:
    """Return the numbers of a measurement by the filter and the supply of the reference."""
    supply = base.scenario.line.design.supply if isinstance(base, Result) else None
    return assess_measurement(
        on_line.measurement, supply=supply, section=section, low_pass_Hz=_cutoff_Hz(base),
        supports_m=_supports(base),
    )  # fmt: skip


def _over(run: Result, section: tuple[float, float]) -> Assessment:
    """Return the numbers of a run over a section; its own where that is the same."""
    same = np.allclose(run.assessment.section_m, section, rtol=0.0, atol=SAME_PLACE_M)
    return run.assessment if same else assess_dataset(run.latest, section=section)
