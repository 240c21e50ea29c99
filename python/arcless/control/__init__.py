"""Environment for research on control: Gymnasium's interface to a pantograph on a line.

``gymnasium.make("arcless/Pantograph-v0", scenario="…")`` after ``import arcless.control``, with the
extra ``control``. Laws that were made there are controllers of `arcless.run`, without the extra.
"""

import importlib
from typing import TYPE_CHECKING, Any

from arcless.control.laws import (
    TIME_CONSTANTS_S,
    FilteredLaw,
    Law,
    LawController,
    load_law,
    save_law,
)
from arcless.control.packages import is_installed, need
from arcless.control.reward import Weights
from arcless.control.settings import ACTUATOR
from arcless.control.signals import DEFAULT, SIGNALS, Signal
from arcless.control.task import Task, task

if TYPE_CHECKING:
    from arcless.control.environment import PantographEnv
    from arcless.control.vector_environment import PantographVectorEnv

__all__ = [
    "ACTUATOR",
    "DEFAULT",
    "ENVIRONMENT",
    "SIGNALS",
    "TIME_CONSTANTS_S",
    "FilteredLaw",
    "Law",
    "LawController",
    "PantographEnv",
    "PantographVectorEnv",
    "Signal",
    "Task",
    "Weights",
    "load_law",
    "register",
    "save_law",
    "task",
]

ENVIRONMENT = "arcless/Pantograph-v0"
# Names that need Gymnasium: name → module.
_WITH_GYMNASIUM = {"PantographEnv": "environment", "PantographVectorEnv": "vector_environment"}


def __getattr__(name: str) -> Any:
    """Import what needs Gymnasium at its first use."""
    if name not in _WITH_GYMNASIUM:
        raise AttributeError(f"module `{__name__}` has no attribute `{name}`")
    need("gymnasium")
    return getattr(importlib.import_module(f"{__name__}.{_WITH_GYMNASIUM[name]}"), name)


def register() -> None:
    """Register the environment with Gymnasium; importing this package has done so if it is there.

    Raises
    ------
    ModelError
        Gymnasium is not installed.
    """
    need("gymnasium")
    import gymnasium

    if ENVIRONMENT not in gymnasium.registry:
        gymnasium.register(
            ENVIRONMENT,
            entry_point="arcless.control.environment:PantographEnv",
            vector_entry_point="arcless.control.vector_environment:PantographVectorEnv",
        )


if is_installed("gymnasium"):
    register()
