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
from arcless.units import show

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
        }

    def text(self, path: str, given: Mapping[str, Any], before: str | None) -> dict[str, Any]:
        """Return the text of a study file, how many variants it has, and what is wrong with it."""
        file = texts.model_file(self._project, path)
        text = written(given, before)
        try:
            loaded = study.load_text(text, file, self._project.folder)
        except ArclessError as error:
            return {"text": text, "count": None, "errors": [complaint(error)]}
        return {"text": text, "count": loaded.plan.count, "errors": []}

    def run(self, path: str, *, resume: bool, retry_failed: bool) -> dict[str, str]:
        """Start a study, or continue it; return its folder."""
        file = self._project.inside(path)
        loaded = study.load_text(texts.read(self._project, path)["text"], file,
                                 self._project.folder)  # fmt: skip
        folder = self._project.folder / study.StudyFolder(loaded).path
        self._project.inside(self._project.name_of(folder))
        if self._computing.is_running(folder):
            raise already(folder)
        place = study.StudyFolder(loaded, folder)
        there = place.state() is not None and next(place.rows(), None) is not None
        if there and not resume:
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
                    "own": starting}  # fmt: skip
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
