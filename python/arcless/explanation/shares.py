"""Variances of orders and spectral lines → shares of σ², each with its uncertainty."""

from math import sqrt

import numpy as np
from numpy.typing import NDArray

from arcless.explanation.parts import GROUPS, Group, GroupKey, Mode, OrderShare, Strongest
from arcless.explanation.signals.orders import Fit
from arcless.explanation.signals.remainder import Lines, band, chance, mode_at
from arcless.pantograph.natural_modes import PantographMode

Floats = NDArray[np.float64]
Chosen = NDArray[np.bool_]


class Shares:
    """Shares of one pantograph.

    Parameters
    ----------
    split
        Its force, split by orders.
    lines
        Spectral lines of the remainder.
    own
        Its natural modes within the frequencies of the filtered force.
    mean_span, speed
        Mean length of a span in m, mean speed in m/s.
    """

    def __init__(
        self, split: Fit, lines: Lines, own: list[PantographMode], mean_span: float, speed: float
    ) -> None:
        self.split, self.lines, self.own = split, lines, own
        self.mean_span, self.speed = mean_span, speed
        self.variance = float(split.variances.sum() + lines.variance.sum())
        self.bands = [band(one) for one in own]
        self.owner = mode_at(lines.frequency, self.bands)
        passing = speed / mean_span
        self.at: Floats = passing * np.array([one.of_span for one in split.orders])
        self.mode_of_order = mode_at(self.at, self.bands)
        taken = np.count_nonzero(~np.isnan(split.columns), axis=1)
        # A free line has two columns.
        expected = 0.5 * chance(lines, self.at, taken, passing)[:, None]
        expected = np.where(np.isnan(split.columns), 0.0, expected)
        true = np.maximum(np.nan_to_num(split.columns) - expected, 0.0)
        self.expected: Floats = expected.sum(axis=1)
        self.unsure: Floats = np.sum(4.0 * true * expected + 2.0 * expected**2, axis=1)

    def groups(self) -> tuple[Group, ...]:
        """Return the four groups, which add up to the variance."""
        sources = np.array([one.source for one in self.split.orders])
        modes = self.owner >= 0
        return (
            self._of_orders("span", sources == "span"),
            self._of_orders("droppers", sources == "droppers"),
            self._of_lines("pantograph", modes),
            self._of_lines("rest", ~modes),
        )

    def orders(self, per_span: float | None) -> tuple[OrderShare, ...]:
        """Return the orders, the longest wave first; `per_span` is the dropper intervals in one."""
        found = [
            OrderShare(
                group=one.source,
                of_span=float(one.of_span),
                of_droppers=None if per_span is None else float(one.of_span / per_span),
                wavelength_m=float(self.mean_span / one.of_span),
                frequency_Hz=float(frequency),
                variance_N2=float(variance),
                share_percent=self._percent(variance),
                uncertainty_percent=self._known(np.sqrt(unsure)),
                mode=None if mode < 0 else int(mode) + 1,
            )
            for one, frequency, variance, unsure, mode in zip(
                self.split.orders, self.at, self.split.variances, self.unsure, self.mode_of_order,
                strict=True,
            )
        ]  # fmt: skip
        return tuple(sorted(found, key=lambda one: one.of_span))

    def modes(self) -> tuple[Mode, ...]:
        """Return the modes with what lies in their bands."""
        found = []
        for number, (one, ends) in enumerate(zip(self.own, self.bands, strict=True)):
            free = float(self.lines.variance[self.owner == number].sum())
            bound = float(self.split.variances[self.mode_of_order == number].sum())
            found.append(
                Mode(
                    number + 1, ends.middle, (ends.low, ends.high), one.damping_ratio,
                    self._percent(free), self._percent(free + bound),
                )
            )  # fmt: skip
        return tuple(found)

    def _of_orders(self, key: GroupKey, mine: Chosen) -> Group:
        variances = self.split.variances[mine]
        sure, random = np.sqrt(self.unsure[mine].sum()), self.expected[mine].sum()
        strongest = self._strongest(self.at[mine], variances)
        return self._group(key, variances.sum(), sure, random, strongest)

    def _of_lines(self, key: GroupKey, mine: Chosen) -> Group:
        variances = self.lines.variance[mine]
        strongest = self._strongest(self.lines.frequency[mine], variances)
        return self._group(key, variances.sum(), np.sqrt(np.sum(variances**2)), None, strongest)

    def _group(
        self,
        key: GroupKey,
        variance: float,
        uncertainty: float,
        random: float | None,
        strongest: Strongest | None,
    ) -> Group:
        return Group(
            key=key,
            name=GROUPS[key],
            variance_N2=float(variance),
            share_percent=self._percent(variance),
            std_N=sqrt(max(0.0, float(variance))),
            uncertainty_percent=self._known(uncertainty),
            chance_percent=None if random is None else self._known(random),
            strongest=strongest,
        )

    def _strongest(self, at: Floats, variances: Floats) -> Strongest | None:
        if not np.any(variances > 0.0):
            return None
        place = int(variances.argmax())
        frequency, mode = float(at[place]), int(mode_at(at, self.bands)[place])
        return Strongest(
            frequency_Hz=frequency,
            wavelength_m=self.speed / frequency if frequency else None,
            share_percent=self._percent(variances[place]),
            mode=None if mode < 0 else mode + 1,
        )

    def _percent(self, variance: float) -> float:
        return float(100.0 * variance / self.variance)

    def _known(self, variance: float) -> float | None:
        return None if np.isnan(variance) else self._percent(variance)
