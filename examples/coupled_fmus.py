"""Couple the FMU of a line with the FMU of a pantograph, in three ways, and compare with one model.

    python examples/coupled_fmus.py [SECONDS]

Needs FMPy: pip install 'arcless[fmi]'. Prints the largest difference of the contact force from that
of the loop in which line and pantograph are one model; where there is none, the step after which
the force has left all bounds.
"""

import sys
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import fmpy

import arcless
from arcless.fmi import export_fmu

Exchange = Callable[["Fmu", "Fmu"], float]
# A contact force beyond this has left all bounds, N: thirty times the largest of the run.
BOUND = 15_000.0


class Fmu:
    """An instance of an FMU 2.0 with variables by their names."""

    def __init__(self, path: Path, folder: Path) -> None:
        fmpy.extract(str(path), str(folder))
        described = fmpy.read_model_description(str(folder))
        self.numbers = {v.name: v.valueReference for v in described.modelVariables}
        self.fmu: Any = fmpy.instantiate_fmu(str(folder), described, logger=lambda *_: None)
        self.fmu.setupExperiment(startTime=0.0)
        self.fmu.enterInitializationMode()
        self.fmu.exitInitializationMode()
        self.h, self.steps = self.get("step_length"), 0

    def get(self, name: str) -> float:
        """Return a value."""
        return float(self.fmu.getReal([self.numbers[name]])[0])

    def set(self, name: str, value: float) -> None:
        """Set an input."""
        self.fmu.setReal([self.numbers[name]], [value])

    def step(self) -> None:
        """Take a step."""
        self.fmu.doStep(self.steps * self.h, self.h)
        self.steps += 1


def by_strip(line: Fmu, pantograph: Fmu) -> float:
    """Take a step of a line that is given the strip: it solves the contact."""
    line.set("P1.strip_height", pantograph.get("free_height"))
    line.set("P1.strip_compliance", pantograph.get("compliance"))
    line.step()
    force = line.get("P1.contact_force")
    pantograph.set("contact_force", force)
    pantograph.step()
    return force


def by_compliance(line: Fmu, pantograph: Fmu) -> float:
    """Take a step of a line that is given the force, solved here from both compliances."""
    old = line.get("old_weight")
    strip = old * pantograph.get("strip_height") + (1.0 - old) * pantograph.get("free_height")
    overlap = strip - line.get("P1.free_height")
    soft = (1.0 - old) * pantograph.get("compliance") + line.get("compliance")
    force = max(0.0, overlap / (soft + line.get("contact_flexibility")))
    for fmu, name in ((line, "P1.contact_force"), (pantograph, "contact_force")):
        fmu.set(name, force)
        fmu.step()
    return force


def plain(stiffness: float) -> Exchange:
    """Return the exchange of heights and forces of the step before, with a contact spring, N/m."""

    def step(line: Fmu, pantograph: Fmu) -> float:
        overlap = pantograph.get("strip_height") - line.get("P1.wire_height")
        force = max(0.0, stiffness * overlap)
        for fmu, name in ((line, "P1.contact_force"), (pantograph, "contact_force")):
            fmu.set(name, force)
            fmu.step()
        return force

    return step


def main(seconds: float) -> None:
    """Print a line for each way."""
    scenario = arcless.load("en50318-ac-simple-320-planar").with_(
        **{
            "pantographs.0.mean_force": None,
            "pantographs.0.static_force": 120.0,
            # A line that is given forces has friction from those of the step, a run from the last.
            "contact.friction_coefficient": 0.0,
        }
    )
    loop = arcless.realtime(scenario, simulated=True)
    steps = round(seconds / scenario.time_step_s)
    inside = [float(loop.step(0.0)[0]) for _ in range(steps)]
    ways: list[tuple[str, str, Exchange]] = [
        ("strip height and compliance into the line", "strip-height", by_strip),
        ("forces solved from both compliances", "contact-force", by_compliance),
    ]
    for stiffness in (1e3, 2e3, 5e3, 10e3, 20e3, 50e3):
        name = f"plain exchange, spring of {stiffness / 1e3:g} kN/m"
        ways.append((name, "contact-force", plain(stiffness)))
    print(f"{steps} steps of {1e3 * scenario.time_step_s:g} ms")
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        export_fmu(scenario, folder / "pantograph.fmu", pantograph="P1")
        for number, (what, given, exchange) in enumerate(ways):
            path = folder / f"{given}.fmu"
            if not path.exists():
                export_fmu(scenario, path, given=given)  # type: ignore[arg-type]
            line = Fmu(path, folder / f"line{number}")
            pantograph = Fmu(folder / "pantograph.fmu", folder / f"pantograph{number}")
            largest, step = compared(line, pantograph, exchange, inside)
            end = f"at most {largest:.2g} N off" if step is None else f"unstable in step {step}"
            print(f"{what}: {end}")


def compared(
    line: Fmu, pantograph: Fmu, exchange: Exchange, inside: list[float]
) -> tuple[float, int | None]:
    """Return the largest difference in N from the contact forces of one model, step by step.

    And the step after which the force has left all bounds, None where it has not.
    """
    largest = 0.0
    for step, expected in enumerate(inside, start=1):
        force = exchange(line, pantograph)
        largest = max(largest, abs(force - expected))
        if not force <= BOUND:
            return largest, step
    return largest, None


if __name__ == "__main__":
    main(float(sys.argv[1]) if len(sys.argv) > 1 else 3.0)
