"""A long line from file to report: wall time of each stage, and the most memory up to its end.

    python benchmarks/long_line.py                50 km, 909 spans in tension lengths of 22
    python benchmarks/long_line.py 92             the first spans of it
    python benchmarks/long_line.py 92 one-wire    the same spans in one tension length

In a process of its own: the most memory of a process never goes down again.
"""

import resource
import sys
import tempfile
import time
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from arcless.model import Scenario

SCENARIO = Path(__file__).with_name("long-run.yaml")
HEAD = ("stage", "wall s", "most memory MB")


class Stages:
    """Prints a row whenever a stage ends."""

    def __init__(self) -> None:
        self.began = self.since = time.perf_counter()
        self.name = "imports"

    def __call__(self, _fraction: float, name: str) -> None:
        if name == self.name:
            return
        now = time.perf_counter()
        self._row(self.name, now - self.since)
        self.name, self.since = name, now

    def end(self, steps: int) -> None:
        self(1.0, "")
        self._row(f"all, {steps} steps", time.perf_counter() - self.began)

    @staticmethod
    def _row(name: str, seconds: float) -> None:
        kibibytes = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
        print(f"{name} | {seconds:.2f} | {kibibytes / 1024:.0f}", flush=True)


def shorter(scenario: "Scenario", spans: int, *, one_wire: bool) -> "Scenario":
    """Return the scenario with fewer spans, or without tension lengths."""
    lengths = [one for one in scenario.line.tension_length_list() if one.from_span + 3 <= spans]
    ends = [{"from_span": a.from_span, "to_span": min(a.to_span, spans)} for a in lengths]
    return scenario.with_(
        **{
            "line.spans.0.count": spans,
            "line.tension_lengths": None if one_wire else ends,
            "line.overlap": None if one_wire else scenario.line.overlap,
            "analysis.spans": [6, max(6, spans - 5)],
        }
    )


def main(spans: int | None, *, one_wire: bool) -> None:
    stage = Stages()
    print(" | ".join(HEAD))
    print(" | ".join("---" for _ in HEAD))
    import arcless

    stage(0.0, "model file")
    scenario = arcless.load(SCENARIO)
    if spans is not None:
        scenario = shorter(scenario, spans, one_wire=one_wire)
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "result.nc"
        result = arcless.run(scenario, to=file, progress=stage)
        stage(1.0, "assessment")
        assessment = result.assessment
        stage(1.0, "report")
        result.write_report(Path(folder) / "report.html")
        stage.end(assessment.steps)
        sizes = [
            f"{path.name} {path.stat().st_size / 1e6:.1f} MB"
            for path in (file, *file.parent.glob("*.html"))
        ]
    force = assessment.pantographs[0]
    print(f"{', '.join(sizes)}; F_m {force.mean_force_N:.2f} N, σ {force.std_force_N:.2f} N")


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else None, one_wire="one-wire" in sys.argv[2:])
