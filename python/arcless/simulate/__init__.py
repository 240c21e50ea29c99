"""The arrow: scenario → mesh → equilibrium → record → dataset. Only this package knows all."""

from arcless.simulate.batch import Outcome, batch
from arcless.simulate.control import ControlInput
from arcless.simulate.realtime import Realtime, RealtimeState, realtime
from arcless.simulate.resonance import ResonanceSpeeds, resonance_speeds
from arcless.simulate.run import resume, run
from arcless.simulate.statics import StaticsResult, statics
from arcless.simulate.streaming import is_long

__all__ = [
    "ControlInput",
    "Outcome",
    "Realtime",
    "RealtimeState",
    "ResonanceSpeeds",
    "StaticsResult",
    "batch",
    "is_long",
    "realtime",
    "resonance_speeds",
    "resume",
    "run",
    "statics",
]
