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
from typing import Any

# Public names by the module that has them; `__init__.pyi` has their types.
_NAMES = {
    "errors": (
        "ArclessError",
        "ComparisonError",
        "ContactError",
        "ControlError",
        "EquilibriumError",
        "ExecutorError",
        "ExplanationError",
        "FigureError",
        "FitError",
        "FmuError",
        "MachineError",
        "MeasurementError",
        "MeshError",
        "NotConvergedError",
        "ModelError",
        "OutputError",
        "ResultFormatError",
        "StudyError",
    ),
    "model": ("Scenario", "library", "load", "load_line", "load_pantograph"),
    "results": ("KeptRun", "Result", "explain", "open", "runs"),
    "explanation": ("Explanation", "Sensitivities"),
    "comparison": ("Comparison", "compare"),
    "simulate": (
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
        "sensitivities",
        "statics",
    ),
}
_PACKAGES = (
    *_NAMES, "assess", "control", "figures", "fmi", "lcp", "measurements", "report", "study",
    "validate",
)  # fmt: skip
_HOME = {name: module for module, names in _NAMES.items() for name in names}

__all__ = sorted([*_HOME, *_PACKAGES, "__version__"])  # noqa: PLE0605 - a list, but not literal


def __getattr__(name: str) -> Any:
    """Import a public name at its first use: `arcless --help` must not wait for xarray."""
    if name == "__version__":
        from importlib.metadata import version

        value: Any = version("arcless")
    elif name in _PACKAGES:
        value = importlib.import_module(f"arcless.{name}")
    elif name in _HOME:
        value = getattr(importlib.import_module(f"arcless.{_HOME[name]}"), name)
    else:
        raise AttributeError(f"module `arcless` has no attribute `{name}`")
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return __all__
