"""Simulation of railway pantographs and overhead contact lines moving together.

Examples
--------
>>> import arcless
>>> scenario = arcless.load("en50318-ac-simple-320").with_(speed="300 km/h")
>>> scenario.name
'en50318-ac-simple-320'

`arcless.run(scenario)` then simulates it, and ``.assessment`` holds the statistics.
"""

import importlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from arcless import assess, errors, lcp, model, report, results, simulate, study, validate
    from arcless.errors import (
        ArclessError,
        ContactError,
        ControlError,
        EquilibriumError,
        ExecutorError,
        MeshError,
        ModelError,
        OutputError,
        ResultFormatError,
        StudyError,
    )
    from arcless.model import Scenario, library, load, load_line, load_pantograph
    from arcless.results import Result, open
    from arcless.simulate.batches.batch import Outcome, batch
    from arcless.simulate.resonance import ResonanceSpeeds, resonance_speeds
    from arcless.simulate.run import resume, run
    from arcless.simulate.session.realtime import Realtime, RealtimeState, realtime
    from arcless.simulate.setup.controllers import ControlInput
    from arcless.simulate.statics import statics

    __version__: str

__all__ = [
    "ArclessError",
    "ContactError",
    "ControlError",
    "ControlInput",
    "EquilibriumError",
    "ExecutorError",
    "MeshError",
    "ModelError",
    "Outcome",
    "OutputError",
    "Realtime",
    "RealtimeState",
    "ResonanceSpeeds",
    "Result",
    "ResultFormatError",
    "Scenario",
    "StudyError",
    "__version__",
    "assess",
    "batch",
    "errors",
    "lcp",
    "library",
    "load",
    "load_line",
    "load_pantograph",
    "model",
    "open",
    "realtime",
    "report",
    "resonance_speeds",
    "results",
    "resume",
    "run",
    "simulate",
    "statics",
    "study",
    "validate",
]

_MODULES = {
    "assess",
    "errors",
    "lcp",
    "model",
    "report",
    "results",
    "simulate",
    "study",
    "validate",
}
_MODEL = {"Scenario", "library", "load", "load_line", "load_pantograph"}
_RESULTS = {"Result", "open"}
_SIMULATE = {
    "ControlInput",
    "Outcome",
    "Realtime",
    "RealtimeState",
    "ResonanceSpeeds",
    "batch",
    "realtime",
    "resonance_speeds",
    "resume",
    "run",
    "statics",
}


def __getattr__(name: str) -> Any:
    """Import a public name at its first use: `arcless --help` must not wait for xarray."""
    if name == "__version__":
        from importlib.metadata import version

        value: Any = version("arcless")
    elif name in _MODULES:
        value = importlib.import_module(f"arcless.{name}")
    elif name in _MODEL:
        value = getattr(importlib.import_module("arcless.model"), name)
    elif name in _RESULTS:
        value = getattr(importlib.import_module("arcless.results"), name)
    elif name in _SIMULATE:
        value = getattr(importlib.import_module("arcless.simulate"), name)
    elif name in __all__:
        value = getattr(importlib.import_module("arcless.errors"), name)
    else:
        raise AttributeError(f"module `arcless` has no attribute `{name}`")
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted(__all__)
