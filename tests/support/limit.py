"""The limit: agreement of two families of elements that share no discretisation error.

Refined cubic elements with residual flexibility, stepped with a matrix, miss waves that are short
beside an element and nothing under point forces. Refined chains of point masses, stepped
explicitly, miss other waves, and their steps have another error. Where both agree within half a
percent (minima: of the mean force) their mean is taken for the limit; where they do not, both are
refined further. A conductor rail has no waves that explicit steps could follow: there the chains
are stepped with a matrix, and finer. A chain that bends is off by the square of its elements (σ of
a second pantograph by 2.6 % with 0.1 m and 0.6 % with 0.05 m, the shortest that there are), so its
last refinement is the continuation of two to none: f + (f − c)/3, Richardson's.

Static forces are given in all runs, found once by the scenario as it is, so that no search adds to
a difference.
"""

import hashlib
import json
import os
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

import arcless
from arcless import _core
from tests.support.assessed import Assessed, differences

# In percent; what both families may differ by. A third of it is what the goals can still resolve.
AGREEMENT = 0.5
QUIET: dict[str, Any] = {"output.droppers": False, "solver.kinematics": "linearised"}
MATRIX = QUIET | {"solver.scheme": "generalised-alpha"}
# Contact and messenger wire elements in m, step in s, for each family and each refinement.
CUBIC = ((0.36, 0.72, 5e-4), (0.25, 0.36, 2.5e-4))
CHAINS = ((0.15, 0.15, 2.5e-4), (0.1, 0.1, 1.5e-4))
CHAINS_OF_RAILS = ((0.06, 0.06, 5e-4), (0.05, 0.05, 2.5e-4))
# Of the finest of these another run has elements so many times as long.
COARSER = 2.0
# Records of uplift are this far apart, whatever the step; s.
RECORDS = 4e-3
Sizes = tuple[float, float, float]
# A folder where limits are kept from one session to the next; none without.
KEPT = "ARCLESS_LIMITS"


@dataclass(frozen=True)
class Limit:
    """The limit of a scenario.

    Attributes
    ----------
    right : mean of both families
    apart : what they differ by most, %
    refined : how often both were refined further
    """

    right: Assessed
    apart: float
    refined: int

    @property
    def agreed(self) -> bool:
        """True when both families agree, so that this is a limit."""
        return self.apart <= AGREEMENT


def limit(scenario: arcless.Scenario) -> Limit:
    """Return the limit of a scenario whose static forces are given."""
    kept = _kept(scenario)
    if kept is not None and kept.is_file():
        data = json.loads(kept.read_text(encoding="utf-8"))
        return Limit(Assessed.from_plain(data["right"]), data["apart"], data["refined"])
    found = _limit(scenario)
    if kept is not None:
        data = {"right": found.right.to_plain(), "apart": found.apart, "refined": found.refined}
        kept.parent.mkdir(parents=True, exist_ok=True)
        kept.write_text(json.dumps(data), encoding="utf-8")
    return found


def _limit(scenario: arcless.Scenario) -> Limit:
    *coarser, finest = zip(CUBIC, CHAINS_OF_RAILS if is_rail(scenario) else CHAINS, strict=True)
    for refined, sizes in enumerate(coarser):
        found = _by_both(scenario, *sizes, refined)
        # A lost contact is a draw, however fine.
        if found.agreed or found.right.loses_contact:
            return found
    return _by_both(scenario, *finest, len(coarser))


def _by_both(scenario: arcless.Scenario, cubic: Sizes, chains: Sizes, refined: int) -> Limit:
    one, other = by_cubic(scenario, *cubic), by_chains(scenario, *chains)
    if is_rail(scenario) and refined:
        contact, above, step = chains
        coarse = by_chains(scenario, COARSER * contact, COARSER * above, step)
        other = Assessed.between(other, coarse, -1.0 / (COARSER**2 - 1.0))
    apart = float(np.abs(differences(one, other)).max())
    return Limit(Assessed.between(one, other), apart, refined)


def by_cubic(scenario: arcless.Scenario, contact: float, above: float, step: float) -> Assessed:
    """Run with cubic elements that miss nothing under point forces."""
    changes = {"solver.wire_model": "hermite", "solver.residual_flexibility": True}
    return Assessed.of(arcless.run(divided(scenario, MATRIX | changes, contact, above, step)))


def by_chains(scenario: arcless.Scenario, contact: float, above: float, step: float) -> Assessed:
    """Run with chains of point masses."""
    scheme = MATRIX if is_rail(scenario) else QUIET | {"solver.scheme": "central-difference"}
    changes = {"solver.wire_model": "lumped", "solver.residual_flexibility": "auto"}
    return Assessed.of(arcless.run(divided(scenario, scheme | changes, contact, above, step)))


def divided(
    scenario: arcless.Scenario, changes: dict[str, Any], contact: float, above: float, step: float
) -> arcless.Scenario:
    """Return a scenario with other elements (m) and another step (s)."""
    lengths = {
        "solver.contact_wire_element": contact,
        "solver.messenger_wire_element": above,
        "solver.time_step": step,
        "output.line_every": max(1, round(RECORDS / step)),
    }
    return scenario.with_(**changes, **lengths)


def is_rail(scenario: arcless.Scenario) -> bool:
    """Return whether the line is a conductor rail."""
    return scenario.line.contact_wire.kind == "conductor_rail"


def with_forces(scenario: arcless.Scenario) -> arcless.Scenario:
    """Return a scenario whose static forces are given: those that its own search finds."""
    if all(placement.mean_force is None for placement in scenario.pantographs):
        return scenario
    found = arcless.run(scenario).metadata["static_force_found"]
    changes: dict[str, Any] = {}
    for index, placement in enumerate(scenario.pantographs):
        if placement.mean_force is not None:
            changes[f"pantographs.{index}.mean_force"] = None
            changes[f"pantographs.{index}.static_force"] = float(f"{found[placement.name]:.2f}")
    return scenario.with_(**changes)


def _kept(scenario: arcless.Scenario) -> Path | None:
    """Return the file of a limit: what asks for it, and the program that answers, in its name."""
    folder = os.environ.get(KEPT)
    if not folder:
        return None
    solver = {"time_step", "scheme", "contact_wire_element", "messenger_wire_element"}
    asked = scenario.model_dump(mode="json", exclude={"solver": solver, "name": True})
    text = json.dumps([asked, CUBIC, CHAINS, CHAINS_OF_RAILS], sort_keys=True, default=str)
    name = hashlib.sha256((text + _program()).encode()).hexdigest()[:20]
    return Path(folder) / f"{name}.json"


@cache
def _program() -> str:
    """Return a digest of the package and of its core."""
    found = hashlib.sha256(Path(_core.__file__).read_bytes())
    root = Path(arcless.__file__).parent
    for part in ("mesh", "equilibrium", "simulate", "assess", "model"):
        for file in sorted((root / part).rglob("*.py")):
            found.update(file.read_bytes())
    return found.hexdigest()
