"""Parts of a comparison: runs and measurements, pantographs, numbers, fields, cautions."""

from collections.abc import Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from arcless.comparison.cautions import cautions
from arcless.comparison.fields import Field, changed_fields
from arcless.comparison.indicators import Indicator, Judged, indicators, judged
from arcless.comparison.measured.acceptance import Accepted, acceptance
from arcless.comparison.measured.bands import Band, bands_of
from arcless.comparison.measured.placing import Aligning
from arcless.comparison.subjects.runs import (
    Slot,
    Subject,
    check_names,
    matched,
    names_of,
    short_names,
)
from arcless.comparison.subjects.sides import Side, sides_of
from arcless.results import Result
from arcless.storage.digests import short_digest

FORMAT = "arcless-comparison/1"


@dataclass(frozen=True, eq=False)
class Compared:
    """Runs and measurements side by side, as data.

    Attributes
    ----------
    names
        A short name of each run, no two the same.
    full_names
        The whole name of each run.
    digests
        First 12 digits of the SHA-256 of each file; None for a run that is in memory.
    sides
        Runs and measurements, the first of which differences refer to, each with its numbers.
    pantographs
        The pantographs, matched.
    by_name
        Whether they are matched by their names, or by their order.
    indicators
        Numbers of pantographs and line in each run, with differences.
    criteria
        Criteria with the verdicts of each run.
    fields
        Fields in which the scenarios differ.
    warnings
        Sentences on what else differs.
    bands
        Standard deviations band by band; empty without a measurement.
    acceptance
        Each run against each measurement; empty where one of them is missing.
    """

    names: tuple[str, ...]
    full_names: tuple[str, ...]
    digests: tuple[str | None, ...]
    sides: tuple[Side, ...]
    pantographs: tuple[Slot, ...]
    by_name: bool
    indicators: tuple[Indicator, ...]
    criteria: tuple[Judged, ...]
    fields: tuple[Field, ...]
    warnings: tuple[str, ...]
    bands: tuple[Band, ...] = ()
    acceptance: tuple[Accepted, ...] = ()

    @property
    def results(self) -> tuple[Subject, ...]:
        """Runs and measurements."""
        return tuple(one.subject for one in self.sides)

    @property
    def files(self) -> tuple[Path | None, ...]:
        """Their files; None for a run that is in memory."""
        return tuple(one.file for one in self.sides)

    @property
    def placed_on(self) -> str | None:
        """Name of the run that measurements lie on; None without a measurement or without a run."""
        if all(one.placed is None for one in self.sides):
            return None
        runs = [name for name, one in zip(self.names, self.sides, strict=True)
                if one.placed is None]  # fmt: skip
        return runs[0] if runs else None

    def to_dict(self) -> dict[str, Any]:
        """Return the comparison as plain values, ready for JSON; see docs/guide/compare.md."""
        return {
            "format": FORMAT,
            "runs": [self._run(place) for place in range(len(self.sides))],
            "pantographs": [asdict(one) for one in self.pantographs],
            "matched_by": "name" if self.by_name else "order",
            "indicators": [asdict(one) for one in self.indicators],
            "criteria": [asdict(one) for one in self.criteria],
            "fields": [asdict(one) for one in self.fields],
            "warnings": list(self.warnings),
            "bands": [asdict(one) for one in self.bands],
            "acceptance": [asdict(one) for one in self.acceptance],
        }

    def _run(self, place: int) -> dict[str, Any]:
        side = self.sides[place]
        run, assessment = side.result, side.assessment
        return {
            "name": self.names[place],
            "full_name": self.full_names[place],
            "kind": "measurement" if run is None else "run",
            "file": None if side.file is None else str(side.file),
            "digest": self.digests[place],
            "scenario": None if run is None else run.scenario.name,
            "line": None if run is None else run.scenario.line.name,
            "speed_m_s": assessment.speed_m_s,
            "section_m": list(assessment.section_m),
            "low_pass_Hz": assessment.low_pass_Hz,
            "band_split_Hz": assessment.band_split_Hz,
            "pantographs": [one.name for one in assessment.pantographs],
            "arcless_version": None if run is None else run.metadata["arcless_version"],
            "created": None if run is None else run.metadata["created"],
            "passed": assessment.passed if assessment.is_judged else None,
            "measurement": assessment.measurement,
            "alignments": None
            if side.placed is None
            else [asdict(one) for one in side.placed.alignments],
        }


