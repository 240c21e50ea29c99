"""A long line from file to report: wall time of each stage, and the most memory up to its end.

    python benchmarks/long_line.py           50 km, 909 spans
    python benchmarks/long_line.py 90        so many spans of the same line

In a process of its own: the most memory of a process never goes down again.
"""

import resource
import sys
import tempfile
import time
from pathlib import Path

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


def main(spans: int | None) -> None:
    stage = Stages()
    print(" | ".join(HEAD))
    print(" | ".join("---" for _ in HEAD))
    import arcless

    stage(0.0, "model file")
    scenario = arcless.load(SCENARIO)
    if spans is not None:
        scenario = scenario.with_(
            **{"line.spans.0.count": spans, "analysis.spans": [6, max(6, spans - 5)]}
        )
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
    main(int(sys.argv[1]) if len(sys.argv) > 1 else None)
