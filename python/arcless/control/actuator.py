"""Actuators of several episodes side by side: limits, rate and delay of a controlled force.

The same arithmetic, in the same order, as a `controller` of a scenario has in a run
(`arcless.simulate.setup.controllers`, and the core's `actuator`): limits of a sample, then a delay
of whole time steps, then the force is held until the next sample's.
"""

import numpy as np
from numpy.typing import NDArray

from arcless.model.pantograph.controller import Controller

Floats = NDArray[np.float64]
Numbers = NDArray[np.intp]


class Actuators:
    """Actuators with the settings of a controller.

    Parameters
    ----------
    controller
        Sample time, delay and limits.
    time_step_s
        Length of a time step in s.
    count
        Number of episodes.

    Attributes
    ----------
    steps
        Time steps of a sample.
    asked_N
        Force asked for last in each episode, within the limits, N.
    """

    def __init__(self, controller: Controller, time_step_s: float, count: int) -> None:
        self._controller = controller
        self.steps = round(controller.sample_time / time_step_s)
        delay = round(controller.delay / time_step_s)
        self.asked_N = np.zeros(count)
        # Forces of the steps to come, the next one first.
        self._planned = np.zeros((count, delay + self.steps))

    def begin(self, rows: Numbers) -> None:
        """Begin some episodes, given by their numbers, without a force."""
        self.asked_N[rows] = 0.0
        self._planned[rows] = 0.0

    def ask(self, rows: Numbers, wanted_N: Floats) -> Floats:
        """Ask for forces, and return those that act in the time steps of the sample, N."""
        asked = self._limited(self.asked_N[rows], wanted_N)
        self.asked_N[rows] = asked
        planned, steps = self._planned[rows], self.steps
        planned[:, -steps:] = asked[:, None]
        acting = planned[:, :steps].copy()
        planned[:, :-steps] = planned[:, steps:]
        self._planned[rows] = planned
        return acting

    def _limited(self, before: Floats, wanted: Floats) -> Floats:
        controller = self._controller
        if controller.rate_limit is not None:
            most = controller.rate_limit * controller.sample_time
            wanted = np.minimum(np.maximum(wanted, before - most), before + most)
        if controller.minimum_force is not None:
            wanted = np.maximum(wanted, controller.minimum_force)
        if controller.maximum_force is not None:
            wanted = np.minimum(wanted, controller.maximum_force)
        return wanted
