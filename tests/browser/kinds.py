"""Pages of every kind, each made by the command that a user types."""

import subprocess
import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import yaml

from arcless.model import load
from arcless.pantograph.receptance import fit, text
from arcless.report.receptance import page as receptance_page
from arcless.results import Result
from tests.support.receptances import FREQUENCIES, measured, table
from tests.support.studies import SHORT, filled, written
from tests.support.synthetic import scenario_data, synthetic_dataset

# What a name must not do to a page: be markup, close a script, be a formula, name a column, turn
# the text around. Marks of direction are refused in model files; letters that run left are not.
MARKUP = "<img src=x onerror=window.hacked=1></script><script>window.hacked=1</script>"
HOSTILE = f"{MARKUP} \"quoted\" 'quoted' $$x$$ \u05d0\u05d1\u05d2 &amp; @x"


def arcless(*words: object) -> None:
    """Run a command; a criterion that is not met is a result."""
    command = [sys.executable, "-m", "arcless", *map(str, words)]
    done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=300)
    assert done.returncode in (0, 3), done.stderr


def scenario(folder: Path, **changes: Any) -> Path:
    """Write the short scenario with other values; those of the line are added to its own."""
    data = yaml.safe_load(SHORT.read_text("utf-8"))
    data["line"] |= changes.pop("line", {})
    file = folder / "scenario.yaml"
    file.write_text(yaml.safe_dump({**data, **changes}, allow_unicode=True), "utf-8")
    return file


def pantographs(*names: str) -> list[dict[str, Any]]:
    """Return that many pantographs of the short scenario, 40 m apart."""
    (first,) = yaml.safe_load(SHORT.read_text("utf-8"))["pantographs"]
    return [{**first, "name": name, "distance": f"{40 * i} m"} for i, name in enumerate(names)]


def run(folder: Path, **changes: Any) -> Path:
    """Make the page of a run."""
    arcless("run", scenario(folder, **changes), "--out", folder, "--quiet")
    return folder / "report.html"


def two_wires(folder: Path) -> Path:
    """Make the page of a run of two pantographs below two contact wires."""
    twin = {"twin_contact_wires": {"separation": "40 mm", "droppers": "alternating"}}
    return run(folder, line=twin, pantographs=pantographs("leading", "trailing"))


def statics(folder: Path, **changes: Any) -> Path:
    """Make the page of a line at rest."""
    file = scenario(folder, **changes)
    arcless("statics", file, "--plot", folder / "statics.html", "--quiet")
    return folder / "statics.html"


def study(folder: Path, **changes: Any) -> Path:
    """Make the page of a study of two variables, its rows made up."""
    file = written(folder, **changes)
    filled(folder / "rows", **changes)
    arcless("study", "report", file, "--out", folder / "rows", "--to", folder / "study.html")
    return folder / "study.html"


def validation(folder: Path) -> Path:
    """Make the page of a suite of reference cases."""
    page = folder / "validation.html"
    arcless("validate", "seed", "--once", "--report", page, "--quiet")
    return page


def comparison(folder: Path, **changes: Any) -> Path:
    """Make the page of two runs, of which the second is faster."""
    file = scenario(folder, **changes)
    arcless("run", file, "--out", folder / "before", "--quiet", "--no-report")
    faster = ("--set", "speed=170 km/h", "--out", folder / "after")
    arcless("run", file, *faster, "--quiet", "--no-report")
    arcless("compare", folder / "before", folder / "after", "--out", folder / "compare.html")
    return folder / "compare.html"


def receptance(folder: Path) -> Path:
    """Make the page of a measured frequency response, which has a full damping matrix."""
    file = folder / "bench.csv"
    file.write_text(table(measured("en50318-2002", 0.03, frequency=FREQUENCIES[::3])), "utf-8")
    page = folder / "bench.html"
    arcless("pantograph", "fit", file, "--order", "2", "--damping", "full", "--report", page)
    return page


TEXTS = {"name": HOSTILE, "description": HOSTILE}


def hostile_run(folder: Path) -> Path:
    """Make the page of a result with names that no run writes, as another program might."""
    marked = f"\u202e{HOSTILE}\u202c"
    data = scenario_data(**TEXTS, line__name=HOSTILE, line__description=HOSTILE)
    dataset = synthetic_dataset(
        scenario=data,
        pantographs=(marked, "$$x$$"),
        stagger_m=0.2,
        attrs={
            "time_step_s": 1e-3,
            "command": marked,
            "warnings": [marked],
            "arcless_version": marked,
        },
    )
    places = {name: [f"{marked} {i}" for i in range(dataset.sizes[name])]
              for name in ("dropper", "support")}  # fmt: skip
    result = Result(dataset.assign_coords(places), load(data))
    result.write_report(folder / "report.html")
    return folder / "report.html"


def hostile_statics(folder: Path) -> Path:
    """Make the page of a line at rest in which every name is hostile."""
    return statics(folder, **TEXTS, line=TEXTS)


def hostile_study(folder: Path) -> Path:
    """Make the page of a study whose names are hostile."""
    return study(folder, name=HOSTILE, description=HOSTILE)


def hostile_comparison(folder: Path) -> Path:
    """Make the page of a comparison whose names are hostile."""
    return comparison(folder, **TEXTS, line=TEXTS, pantographs=pantographs(HOSTILE))


def hostile_receptance(folder: Path) -> Path:
    """Make the page of a frequency response whose table and pantograph have hostile names."""
    bench = measured("en50318-2002", 0.03, frequency=FREQUENCIES[::3])
    found = fit(replace(bench, name=HOSTILE, digest=HOSTILE), 2)
    receptance_page.write(found, [found], HOSTILE, text(found, HOSTILE), folder / "bench.html")
    return folder / "bench.html"


PAGES: dict[str, Callable[[Path], Path]] = {
    "run": run, "two wires": two_wires, "statics": statics, "study": study,
    "validation": validation, "comparison": comparison, "receptance": receptance,
}  # fmt: skip
HOSTILE_PAGES: dict[str, Callable[[Path], Path]] = {
    "run": hostile_run, "statics": hostile_statics, "study": hostile_study,
    "comparison": hostile_comparison, "receptance": hostile_receptance,
}  # fmt: skip
