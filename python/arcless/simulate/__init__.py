"""From a scenario to its result: runs, statics, resonance, batches, sessions in real time."""

import importlib
from typing import TYPE_CHECKING, Any

from arcless.simulate.run import resume, run
from arcless.simulate.runs.streaming import is_long
from arcless.simulate.setup.controllers import ControlInput
from arcless.simulate.statics import StaticsResult, check_at_rest, statics

if TYPE_CHECKING:
    from arcless.simulate.batches.batch import Look, Outcome, Stopped, Watching, batch
    from arcless.simulate.central_differences import sensitivities
    from arcless.simulate.resonance import ResonanceSpeeds, resonance_speeds
    from arcless.simulate.session.realtime import Realtime, RealtimeState, realtime

__all__ = [
    "ControlInput",
    "Look",
    "Outcome",
    "Realtime",
    "RealtimeState",
    "ResonanceSpeeds",
    "StaticsResult",
    "Stopped",
    "Watching",
    "batch",
    "check_at_rest",
    "is_long",
    "realtime",
    "resonance_speeds",
    "resume",
    "run",
    "sensitivities",
    "statics",
]

# Names that one run does without: name → module.
_LATER = {
    **dict.fromkeys(("Look", "Outcome", "Stopped", "Watching", "batch"), "batches.batch"),
    **dict.fromkeys(("Realtime", "RealtimeState", "realtime"), "session.realtime"),
    "sensitivities": "central_differences",
    **dict.fromkeys(("ResonanceSpeeds", "resonance_speeds"), "resonance"),
}


def __getattr__(name: str) -> Any:
    """Import a name at its first use: one run must not wait for what runs many."""
    if name not in _LATER:
        raise AttributeError(f"module `{__name__}` has no attribute `{name}`")
    value = getattr(importlib.import_module(f"{__name__}.{_LATER[name]}"), name)
    globals()[name] = value
    return value
