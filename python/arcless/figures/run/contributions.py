"""Figures of an explanation: shares of σ² by order, and what does not repeat along the track."""

import numpy as np

from arcless.explanation import PantographExplanation
from arcless.figures.description import Axis, Bars, Curve, Figure, Layer, Points, Rules, Tip
from arcless.figures.description.thinning import envelope
from arcless.figures.description.tokens import of_pantograph
from arcless.figures.run.run_data import Floats, RunData
from arcless.figures.run.track import along, titled

# Colours of the groups by key; those of the line as everywhere.
COLOURS = {
    "span": "series_1",
    "droppers": "series_2",
    "pantograph": "series_3",
    "rest": "raw",
}
# Room above the highest bar, and width of a bar in orders.
HEADROOM, WIDTH = 1.12, 0.8
# Most orders that are drawn as bars: of more, bars are thinner than a screen shows.
MOST_BARS = 300
POINTS = 6000


def contributions(run: RunData) -> list[Figure]:
    """Return the shares of the variance by waves in a span, stacked by what they belong to."""
    if run.explanation is None:
        return []
    stacked = [_stacks(one) for one in run.explanation.pantographs]
    top = HEADROOM * max(float(np.sum([*shares.values()], axis=0).max()) for _, shares in stacked)
    last = max(int(orders[-1]) for orders, _ in stacked)
    found = []
    for i, (one, (orders, shares)) in enumerate(
        zip(run.explanation.pantographs, stacked, strict=True)
    ):
        length = one.orders[0].wavelength_m * one.orders[0].of_span
        layers = [*_passing(one), *_bars(one, orders, shares, length)]
        words = "; ".join(f"{group.name} {group.share_percent:.0f} %" for group in one.groups)
        found.append(
            Figure(
                f"contributions-{i + 1}",
                titled(run, "Contributions to the variance of the contact force", i),
                Axis("waves in a span", "", -0.5, last + 0.5),
                Axis("share of the variance σ²", "%", 0.0, top),
                layers,
                caption=f"The bars add up to σ². A wave that fits n times into the mean span of"
                f" {length:.1f}\u00a0m is {length:.1f}\u00a0m/n long and passes at"
                f" {_passing_Hz(one):.2f}\u00a0Hz times n.{_modes(one)}",
                alt=f"Shares of the variance of the contact force of {one.name}: {words}.",
            )
        )
    return found


