"""The energy ledger closes."""

from collections.abc import Callable

import numpy as np
import pytest

from arcless.results import Result

RunOnce = Callable[..., Result]

# What the project promises; a run of 10 000 steps leaves about 1e-12 of rounding.
RESIDUAL = 1e-9
TRAPEZOIDAL = {"solver.scheme": "trapezoidal", "pantographs.0.static_force": 172.0}


def test_trapezoidal_ledger_closes(run_once: RunOnce) -> None:
    result = run_once("en50318-ac-simple-320", TRAPEZOIDAL)
    assert result.metadata["slack_droppers_max"] > 0  # droppers went slack and came back
    assert result.metadata["energy_residual_relative"] <= RESIDUAL
    assert np.all(result.dataset["energy_dissipated_scheme"].values == pytest.approx(0.0, abs=1e-9))


@pytest.mark.parametrize(
    "changes",
    [
        pytest.param({"solver.scheme": "generalised-alpha"}, id="dissipative scheme"),
        pytest.param({"contact.law": "rigid"}, id="rigid contact"),
        pytest.param({"contact.friction_coefficient": 0.2}, id="friction"),
    ],
)
def test_every_ledger_closes(run_once: RunOnce, changes: dict[str, object]) -> None:
    short = {"travel.end": "600 m", "analysis.spans": [4, 9], "output.energy": "always"}
    force = {"pantographs.0.static_force": 172.0}
    result = run_once("en50318-ac-simple-320", {**force, **short, **changes})
    # Impacts, openings and the scheme's own damping are entries of the ledger, so it closes too.
    assert result.metadata["energy_residual_relative"] <= RESIDUAL


def test_terms_add_up_to_the_residual(run_once: RunOnce) -> None:
    data = run_once("en50318-ac-simple-320", TRAPEZOIDAL).dataset
    term = {name.removeprefix("energy_"): data[name].values for name in data if "energy_" in name}
    stored = sum(term[name] for name in ("kinetic", "elastic", "contact", "pantograph"))
    lost = sum(values for name, values in term.items() if "dissipated" in name) + term["switching"]
    work = sum(values for name, values in term.items() if "work" in name)
    gap = stored + lost - work  # stored energies are counted from the start of the run
    turnover = np.max(np.abs(work)) + np.max(np.abs(stored))
    assert np.max(np.abs(np.abs(gap) - np.abs(term["residual"]))) <= RESIDUAL * turnover