def data_of(
    subjects: Sequence[Subject],
    files: Sequence[Path | None],
    how: Aligning,
    called: Sequence[str] | None = None,
) -> dict[str, Any]:
    """Return the parts of a comparison of runs and measurements by their names.

    Raises
    ------
    ComparisonError
        The names that are given are not one for each, or two are the same; else as of `sides_of`.
    """
    if called is not None:
        check_names(called, len(subjects))
    slots, by_name = matched(subjects)
    sides = sides_of(subjects, files, slots, how)
    fields = _fields(subjects)
    words = _words(fields[0], subjects) if len(fields) == 1 else None
    full_names = list(called or names_of(subjects, files, words))
    names = list(called or short_names(full_names, subjects))
    assessments = [one.assessment for one in sides]
    return {
        "names": tuple(names),
        "full_names": tuple(full_names),
        "digests": tuple(None if one is None else short_digest(one) for one in files),
        "sides": tuple(sides),
        "pantographs": tuple(slots),
        "by_name": by_name,
        "indicators": tuple(indicators(assessments, slots)),
        "criteria": tuple(judged(assessments, slots)),
        "fields": tuple(fields),
        "warnings": tuple(cautions(sides, names, slots, by_name)),
        "bands": tuple(_bands(sides, slots)),
        "acceptance": tuple(_acceptance(sides, slots)),
    }


def _fields(subjects: Sequence[Subject]) -> list[Field]:
    """Return the fields in which runs differ; a measurement has none of them."""
    places = [place for place, one in enumerate(subjects) if isinstance(one, Result)]
    runs = [one for one in subjects if isinstance(one, Result)]
    if not runs:
        return []

    def spread(values: Sequence[Any], missing: Any) -> tuple[Any, ...]:
        found = [missing] * len(subjects)
        for place, value in zip(places, values, strict=True):
            found[place] = value
        return tuple(found)

    return [
        Field(one.path, spread(one.values, None), spread(one.si, ""), spread(one.is_default, False))
        for one in changed_fields([run.scenario for run in runs])
    ]


def _bands(sides: Sequence[Side], slots: Sequence[Slot]) -> list[Band]:
    """Return the bands of each pantograph, where a measurement takes part."""
    if all(one.placed is None for one in sides):
        return []
    first = sides[0].assessment
    found = []
    for slot in slots:
        signals = [
            None if place is None else one.signal(place)
            for one, place in zip(sides, slot.places, strict=True)
        ]
        found += bands_of(slot.name, signals, first.low_pass_Hz, first.band_split_Hz)
    return found


def _acceptance(sides: Sequence[Side], slots: Sequence[Slot]) -> list[Accepted]:
    """Return the tables of each run against each measurement."""
    found = []
    for here, run in enumerate(sides):
        for there, measured in enumerate(sides):
            if run.placed is None and measured.placed is not None:
                names = [(slot.name, slot.places[here], slot.places[there]) for slot in slots]
                both = run.assessment, measured.assessment
                found += acceptance((here, there), both, names)
    return found


def _words(field: Field, subjects: Sequence[Subject]) -> list[str | None]:
    """Return the last word of a field with its value in each run: ``speed 300 km/h``.

    None for a measurement, which has no fields.
    """
    words = [one for one in field.path.split(".") if not one.isdigit()]
    name = words[-1].replace("_", " ")
    return [
        f"{name} {'not given' if value is None else value}" if isinstance(one, Result) else None
        for one, value in zip(subjects, field.values, strict=True)
    ]
