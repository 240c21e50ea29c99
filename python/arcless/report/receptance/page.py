"""Fitted receptance → one HTML page: data and model, how well, how surely, and other orders."""

from collections.abc import Sequence
from datetime import UTC, datetime
from importlib.metadata import version
from pathlib import Path

from arcless.display.numbers import real_minus
from arcless.figures.receptance import figures
from arcless.pantograph.receptance import Fit, remarks, tables
from arcless.pantograph.receptance.words import significant
from arcless.report.template import render
from arcless.storage.whole_files import write_bytes

_CONTENTS = (
    ("summary", "Summary"), ("receptance", "Receptance"), ("misfit", "Misfit"), ("modes", "Modes"),
    ("parameters", "Masses, springs, dampers"), ("orders", "Orders"), ("file", "Model file"),
)  # fmt: skip


def write(fit: Fit, fits: Sequence[Fit], name: str, text: str, path: str | Path) -> None:
    """Write the page: one HTML file that opens without a network.

    Parameters
    ----------
    fit
        The fit that is shown.
    fits
        Fits of other orders, for the table by which an order is chosen.
    name, text
        Name of the pantograph, and the text of its model file.
    path
        The file to write; its folder must exist.

    Raises
    ------
    OutputError
        The file cannot be written; nothing half-written stays behind.
    """
    write_bytes(path, html(fit, fits, name, text).encode())


def html(fit: Fit, fits: Sequence[Fit], name: str, text: str) -> str:
    """Return the page of a fit as one HTML text; see `write`."""
    drawn = figures(fit)
    matrices = fit.chain.matrices
    return render(
        "receptance.html",
        drawn,
        title=f"Receptance of {name}",
        name=name,
        identity=_identity(fit),
        numbers=_numbers(fit),
        remarks=remarks(fit),
        modes={"titles": tables.MODES, "rows": tables.mode_rows(fit), "texts": 1},
        parameters={
            "titles": tables.parameter_titles(fit), "rows": tables.parameter_rows(fit), "texts": 1,
        },
        damping=None if fit.chain.kind == "joints" else [
            [_cell(float(value)) for value in row] for row in matrices.damping
        ],
        orders={"titles": tables.ORDERS, "rows": tables.order_rows(fits), "texts": 2},
        orders_read=tables.ORDERS_READ,
        text=text,
        contents=_CONTENTS,
        version=version("arcless"),
        date=f"{datetime.now(UTC):%Y-%m-%d %H:%M}",
    )  # fmt: skip


def _identity(fit: Fit) -> list[tuple[str, str]]:
    data, chain = fit.data, fit.chain
    f = data.frequency
    found = [
        ("Measured", f"{data.quantity.replace('_', ' ')} in {Path(data.name).name}"),
        ("Data", f"{f.size} frequencies, {f[0]:g} to {f[-1]:g} Hz"),
        ("Model", f"{chain.order} {'mass' if chain.order == 1 else 'masses'}, damping"
         f" {tables.DAMPING_WORDS[chain.kind]}"),
        ("Arcless", version("arcless")),
    ]  # fmt: skip
    if data.digest:
        found.insert(1, ("SHA-256", data.digest))
    return found


def _cell(value: float) -> str:
    """Return an entry of a matrix with a real minus sign."""
    return real_minus(significant(value, 4))


def _numbers(fit: Fit) -> list[tuple[str, str, str]]:
    size, place = fit.largest
    rows = [
        ("misfit, root mean square", significant(100.0 * fit.misfit, 3), "%"),
        (f"largest misfit, at {place:g} Hz", significant(100.0 * size, 3), "%"),
        ("moving mass", significant(float(fit.chain.mass.sum()), 4), "kg"),
        ("mass of the head", significant(float(fit.chain.mass[-1]), 4), "kg"),
    ]
    swinging = [one for one in fit.modes if one.frequency_Hz and one.damping_ratio < 1.0]
    if swinging:
        text = ", ".join(significant(one.frequency_Hz, 3) for one in swinging)
        rows.append(("modes that swing", text, "Hz"))
    if fit.over_noise is not None:
        rows.append(("misfit over the given errors", f"{fit.over_noise:.2f}", ""))
    return rows
