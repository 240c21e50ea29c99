"""Fingerprints of data: of the parts that members of a batch share, and of a whole member."""

import hashlib
import json
from pathlib import Path
from typing import Any

from arcless import _core
from arcless.model import Scenario
from arcless.simulate.setup import trajectory

# Descriptions in a line, which nothing is computed from.
WORDS = ("name", "description", "sources", "provenance")


class SharedKeys:
    """Fingerprints of shared parts; those of members with the very same parts are made once."""

    def __init__(self) -> None:
        self._parts: tuple[object, ...] = ()
        self._key = ""

    def of(self, scenario: Scenario) -> str:
        """Return `shared_key` of a scenario."""
        parts = (scenario.line, scenario.as_built, scenario.solver, scenario.contact)
        steps = scenario.stepping, scenario.time_step_s
        known = len(self._parts) == len(parts) + 1 and self._parts[-1] == steps
        if not known or any(a is not b for a, b in zip(parts, self._parts, strict=False)):
            self._parts, self._key = (*parts, steps), shared_key(scenario)
        return self._key


def shared_key(scenario: Scenario) -> str:
    """Return the fingerprint of all that the line at rest and its factor are made from.

    Two scenarios with one key have the same mesh, the same equilibrium, and the same matrix of a
    time step: line and how it was built (without gusts, which come with the run), solver with
    the time step in s and the elements in m, and the contact. Names and sources do not count.
    """
    data = scenario.to_dict()
    line = {name: value for name, value in data["line"].items() if name not in WORDS}
    built = {name: value for name, value in data["as_built"].items() if name != "gusts"}
    solver = scenario.stepping.model_dump(mode="json", exclude={"time_step"})
    stiffness = repr(trajectory.contact_stiffness(scenario))
    return _fingerprint([line, built, solver, scenario.time_step_s, stiffness])


def member_key(scenario: Scenario) -> str:
    """Return the fingerprint of a member: whole scenario, files of controllers, version.

    What has the same key gives the same result.
    """
    functions = [
        _content(placement.controller.place[0])
        for placement in scenario.pantographs
        if placement.controller is not None and placement.controller.function is not None
    ]
    return _fingerprint([scenario.to_dict(), functions, _core.__version__])


def _content(file: str) -> str | None:
    try:
        return hashlib.sha256(Path(file).read_bytes()).hexdigest()
    except OSError:  # the run itself says that it is missing
        return None


def _fingerprint(data: Any) -> str:
    text = json.dumps(data, sort_keys=True, ensure_ascii=False)
    return hashlib.sha256(text.encode()).hexdigest()
