"""A short line that runs in a fraction of a second, and its FMUs."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from arcless.fmi import export_fmu
from arcless.model import Scenario
from tests.unit.simulate.conftest import short

__all__ = ["short"]

Short = Callable[..., Scenario]
GIVEN = {"pantographs.0.mean_force": None, "pantographs.0.static_force": 120.0}


@pytest.fixture(scope="session")
def scenario(short: Short) -> Scenario:
    return short(**GIVEN)


@pytest.fixture(scope="session")
def fmu(scenario: Scenario, tmp_path_factory: pytest.TempPathFactory) -> Callable[..., Path]:
    """Return a maker of FMUs of the short line, each made once."""
    folder = tmp_path_factory.mktemp("fmus")
    known: dict[str, Path] = {}

    def make(version: int = 2, of: Scenario = scenario, **choice: Any) -> Path:
        key = repr((version, id(of), sorted(choice.items())))
        if key not in known:
            known[key] = folder / f"{len(known)}.fmu"
            export_fmu(of, known[key], version=version, **choice)  # type: ignore[arg-type]
        return known[key]

    return make
