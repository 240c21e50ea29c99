"""Types of the public names, each of which `__init__.py` imports at its first use."""

from arcless import (
    assess,
    comparison,
    control,
    errors,
    explanation,
    figures,
    lcp,
    measurements,
    model,
    report,
    results,
    simulate,
    study,
    validate,
)
from arcless.comparison import Comparison, compare
from arcless.errors import (
    ArclessError,
    ComparisonError,
    ContactError,
    ControlError,
    EquilibriumError,
    ExecutorError,
    ExplanationError,
    FigureError,
    FitError,
    FmuError,
    MachineError,
    MeasurementError,
    MeshError,
    ModelError,
    NotConvergedError,
    OutputError,
    ResultFormatError,
    StudyError,
)
from arcless.explanation import Explanation, Sensitivities
from arcless.model import Scenario, library, load, load_line, load_pantograph
from arcless.results import KeptRun, Result, explain, open, runs
from arcless.simulate.batches.batch import Outcome, batch
from arcless.simulate.central_differences import sensitivities
from arcless.simulate.resonance import ResonanceSpeeds, resonance_speeds
from arcless.simulate.run import resume, run
from arcless.simulate.session.realtime import Realtime, RealtimeState, realtime
from arcless.simulate.setup.controllers import ControlInput
from arcless.simulate.statics import statics

__all__ = [
    "ArclessError",
    "Comparison",
    "ComparisonError",
    "ContactError",
    "ControlError",
    "ControlInput",
    "EquilibriumError",
    "ExecutorError",
    "Explanation",
    "ExplanationError",
    "FigureError",
    "FitError",
    "FmuError",
    "KeptRun",
    "MachineError",
    "MeasurementError",
    "MeshError",
    "ModelError",
    "NotConvergedError",
    "Outcome",
    "OutputError",
    "Realtime",
    "RealtimeState",
    "ResonanceSpeeds",
    "Result",
    "ResultFormatError",
    "Scenario",
    "Sensitivities",
    "StudyError",
    "__version__",
    "assess",
    "batch",
    "compare",
    "comparison",
    "control",
    "errors",
    "explain",
    "explanation",
    "figures",
    "lcp",
    "library",
    "load",
    "load_line",
    "load_pantograph",
    "measurements",
    "model",
    "open",
    "realtime",
    "report",
    "resonance_speeds",
    "results",
    "resume",
    "run",
    "runs",
    "sensitivities",
    "simulate",
    "statics",
    "study",
    "validate",
]

__version__: str