def irregular(run: RunData) -> list[Figure]:
    """Return the part of the force that does not repeat, along the track."""
    if run.explanation is None:
        return []
    traces = [one.trace for one in run.explanation.pantographs]
    high = 1.08 * max(float(np.abs(one.remainder_N).max()) for one in traces) or 1.0
    found = []
    for i, (one, trace) in enumerate(zip(run.explanation.pantographs, traces, strict=True)):
        rows = envelope(trace.remainder_N, POINTS // len(traces))
        tips = (Tip("deviation", "y", "N"), Tip("position", "x", "m"))
        layers: list[Layer] = [
            Curve(trace.position_m[rows], trace.remainder_N[rows], colour=of_pantograph(i),
                  width=1.6, tips=tips)
        ]  # fmt: skip
        marked = [place for place in one.irregular if place.stands_out]
        if marked:
            x = np.array([place.position_m for place in marked])
            y = np.array([place.deviation_N for place in marked])
            where = Tip("", [place.where for place in marked], form="")
            layers.append(
                Points(x, y, colour="highlight", size=9.0, name="stands out", tips=(where, *tips))
            )
        share = 100.0 * float(np.mean(trace.remainder_N**2)) / one.std_force_N**2
        largest = one.irregular[0]
        found.append(
            along(
                run, f"irregular-{i + 1}",
                titled(run, "Contact force beyond what repeats with spans and droppers", i),
                Axis("deviation", "N", -high, high), layers,
                caption=f"Filtered force less its mean and its orders of spans and droppers:"
                f" {share:.1f}\u00a0% of σ².",
                alt=f"Part of the contact force of {one.name} that does not repeat, at most"
                f" {abs(largest.deviation_N):.1f} N at {largest.position_m:.1f} m,"
                f" {largest.where}.",
            )
        )  # fmt: skip
    return found


def _modes(one: PantographExplanation) -> str:
    """Return the natural frequencies of the pantograph in a sentence."""
    if not one.modes:
        return ""
    names = ", ".join(f"{mode.frequency_Hz:.2f}" for mode in one.modes)
    return f" Natural frequencies of the pantograph on the line: {names}\u00a0Hz."


def _passing_Hz(one: PantographExplanation) -> float:  # noqa: N802 - unit in the name
    return one.orders[0].frequency_Hz / one.orders[0].of_span


def _stacks(one: PantographExplanation) -> tuple[Floats, dict[str, Floats]]:
    """Return the numbers of waves in a span, and the share of each group about them in %."""
    lines = np.rint(one.trace.line_Hz / _passing_Hz(one)).astype(int)
    most = min(MOST_BARS, max(round(order.of_span) for order in one.orders))
    orders = np.arange(most + 1, dtype=np.float64)
    shares = {key: np.zeros(most + 1) for key in COLOURS}
    for order in one.orders:
        shares[order.group][min(most, round(order.of_span))] += order.share_percent
    percent = 100.0 * one.trace.line_variance_N2 / one.std_force_N**2
    bins = np.minimum(lines, most)
    modes = one.trace.line_mode >= 0
    np.add.at(shares["pantograph"], bins[modes], percent[modes])
    np.add.at(shares["rest"], bins[~modes], percent[~modes])
    return orders, shares


def _bars(
    one: PantographExplanation,
    orders: Floats,
    shares: dict[str, Floats],
    length: float,
) -> list[Layer]:
    layers: list[Layer] = []
    below = np.zeros_like(orders)
    with np.errstate(divide="ignore"):
        wavelength = [f"{x:.2f} m" if np.isfinite(x) else "none" for x in length / orders]
    for group in one.groups:
        share = shares[group.key]
        tips = (
            Tip("", [group.name] * orders.size, form=""),
            Tip("waves in a span", orders, "", "0"),
            Tip("frequency", orders * _passing_Hz(one), "Hz", "0.00"),
            Tip("wavelength", wavelength, form=""),
            Tip("share", share, "%", "0.00"),
        )
        if group.share_percent > 0.0:
            layers.append(
                Bars(orders - WIDTH / 2.0, orders + WIDTH / 2.0, below, below + share,
                     colour=COLOURS[group.key], tips=tips,
                     name=f"{group.name}, {group.share_percent:.1f} %")
            )  # fmt: skip
        below = below + share
    return layers


def _passing(one: PantographExplanation) -> list[Layer]:
    """Return the orders of the droppers, and where the pantograph has its natural frequencies."""
    layers: list[Layer] = []
    known = [order for order in one.orders if order.of_droppers is not None]
    if known:
        per_span = known[0].of_span / (known[0].of_droppers or 1.0)
        highest = max(order.of_span for order in known)
        at = per_span * np.arange(1, int(highest / per_span) + 1)
        if at.size:
            spacing = known[0].wavelength_m * known[0].of_span / per_span
            harmonics = " and harmonics" if at.size > 1 else ""
            layers.append(
                Rules(axis="x", at=at, colour="dropper", dash="dotted", width=1.4,
                      name=f"dropper passing, {spacing:.2f} m{harmonics}")
            )  # fmt: skip
    if one.modes:
        at = np.array([mode.frequency_Hz for mode in one.modes]) / _passing_Hz(one)
        layers.append(
            Rules(axis="x", at=at, colour="highlight", dash="dashed", width=1.2,
                  name="natural frequency")
        )  # fmt: skip
    return layers
