"""The arrow: scenario → mesh → equilibrium → record → dataset. Only this package knows all."""

from arcless.simulate.batch import Look, Outcome, Stopped, Watching, batch
from arcless.simulate.control import ControlInput
from arcless.simulate.realtime import Realtime, RealtimeState, realtime
from arcless.simulate.resonance import ResonanceSpeeds, resonance_speeds
from arcless.simulate.run import resume, run
from arcless.simulate.statics import StaticsResult, statics
from arcless.simulate.streaming import is_long

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
    "is_long",
    "realtime",
    "resonance_speeds",
    "resume",
    "run",
    "statics",
]
