"""Statements of verification tests: a value, its reference, its tolerance, and the reason."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from math import inf, isfinite, log
from typing import Any

import numpy as np

from arcless.validate.evidence import INSIDE, OUTSIDE, UNVERIFIED, Measurement
from arcless.validate.reference import VERIFIED

LEAST_SIZES = 3


class OutsideError(AssertionError):
    """A value is not where it must be."""

    def __init__(self, row: Measurement) -> None:
        super().__init__(f"{row.what}: {row.value:.9g} {row.unit}, allowed {row.allowed}")
        self.row = row


@dataclass
class Evidence:
    """Collects the values of one test; each method records, then fails if the value is outside.

    `reason` says why the tolerance is what it is. `what` is unique within a file.
    """

    test: str = ""
    slow: bool = False
    rows: list[Measurement] = field(default_factory=list)
    figures: list[dict[str, Any]] = field(default_factory=list)

    def close(
        self, what: str, value: float, reference: float, *, unit: str, reason: str,
        relative: float | None = None, absolute: float | None = None, mark: str = "",
    ) -> None:  # fmt: skip
        """Hold a value against a reference, within a relative or an absolute tolerance."""
        if (relative is None) == (absolute is None):
            raise ValueError(f"{what}: give one tolerance, relative or absolute")
        reference = float(reference)
        if relative is not None:
            tolerance, allowed = abs(reference) * relative, f"± {100 * relative:.3g} %"
            if relative < 1e-6:
                allowed = f"± {relative:.1e} of it"
        else:
            tolerance = float(absolute or 0.0)
            allowed = f"± {tolerance:.3g} {_shown(unit)}".rstrip()
        if not tolerance > 0.0:
            raise ValueError(f"{what}: a tolerance of nothing; use `same` for equal bits")
        self._judge(
            what, value, unit, reference=reference, low=reference - tolerance,
            high=reference + tolerance, allowed=allowed, reason=reason, mark=mark,
        )  # fmt: skip

    def below(
        self, what: str, value: float, limit: float, *, unit: str, reason: str, mark: str = "",
        table: list[list[float]] | None = None,
    ) -> None:  # fmt: skip
        """Hold a residual or a difference, which cannot be negative, against its limit."""
        if value < 0.0:
            raise ValueError(f"{what}: {value} is negative; take its size first")
        allowed = f"≤ {limit:.3g} {_shown(unit)}".rstrip()
        self._judge(
            what, value, unit, low=None, high=limit, allowed=allowed, reason=reason, mark=mark,
            table=table or [],
        )  # fmt: skip

    def within(
        self, what: str, value: float, low: float, high: float, *, unit: str, reason: str,
        mark: str = "",
    ) -> None:  # fmt: skip
        """Hold a value against two bounds."""
        allowed = f"{low:.6g} to {high:.6g} {_shown(unit)}".rstrip()
        self._judge(
            what, value, unit, low=low, high=high, allowed=allowed, reason=reason, mark=mark
        )

    def same(self, what: str, *, compared: int, differing: int, reason: str) -> None:
        """Demand that of the numbers compared none differs in any bit."""
        if not compared > 0:
            raise AssertionError(f"{what}: nothing was compared")
        text = f"of {compared} numbers"
        self._judge(
            what, differing, text, low=None, high=0.0, allowed="no bit differs", reason=reason
        )

    def order(
        self, what: str, sizes: Sequence[float], errors: Sequence[float], expected: float, *,
        tolerance: float, reason: str, unit: str,
    ) -> None:  # fmt: skip
        """Hold the slope of log(error) over log(size), by least squares, against an order."""
        if len(sizes) < LEAST_SIZES or len(sizes) != len(errors):
            raise ValueError(f"{what}: {LEAST_SIZES} sizes and as many errors are needed")
        if not all(isfinite(e) and e > 0.0 for e in errors):
            raise AssertionError(f"{what}: errors {list(errors)} have no logarithm")
        slope = float(np.polyfit(np.log(sizes), np.log(errors), 1)[0])
        local = [
            log(errors[i] / errors[i - 1]) / log(sizes[i] / sizes[i - 1])
            for i in range(1, len(sizes))
        ]
        table = [
            [float(size), float(error), *([local[i - 1]] if i else [])]
            for i, (size, error) in enumerate(zip(sizes, errors, strict=True))
        ]
        self._judge(
            what, slope, f"order in {unit}", reference=expected, low=expected - tolerance,
            high=expected + tolerance, allowed=f"{expected:g} ± {tolerance:g}", reason=reason,
            table=table,
        )  # fmt: skip

    def published(
        self, what: str, value: float, low: float | None, high: float | None, *, unit: str,
        mark: str, source: str,
    ) -> None:  # fmt: skip
        """Record where a value lies in a published range; being outside is a finding, no failure.

        That the verdict stays as recorded is checked when the row is compared with its record.
        """
        bounds = (-inf if low is None else low), (inf if high is None else high)
        inside = bounds[0] <= value <= bounds[1]
        verdict = INSIDE if inside else OUTSIDE if mark == VERIFIED else UNVERIFIED
        texts = [f"{bound:g}" for bound in (low, high) if bound is not None]
        shown = (
            " to ".join(texts) if len(texts) > 1 else f"{'≤' if low is None else '≥'} {texts[0]}"
        )
        self.rows.append(
            Measurement(
                what, unit, float(value), None, low, high, f"{shown} {_shown(unit)}".rstrip(),
                source, mark, verdict, self.test, self.slow,
            )
        )  # fmt: skip

    def figure(
        self, name: str, curves: dict[str, tuple[Any, Any]], *, x: str, y: str, title: str,
        log_x: bool = False, log_y: bool = False,
    ) -> None:  # fmt: skip
        """Offer a picture, {label: (x values, y values)}; it is drawn when records are written."""
        self.figures.append(
            {"name": name, "curves": curves, "x": x, "y": y, "title": title,
             "log_x": log_x, "log_y": log_y}
        )  # fmt: skip

    def _judge(self, what: str, value: float, unit: str, **rest: Any) -> None:
        if not rest["reason"].strip():
            raise ValueError(f"{what}: a tolerance needs its reason")
        if any(row.what == what for row in self.rows):
            raise ValueError(f"{what}: recorded twice")
        value, low, high = float(value), rest["low"], rest["high"]
        # NaN is inside of nothing.
        inside = (low is None or value >= low) and (high is None or value <= high)
        inside = inside and isfinite(value)
        verdict = INSIDE if inside else OUTSIDE
        fields = {"reference": None, "mark": ""} | rest
        row = Measurement(
            what, unit, value, verdict=verdict, test=self.test, slow=self.slow, **fields
        )
        if not inside:
            raise OutsideError(row)
        self.rows.append(row)


def _shown(unit: str) -> str:
    return "" if unit == "1" else unit
