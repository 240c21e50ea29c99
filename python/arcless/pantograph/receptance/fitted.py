"""Chain of masses that was fitted to a measured receptance: how well it fits, and how surely."""

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from arcless.pantograph.receptance.chain import Chain
from arcless.pantograph.receptance.confidence import Confidence
from arcless.pantograph.receptance.measured import MeasuredReceptance

Floats = NDArray[np.float64]
Complex = NDArray[np.complexfloating[Any, Any]]

# Poles slower than this share of the fastest are those of a free frame, two at 0, which rounding
# moves by the root of its share, 1e-8.
FREE = 1e-6
# Misfits below are rounding; they say nothing about an order.
ROUNDING = 1e-9


@dataclass(frozen=True)
class Mode:
    """A pole of the pantograph without a line: its frequency, damping ratio, and their ±.

    Attributes
    ----------
    frequency_Hz
        |λ|/2π.
    damping_ratio
        −Re λ/|λ|; 1 for a pole without oscillation, which has no partner.
    frequency_sure_Hz, damping_sure
        What covers 95 % of measurements like this one, to either side; infinite where the data do
        not tell.
    """

    frequency_Hz: float  # noqa: N815 - the unit is part of the name
    damping_ratio: float
    frequency_sure_Hz: float  # noqa: N815 - the unit is part of the name
    damping_sure: float


@dataclass(frozen=True)
class Parameter:
    """A mass, spring or damper of a chain: the number of its mass from the base, value, and ±."""

    kind: str
    place: int
    value: float
    sure: float
    unit: str


@dataclass(frozen=True, eq=False)
class Fit:
    """A chain of masses that follows a measured receptance.

    Attributes
    ----------
    data
        The measurement.
    chain
        What was found.
    residual
        ln of model over measurement at each frequency: relative misfit of the amplitude, and misfit
        of the phase in rad.
    cost
        Sum of the squares of both, over the errors that are given with the data.
    confidence
        Confidence of the parameters.
    """

    data: MeasuredReceptance
    chain: Chain
    residual: Complex
    cost: float
    confidence: Confidence

    @property
    def misfit(self) -> float:
        """Root mean square of the relative misfit, of amplitudes and of phases in rad alike."""
        return float(np.sqrt(np.mean(np.abs(self.residual) ** 2) / 2.0))

    @property
    def largest(self) -> tuple[float, float]:
        """Largest misfit, of amplitude and phase together, and its frequency in Hz."""
        size = np.abs(self.residual)
        place = int(np.argmax(size))
        return float(size[place]), float(self.data.frequency[place])

    @property
    def alike(self) -> float:
        """Correlation of the misfit with that of the next frequency: 0 of noise, 1 of a trend."""
        misfit = self.residual / errors(self.data)
        power = float(np.sum(np.abs(misfit) ** 2))
        if power == 0.0:
            return 0.0
        return float(np.sum((misfit[1:] * misfit[:-1].conj()).real)) / power

    @property
    def over_noise(self) -> float | None:
        """Misfit over the errors given with the data, 1 where it is all noise; None without."""
        if self.data.error is None:
            return None
        return float(np.sqrt(self.cost / (2 * self.data.frequency.size - self.chain.parameters)))

    @property
    def information(self) -> float:
        """Schwarz's criterion N ln(S/N) + p ln N: the least has the order that the data support.

        Source: G. Schwarz, Annals of Statistics 6 (1978) 461.
        """
        count = 2 * self.data.frequency.size
        mean = max(self.cost / count, ROUNDING**2)
        return float(count * np.log(mean) + self.chain.parameters * np.log(count))

    @cached_property
    def modes(self) -> tuple[Mode, ...]:
        """Natural frequencies and damping ratios of the free pantograph, slowest first.

        A frame without spring is a mode of 0 Hz.
        """
        poles, changes = self.chain.poles()
        size = np.abs(poles)
        free = size < FREE * size.max()
        poles, changes, size = poles[~free], changes[~free], size[~free]
        of_size = (poles.conj()[:, None] * changes).real / size[:, None]
        of_ratio = -changes.real / size[:, None] + (poles.real / size**2)[:, None] * of_size
        frequency_sure = self.confidence.of(of_size) / (2.0 * np.pi)
        ratio_sure = np.where(poles.imag > 0.0, self.confidence.of(of_ratio), 0.0)
        moving = [
            Mode(float(w / (2.0 * np.pi)), float(-pole.real / w), float(a), float(b))
            for w, pole, a, b in zip(size, poles, frequency_sure, ratio_sure, strict=True)
        ]
        return (*([Mode(0.0, 1.0, 0.0, 0.0)] if np.any(free) else []), *moving)

    @cached_property
    def parameters(self) -> tuple[Parameter, ...]:
        """Masses and springs with their ±; dampers too where there is one in each joint."""
        order, chain = self.chain.order, self.chain
        sure = self.confidence.of(np.eye(chain.parameters))
        rows = [("mass", chain.mass, "kg"), ("stiffness", chain.stiffness, "N/m")]
        if chain.kind == "joints":
            rows.append(("damping", chain.damping, "N s/m"))
        return tuple(
            Parameter(kind, i + 1, float(values[i]), float(sure[block * order + i]), unit)
            for i in range(order)
            for block, (kind, values, unit) in enumerate(rows)
        )

    @cached_property
    def band(self) -> Floats:
        """± of the receptance of the model at each frequency, of its amplitude, relative."""
        values, changes = self.chain.receptance_changes(self.data.frequency)
        return self.confidence.of((changes / values[:, None]).real)


def errors(data: MeasuredReceptance) -> Floats:
    """Return the relative standard deviation of each value, or 1 each where none is given."""
    return np.ones(data.frequency.size) if data.error is None else data.error
