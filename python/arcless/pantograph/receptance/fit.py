"""Measured receptance → chain of masses of a stated order, with how well and how surely it fits."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from arcless.errors import FitError, MeasurementError
from arcless.pantograph.receptance import least_squares, start
from arcless.pantograph.receptance.chain import Chain, Damping, of_damping
from arcless.pantograph.receptance.confidence import Confidence, confidence
from arcless.pantograph.receptance.least_squares import Found, Target
from arcless.pantograph.receptance.measured import MeasuredReceptance, listed
from arcless.units import to_si

Floats = NDArray[np.float64]
Complex = NDArray[np.complex128]

# A pantograph is modelled by two or three masses; more than this many modes are not seen at a head.
MOST_MASSES = 8
# Numbers measured, two at a frequency, for each parameter: fewer leave the error of the fit unknown.
NUMBERS_EACH = 3
# Root mean square of the misfit above which nothing is handed out unless asked for: contact forces of
# such a model would be off by as much near its modes.
LARGEST_MISFIT = 0.10
# Frequencies at which masses are split, for starts, in equal ratios over the band and half above it.
SPLITS, ABOVE = 6, 1.5
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
        misfit = self.residual / _errors(self.data)
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


def fit(
    data: MeasuredReceptance,
    order: int,
    *,
    damping: Damping = "joints",
    largest_misfit: float | str = LARGEST_MISFIT,
) -> Fit:
    """Fit a chain of masses to a measured receptance.

    Parameters
    ----------
    data
        The measurement; `read` has it from a table.
    order
        Number of masses, which is that of modes.
    damping
        ``"joints"``: a damper in each joint; ``"full"``: any damping matrix.
    largest_misfit
        Largest root mean square of the misfit that is accepted, such as ``"10 %"``.

    Raises
    ------
    MeasurementError
        The data are too few for this order.
    FitError
        No chain of this order follows them, or the search did not end.
    """
    limit = to_si(largest_misfit, "1")
    check_order(data, order, damping)
    found = None
    for found in _rising(data, order, damping):
        pass
    assert found is not None  # an order is at least 1
    made = _fit(data, found)
    if made.misfit > limit:
        raise _missed(made, limit)
    if not found.ended:
        raise FitError(
            "the search for the masses did not end", where=data.name,
            got=f"{least_squares.MOST_EVALUATIONS} evaluations with a misfit of"
            f" {100 * made.misfit:.3g} %", expected="a minimum",
            hint="ask for one mass less: the data may not tell this many apart",
        )  # fmt: skip
    return made


def orders(
    data: MeasuredReceptance, highest: int, *, progress: Callable[[float, str], None] | None = None
) -> list[Fit]:
    """Fit all orders up to one, with both kinds of damping; orders that are too high are left out.

    What misses is in it, too: this is the list by which an order is chosen.
    """
    found = []
    most = max(order for order in range(1, MOST_MASSES + 1) if order == 1 or _fits(data, order))
    last = min(highest, most)
    for order, joints in enumerate(_rising(data, last, "joints"), start=1):
        found.append(_fit(data, joints))
        if order > 1 and _fits(data, order, "full"):
            found.append(_fit(data, _full(data, joints.chain)))
        if progress is not None:
            progress(order / last, "orders")
    return found


def check_order(data: MeasuredReceptance, order: int, damping: Damping) -> None:
    """Refuse an order that there is none of, or that the data are too few for."""
    if not 1 <= order <= MOST_MASSES:
        raise MeasurementError("order", got=str(order), expected=f"1 to {MOST_MASSES} masses")
    if damping not in ("joints", "full"):
        raise MeasurementError("damping", got=f'"{damping}"', expected="joints or full")
    if not _fits(data, order, damping):
        parameters, count = 2 * order + of_damping(order, damping), data.frequency.size
        least = -(-NUMBERS_EACH * parameters // 2)
        raise MeasurementError(
            "order too high for the data", where=data.name,
            got=f"{order} masses, which are {parameters} parameters, from {count} frequencies",
            expected=f"at least {least} frequencies, {NUMBERS_EACH} numbers for each parameter",
            hint="ask for fewer masses, or measure at more frequencies",
        )  # fmt: skip


def _fits(data: MeasuredReceptance, order: int, damping: Damping = "joints") -> bool:
    parameters = 2 * order + of_damping(order, damping)
    return NUMBERS_EACH * parameters <= 2 * data.frequency.size


def _errors(data: MeasuredReceptance) -> Floats:
    return np.ones(data.frequency.size) if data.error is None else data.error


def _target(data: MeasuredReceptance) -> Target:
    return Target(data.frequency, least_squares.logarithm(data.values), _errors(data))


def _rising(data: MeasuredReceptance, order: int, damping: Damping) -> Iterator[Found]:
    """Yield the best chain of each order up to one; the last with the damping that is asked for."""
    target, before = _target(data), None
    frequencies = np.geomspace(data.frequency[0], ABOVE * data.frequency[-1], SPLITS)
    with np.errstate(all="ignore"):  # trial steps that have no numbers are taken back
        for size in range(1, order + 1):
            starts = start.chains(data.frequency, data.values, size)
            if before is not None:
                starts += start.split(before.chain, frequencies)
            before = least_squares.best(target, starts)
            last = size == order and size > 1 and damping == "full"
            yield _full(data, before.chain) if last else before


def _full(data: MeasuredReceptance, chain: Chain) -> Found:
    with np.errstate(all="ignore"):
        return least_squares.best(_target(data), [least_squares.begun_full(chain)])


def _fit(data: MeasuredReceptance, found: Found) -> Fit:
    return Fit(data, found.chain, found.residual, found.cost, confidence(found))


def _missed(made: Fit, limit: float) -> FitError:
    size, place = made.largest
    worst = made.data.frequency[np.argsort(np.abs(made.residual))[::-1]]
    if np.all(np.abs(np.angle(made.data.values)) < np.radians(np.pi)):
        hint = "all phases lie within ±π degrees: are they radians? Then write phase [rad]"
    else:
        hint = (
            "ask for one mass more, or for damping full; without an order, the command lists what"
            " each gives"
        )
    return FitError(
        "the fit misses the data", where=made.data.name,
        got=f"a misfit of {100 * made.misfit:.3g} % (root mean square), largest"
        f" {100 * size:.3g} % at {place:g} Hz, then at {listed(worst[1:])}",
        expected=f"at most {100 * limit:g} %", hint=hint,
    )  # fmt: skip
