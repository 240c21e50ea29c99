"""The studies of a project: answers to the page's questions about them."""

import json
import os
from collections import OrderedDict
from collections.abc import Mapping
from dataclasses import asdict
from pathlib import Path
from typing import Any

from arcless import study
from arcless.errors import ArclessError, ModelError, OutputError, StudyError
from arcless.model import Scenario
from arcless.model.load import load_text
from arcless.results.kept_runs.search import search
from arcless.studio.answers.answers import complaint
from arcless.studio.project import texts
from arcless.studio.project.project import Project, is_shipped
from arcless.studio.studies.computing import Computing, already
from arcless.studio.studies.fields import fields
from arcless.studio.studies.kept_rows import KeptRows, definition
from arcless.studio.studies.variants import scenario_of
from arcless.studio.studies.writing import written
from arcless.study.definition.quantities import unit_of_key
from arcless.study.report.data.record import quantity_of
from arcless.units import show

# Keys of outputs that are offered by name; others are typed.
OFFERED = (
    "mean_force_N", "std_force_N", "max_force_N", "min_force_N", "statistical_max_N",
    "statistical_min_N", "contact_loss_percent", "NQ_percent", "max_uplift_at_support_mm",
    "min_dropper_force_N", "slack_droppers_max", "passed",
)  # fmt: skip
# Studies whose rows are kept in memory; a study of 10⁴ variants takes some megabytes.
MOST_KEPT = 4


class Desk:
    """Studies of a project."""

    def __init__(self, project: Project, computing: Computing) -> None:
        self._project, self._computing = project, computing
        self._kept: OrderedDict[Path, KeptRows] = OrderedDict()

    def fields(self, path: str) -> dict[str, Any]:
        """Return the fields of a scenario that can be varied, and the keys of outputs."""
        scenario = self._scenario(path)
        return {
            "name": scenario.name,
            "fields": [asdict(one) for one in fields(scenario)],
            "estimate_s": self._time_of_run(scenario.name),
            "workers": os.cpu_count() or 1,
            "outputs": [_output(key) for key in OFFERED],
        }

    def text(self, path: str, given: Mapping[str, Any]) -> dict[str, Any]:
        """Return the text of a study file, how many variants it has, and what is wrong with it.

        A file that is there is changed, so that its comments stay: `version` is the one that the
        text was made from, None of a new file, and `changes` whether it says something else.
        `begun` tells of a study of that name with rows: `same`, `other`, or None.
        """
        file = texts.model_file(self._project, path)
        there = texts.read(self._project, path) if file.exists() else None
        before = None if there is None else there["text"]
        about = {"version": there and there["version"], "begun": None}
        if there is not None and there["kind"] != "study":
            taken = ModelError("the name of another model", got=show(path),
                               expected="a name of its own", field=("name",))  # fmt: skip
            return {**about, "text": "", "changes": False, "count": None,
                    "errors": [complaint(taken)]}  # fmt: skip
        text = written(given, before)
        about |= {"text": text, "changes": before not in (None, text)}
        try:
            loaded = study.load_text(text, file, self._project.folder)
        except ArclessError as error:
            return {**about, "count": None, "errors": [complaint(error)]}
        begun = self._begun(loaded)
        return {**about, "begun": begun, "count": loaded.plan.count, "errors": []}

    def run(self, path: str, *, resume: bool, retry_failed: bool) -> dict[str, str]:
        """Start a study, or continue it; return its folder."""
        file = self._project.inside(path)
        loaded = study.load_text(texts.read(self._project, path)["text"], file,
                                 self._project.folder)  # fmt: skip
        place = self._place(loaded)
        folder = place.path
        if self._computing.is_running(folder):
            raise already(folder)
        if self._begun(loaded) and not resume:
            raise StudyError(
                "the study was begun already", where=self._project.name_of(folder),
                hint="continue it, or give it another name",
            )  # fmt: skip
        if resume:
            place.check_same()
        self._computing.start(
            file, folder, self._project.folder, resume=resume, retry_failed=retry_failed
        )
        return {"path": self._project.name_of(folder)}

    def stop(self, path: str) -> dict[str, str]:
        """Stop a study."""
        self._computing.stop(self._project.inside(path))
        return {"path": path}

    def about(self, path: str) -> dict[str, Any]:
        """Return what the study of a folder asks."""
        return definition(self._rows(path).place)

    def rows(self, path: str, after: int, edition: str, most: int) -> dict[str, Any]:
        """Return rows of a study after a number of rows, and how far it is."""
        folder = self._project.inside(path)
        starting = self._computing.is_running(folder)
        error = self._computing.error(folder)
        if not (folder / "study.json").exists() and (starting or error):
            return {"edition": "", "rows": [], "next": 0, "there": 0, "total": None, "counts": {},
                    "running": starting, "wall_time_s": 0.0, "missing": None, "error": error,
                    "own": starting, "criteria": [], "not_judged": []}  # fmt: skip
        found = self._rows(path).after(after, edition, most)
        running = found["running"] or starting
        return found | {"running": running, "error": None if running else error, "own": starting}

    def scenario(self, path: str, number: int, name: str) -> dict[str, str]:
        """Write a variant as a scenario file; return its path."""
        return scenario_of(self._project, self._rows(path).place, number, name)

    def report(self, path: str) -> bytes:
        """Return the page of a study's report, of the rows that are there."""
        folder = self._project.inside(path)
        self._computing.write_report(folder)
        return (folder / "report.html").read_bytes()

    def _place(self, loaded: study.Study) -> study.StudyFolder:
        folder = self._project.folder / study.StudyFolder(loaded).path
        self._project.inside(self._project.name_of(folder))
        return study.StudyFolder(loaded, folder)

    def _begun(self, loaded: study.Study) -> str | None:
        """Return whether the study's folder has rows: `same`, `other` of another study, or None."""
        place = self._place(loaded)
        if place.is_of_this_study:
            return "same" if next(place.rows(), None) is not None else None
        if place.state() is None:
            return None
        return "other" if next(study.open(place.path).rows(), None) is not None else None

    def _rows(self, path: str) -> KeptRows:
        folder = self._project.inside(path)
        if not folder.is_dir():
            raise OutputError("no such study", got=show(path), expected="the folder of a study")
        kept = self._kept.pop(folder, None) or KeptRows(folder)
        self._kept[folder] = kept
        while len(self._kept) > MOST_KEPT:
            self._kept.popitem(last=False)
        return kept

    def _scenario(self, path: str) -> Scenario:
        text = texts.read(self._project, path)["text"]
        within = None if is_shipped(path) else self._project.folder
        found = load_text(text, self._project.model_file(path), within)
        if not isinstance(found, Scenario):
            raise ModelError("no scenario", where=path, expected="a scenario file")
        return found

    def _time_of_run(self, name: str) -> float | None:
        """Return the time in s of the newest stored run of a scenario; None without one."""
        runs = [one for one in search(self._project.folder).runs if one.name == name]
        for one in sorted(runs, key=lambda run: run.created or "", reverse=True):
            try:
                about = json.loads((Path(one.path) / "assessment.json").read_text("utf-8"))
                return float(about["setup_time_s"] + about["wall_time_s"])
            except (OSError, ValueError, KeyError, TypeError):
                continue
        return None


def _output(key: str) -> dict[str, str]:
    return {"key": key, "label": quantity_of(key) or "all limits met", "unit": unit_of_key(key)}
