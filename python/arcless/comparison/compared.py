"""Parts of a comparison: runs, pantographs, numbers, changed fields, cautions."""

from collections.abc import Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from arcless.comparison.cautions import cautions
from arcless.comparison.fields import Field, changed_fields
from arcless.comparison.indicators import Indicator, Judged, indicators, judged
from arcless.comparison.runs import Slot, matched, names_of
from arcless.results import Result

FORMAT = "arcless-comparison/1"


@dataclass(frozen=True, eq=False)
class Compared:
    """Runs side by side, as data.

    Attributes
    ----------
    names
        A short name of each run, no two the same.
    results
        The runs, the first of which differences refer to.
    files
        Their files; None for a run that is in memory.
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
    """

    names: tuple[str, ...]
    results: tuple[Result, ...]
    files: tuple[Path | None, ...]
    pantographs: tuple[Slot, ...]
    by_name: bool
    indicators: tuple[Indicator, ...]
    criteria: tuple[Judged, ...]
    fields: tuple[Field, ...]
    warnings: tuple[str, ...]

    def to_dict(self) -> dict[str, Any]:
        """Return the comparison as plain values, ready for JSON; see docs/guide/compare.md."""
        return {
            "format": FORMAT,
            "runs": [self._run(place) for place in range(len(self.results))],
            "pantographs": [asdict(one) for one in self.pantographs],
            "matched_by": "name" if self.by_name else "order",
            "indicators": [asdict(one) for one in self.indicators],
            "criteria": [asdict(one) for one in self.criteria],
            "fields": [asdict(one) for one in self.fields],
            "warnings": list(self.warnings),
        }

    def _run(self, place: int) -> dict[str, Any]:
        result, file = self.results[place], self.files[place]
        assessment, facts = result.assessment, result.metadata
        return {
            "name": self.names[place],
            "file": None if file is None else str(file),
            "scenario": result.scenario.name,
            "line": result.scenario.line.name,
            "speed_m_s": assessment.speed_m_s,
            "section_m": list(assessment.section_m),
            "low_pass_Hz": assessment.low_pass_Hz,
            "band_split_Hz": assessment.band_split_Hz,
            "pantographs": [one.name for one in assessment.pantographs],
            "arcless_version": facts["arcless_version"],
            "created": facts["created"],
            "passed": assessment.passed,
        }


def data_of(results: Sequence[Result], files: Sequence[Path | None]) -> dict[str, Any]:
    """Return the parts of a comparison of runs by their names."""
    fields = changed_fields([one.scenario for one in results])
    names = names_of(results, files, _words(fields[0]) if len(fields) == 1 else None)
    slots, by_name = matched(results)
    assessments = [one.assessment for one in results]
    return {
        "names": tuple(names),
        "results": tuple(results),
        "files": tuple(files),
        "pantographs": tuple(slots),
        "by_name": by_name,
        "indicators": tuple(indicators(assessments, slots)),
        "criteria": tuple(judged(assessments, slots)),
        "fields": tuple(fields),
        "warnings": tuple(cautions(results, names, slots, by_name)),
    }


def _words(field: Field) -> list[str]:
    """Return the last word of a field with its value in each run: ``speed 300 km/h``."""
    words = [one for one in field.path.split(".") if not one.isdigit()]
    name = words[-1].replace("_", " ")
    return [f"{name} {'not given' if value is None else value}" for value in field.values]
