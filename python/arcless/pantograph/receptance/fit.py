"""Measured receptance → chain of masses of a stated order.

Starts are the chain of vector fitting (`start`) and the chain of one mass less with a mass split
in two; from each the sum of squares is brought to its minimum (`least_squares`), and the least is
kept.
"""

from collections.abc import Callable, Iterator

import numpy as np

from arcless.errors import FitError, MeasurementError
from arcless.pantograph.receptance import least_squares, start
from arcless.pantograph.receptance.chain import Chain, Damping, of_damping, with_full_damping
from arcless.pantograph.receptance.confidence import confidence
from arcless.pantograph.receptance.fitted import Fit, errors
from arcless.pantograph.receptance.least_squares import Found, Target
from arcless.pantograph.receptance.measured import NAMED, MeasuredReceptance, listed
from arcless.units import to_si

# A pantograph is modelled by two or three masses; a head does not show more modes than this.
MOST_MASSES = 8
# Numbers measured, two at a frequency, for each parameter: with fewer the error is a guess.
NUMBERS_EACH = 3
# Root mean square of the misfit above which nothing is handed out unless asked for: contact forces
# of such a model would be off by as much near its modes.
LARGEST_MISFIT = 0.10
# Frequencies at which masses are split, for starts: in equal ratios over the band and half above.
SPLITS, ABOVE = 6, 1.5


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
    *_, found = _rising(data, order, damping)
    made = _fit(data, found)
    if made.misfit > limit:
        raise _missed(made, limit)
    if not found.ended:
        raise FitError(
            "the search for the masses did not end", where=data.name,
            got=f"{2 * least_squares.MOST_EVALUATIONS} evaluations with a misfit of"
            f" {100 * made.misfit:.3g} %", expected="a minimum",
            hint="use one mass less: the data may not distinguish this many",
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
            hint="use fewer masses, or measure at more frequencies",
        )  # fmt: skip


def _fits(data: MeasuredReceptance, order: int, damping: Damping = "joints") -> bool:
    parameters = 2 * order + of_damping(order, damping)
    return NUMBERS_EACH * parameters <= 2 * data.frequency.size


def _target(data: MeasuredReceptance) -> Target:
    return Target(data.frequency, least_squares.logarithm(data.values), errors(data))


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
        starts = start.chains(data.frequency, data.values, chain.order, "full")
        starts += [least_squares.begun_full(chain), with_full_damping(chain)]
        return least_squares.best(_target(data), starts)


def _fit(data: MeasuredReceptance, found: Found) -> Fit:
    return Fit(data, found.chain, found.residual, found.cost, confidence(found))


def _missed(made: Fit, limit: float) -> FitError:
    size, place = made.largest
    worst = made.data.frequency[np.argsort(np.abs(made.residual))[::-1]]
    if np.all(np.abs(np.angle(made.data.values)) < np.radians(np.pi)):
        hint = "all phases lie within ±π degrees: are they radians? Then write phase [rad]"
    else:
        hint = (
            "use one mass more, or damping full; without an order the command lists what each gives"
        )
    return FitError(
        "the fit misses the data", where=made.data.name,
        got=f"a misfit of {100 * made.misfit:.3g} % (root mean square), largest"
        f" {100 * size:.3g} % at {place:g} Hz, then at {listed(worst[1 : 1 + NAMED])}",
        expected=f"at most {100 * limit:g} %", hint=hint,
    )  # fmt: skip
