"""Couple the FMU of a line with the FMU of a pantograph, and compare with one model of both.

    python examples/coupled_fmus.py [SECONDS]

Needs FMPy: pip install 'arcless[fmi]'. Prints how far the contact force is from that of the loop in
which line and pantograph are one model: for the two ways that know the compliance, and for plain
exchange of heights and forces with a spring between strip and wire.
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
# Most rounds in which a force is looked for: two as a rule, rounding keeps it from staying.
ROUNDS = 5
# Difference that is no longer one of accuracy, N: nearly the static force.
LOST = 100.0
# Stiffness of the contact, N/m, and steps from one plain exchange to the next.
STIFFNESSES = (50e3, 100e3, 200e3, 400e3, 800e3)
EVERY = (1, 2, 5, 10)


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

    def step(self, count: int = 1) -> None:
        """Take steps, as one communication step."""
        self.fmu.doStep(self.steps * self.h, count * self.h)
        self.steps += count


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
    """Take a step of a line that is given the force, solved here from both compliances.

    They are those about the force that is set: asked again until that stays, which it does at once
    unless a dropper slackens or tightens because of it.
    """
    found, supposed = force_of(line, pantograph), None
    for _ in range(ROUNDS):
        if found == supposed:
            break
        supposed = found
        line.set("P1.contact_force", found)
        pantograph.set("contact_force", found)
        found = force_of(line, pantograph)
    line.set("P1.contact_force", found)
    pantograph.set("contact_force", found)
    line.step()
    pantograph.step()
    return found


def force_of(line: Fmu, pantograph: Fmu) -> float:
    """Return the contact force of the step that comes, N, from heights and compliances."""
    old = line.get("old_weight")
    strip = old * pantograph.get("strip_height") + (1.0 - old) * pantograph.get("free_height")
    overlap = strip - line.get("P1.free_height")
    soft = (1.0 - old) * pantograph.get("compliance") + line.get("compliance")
    return max(0.0, overlap / (soft + line.get("contact_flexibility")))


def plain(stiffness: float, every: int = 1) -> Exchange:
    """Return the exchange of what was a communication step ago, with a contact spring, N/m."""

    def step(line: Fmu, pantograph: Fmu) -> float:
        overlap = pantograph.get("strip_height") - line.get("P1.wire_height")
        force = max(0.0, stiffness * overlap)
        for fmu, name in ((line, "P1.contact_force"), (pantograph, "contact_force")):
            fmu.set(name, force)
            fmu.step(every)
        return force

    return step


def compared(
    line: Fmu, pantograph: Fmu, exchange: Exchange, inside: list[float]
) -> tuple[float, int | None]:
    """Return the largest difference in N from the contact forces of one model.

    And the number of the exchange in which it first was more than 100 N, None where it never was.
    """
    largest, lost = 0.0, None
    for number, expected in enumerate(inside, start=1):
        difference = abs(exchange(line, pantograph) - expected)
        largest = max(largest, difference)
        if lost is None and not difference <= LOST:
            lost = number
    return largest, lost


class Case:
    """The scenario with a stiffness of the contact in N/m, its FMUs and its forces in one model."""

    def __init__(self, folder: Path, stiffness: float, seconds: float) -> None:
        changes = {
            "pantographs.0.mean_force": None,
            "pantographs.0.static_force": 120.0,
            "contact.stiffness": stiffness,
            # A line that is given forces has friction from those of the step, a run from the last.
            "contact.friction_coefficient": 0.0,
        }
        scenario = arcless.load("en50318-ac-simple-320-planar").with_(**changes)
        self.folder, self.made = folder, 0
        for given in ("strip-height", "contact-force"):
            export_fmu(scenario, folder / f"{given}.fmu", given=given)  # type: ignore[arg-type]
        export_fmu(scenario, folder / "pantograph.fmu", pantograph="P1")
        loop = arcless.realtime(scenario, simulated=True)
        self.h = scenario.time_step_s
        self.inside = [float(loop.step(0.0)[0]) for _ in range(round(seconds / self.h))]

    def compare(self, given: str, exchange: Exchange, every: int = 1) -> tuple[float, int | None]:
        """Return how far a way of coupling is off, see `compared`."""
        self.made += 1
        pair = [
            Fmu(self.folder / f"{name}.fmu", self.folder / f"{name}{self.made}")
            for name in (given, "pantograph")
        ]
        return compared(pair[0], pair[1], exchange, self.inside[every - 1 :: every])


def main(seconds: float) -> None:
    """Print a line for each way."""
    for stiffness in STIFFNESSES:
        with tempfile.TemporaryDirectory() as name:
            case = Case(Path(name), stiffness, seconds)
            print(f"contact of {stiffness / 1e3:g} kN/m, {len(case.inside)} steps")
            for what, given, exchange in (
                ("strip height and compliance", "strip-height", by_strip),
                ("force from both compliances", "contact-force", by_compliance),
            ):
                largest, _ = case.compare(given, exchange)
                print(f"  {what}: at most {largest:.1e} N off")
            for every in EVERY:
                largest, lost = case.compare("contact-force", plain(stiffness, every), every)
                end = "" if lost is None else f", by more than {LOST:g} N from exchange {lost} on"
                what = f"plain exchange every {1e3 * every * case.h:g} ms"
                print(f"  {what}: at most {largest:.0f} N off{end}")


if __name__ == "__main__":
    main(float(sys.argv[1]) if len(sys.argv) > 1 else 2.0)
