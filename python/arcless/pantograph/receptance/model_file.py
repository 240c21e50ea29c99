"""Fitted receptance → pantograph, and the text of its model file."""

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from arcless.model import Pantograph
from arcless.model.load import load_text
from arcless.pantograph.receptance.fitted import Fit, Parameter
from arcless.pantograph.receptance.remarks import remarks
from arcless.pantograph.receptance.words import mode_words, sure_words
from arcless.units import plain

Floats = NDArray[np.float64]

# Digits of masses, springs and dampers: no measurement has them, but a reader of the file computes
# with the same receptance.
DIGITS = 7
# Digits of matrices: rounding must not make a damping matrix feed energy (ROUNDED of the model).
MATRIX_DIGITS = 12


def pantograph(fit: Fit, name: str, *, static_force: float | None = None) -> Pantograph:
    """Return the pantograph of a fit, as its file says it.

    Parameters
    ----------
    fit
        The fit.
    name
        Of the pantograph.
    static_force
        In N; None for a pantograph that gets it from a scenario.

    Raises
    ------
    ModelError
        The name or the force is none.
    """
    made = load_text(text(fit, name, static_force=static_force), f"{name}.yaml")
    assert isinstance(made, Pantograph)
    return made


def text(fit: Fit, name: str, *, static_force: float | None = None) -> str:
    """Return the model file of a fit: its numbers with ±, and how well it fits, as comments."""
    chain = fit.chain
    body = _masses(fit) if chain.kind == "joints" else _matrices(fit)
    given = [] if static_force is None else [f"static_force: {static_force:.7g} N"]
    head = [
        "format: arcless-pantograph/1",
        f"name: {_quoted(name)}",
        f"description: {_quoted(_description(fit))}",
        "sources:",
        f"  R: {_quoted(_source(fit))}",
        *(f"# {line}" for line in _about(fit)),
    ]
    return "\n".join([*head, *body, *given]) + "\n"


def _description(fit: Fit) -> str:
    count = fit.chain.order
    return f"{count} {'mass' if count == 1 else 'masses'} fitted to a measured receptance"


def _source(fit: Fit) -> str:
    from importlib.metadata import version

    data = fit.data
    digest = f", SHA-256 {data.digest}" if data.digest else ""
    low, high = data.frequency[0], data.frequency[-1]
    return (
        f"measured {data.quantity.replace('_', ' ')} in {plain(Path(data.name).name)}{digest},"
        f" {data.frequency.size} frequencies from {low:g} to {high:g} Hz; fitted by Arcless"
        f" {version('arcless')}"
    )


def _about(fit: Fit) -> list[str]:
    """Return lines about the quality of a fit."""
    size, place = fit.largest
    lines = [
        f"Misfit {100 * fit.misfit:.3g} % (root mean square), largest {100 * size:.3g} % at"
        f" {place:g} Hz; ± covers 95 %.",
    ]
    lines += [f"Free mode: {mode_words(mode)}." for mode in fit.modes]
    return lines + [f"Remark: {one}." for one in remarks(fit)]


def _masses(fit: Fit) -> list[str]:
    lines = ["masses:  # from base to head"]
    for one in fit.parameters:
        begin = "  - " if one.kind == "mass" else "    "
        number = f"{one.value:.{DIGITS}g} {one.unit}"
        note = f", note: {_sure(one)}"
        lines.append(f"{begin}{one.kind}: {{value: {number}, mark: D, source: R{note}}}")
    return lines


def _sure(one: Parameter) -> str:
    found = sure_words(one.sure)
    return f"{found} {one.unit}" if found else "not determined by the data"


def _matrices(fit: Fit) -> list[str]:
    parts, order = fit.chain.matrices, fit.chain.order
    named = (("mass", parts.mass, "kg"), ("damping", parts.damping, "N s/m"),
             ("stiffness", parts.stiffness, "N/m"))  # fmt: skip
    lines = ["matrices:  # in heights of the masses, from base to head"]
    for name, matrix, unit in named:
        value = ", ".join(f"[{', '.join(map(_entry, row))}]" for row in matrix)
        lines.append(f"  {name}: {{value: [{value}], mark: D, source: R}}  # {unit}")
    lines.append(f"  strip: {[0] * (order - 1) + [1]}")
    lines.append(f"  preload: {[1] + [0] * (order - 1)}")
    return lines


def _entry(value: float) -> str:
    return f"{value:.{MATRIX_DIGITS}g}" if value else "0"


def _quoted(text: str) -> str:
    """Return a text as YAML reads it in double quotes."""
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"') + '"'
