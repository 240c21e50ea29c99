"""Spoilt tables of measured receptances: refused in words, or fitted by a sound pantograph."""

import json
import warnings
from functools import cache
from pathlib import Path
from random import Random
from tempfile import gettempdir

import numpy as np

from arcless.errors import ArclessError
from arcless.model import load_any
from arcless.pantograph import receptance
from tests.hostile.campaign import spoiling
from tests.hostile.campaign.blocks import FoundError
from tests.support.hostile import DIGITS, TEXTS, numbers_in
from tests.support.receptances import measured, table

# As few as a fit of two masses takes: a spoilt number is one of a few dozen.
FREQUENCIES = np.geomspace(0.5, 20.0, 14)
QUANTITIES = {"receptance": "m/N", "mobility": "m/s/N", "dynamic_stiffness": "N/m"}
# Any misfit is accepted: what is fitted to nonsense must be a pantograph all the same.
ANY_MISFIT = 1e9
STATIC_FORCE_N = 70.0
# Half of them leave a table that is fitted.
FACTORS = [0.5, 0.8, 0.95, 1.05, 1.3, 2.0, 10.0, -1, 0, 1e9, 1e-9, 1e150, 1e-300]


@cache
def sound(quantity: str) -> str:
    """Table of the receptance of two masses with 3 % of noise, and of its errors."""
    data = measured("en50318-2002", 0.03, frequency=FREQUENCIES)
    head, *rows = table(data, quantity, QUANTITIES[quantity]).splitlines()
    lines = [f"{head}, relative_error [%]", *(f"{row}, 3" for row in rows)]
    return "\n".join(lines) + "\n"


def case(seed: int) -> str:
    """Spoil the bytes or the cells of a table, and fit it."""
    random = Random(f"receptances {seed}")
    text = sound(random.choice(list(QUANTITIES)))
    bytes_ = spoiling.text(random, text.encode()) if random.random() < 0.2 else cells(random, text)
    path = Path(gettempdir()) / f"arcless-campaign-{seed}.csv"
    path.write_bytes(bytes_)
    try:
        return answered(path, random.choice([1, 2]), random.choice(["joints", "full"]))
    finally:
        path.unlink()


def cells(random: Random, text: str) -> bytes:
    """Change some cells of a table: to other numbers, by factors, to texts; or its columns."""
    rows = [row.split(",") for row in text.splitlines()]
    for _ in range(random.randint(1, 3)):
        column = random.randrange(len(rows[0]))
        many = random.random() < 0.2
        for row in rows[1:] if many else [random.choice(rows[1:])]:
            row[column % len(row)] = other(random, row[column % len(row)])
        if random.random() < 0.02:
            rows[0][column] = random.choice([" phase [rad]", " frequency [Hz]", " x", ""])
    return "\n".join(",".join(row) for row in rows).encode("utf-8", "surrogatepass")


def other(random: Random, cell: str) -> str:
    """Return another cell."""
    way = random.random()
    if way < 0.95:
        try:
            return f"{float(cell) * random.choice(FACTORS):g}"
        except ValueError:
            return cell
    if way < 0.98:
        return random.choice(DIGITS)
    return random.choice(TEXTS).replace("\n", " ")


def answered(path: Path, order: int, damping: receptance.Damping) -> str:
    """Read and fit a table; it is refused in words, or a pantograph comes of it.

    Warnings of a library are faults: the user would see them.
    """
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        try:
            data = receptance.read(path)
            found = receptance.fit(data, order, damping=damping, largest_misfit=ANY_MISFIT)
            text = receptance.text(found, "spoilt", static_force=STATIC_FORCE_N)
            made = receptance.pantograph(found, "spoilt", static_force=STATIC_FORCE_N)
        except ArclessError as error:
            _check_message(str(error), path)
            return "refused"
        told = json.loads(json.dumps(receptance.to_dict(found), allow_nan=False))
        check_pantograph(found)
    if load_any(made.to_dict()) != made or not all(np.isfinite(list(numbers_in(told)))):
        raise FoundError(f"a pantograph that is another one when it is read: {text}")
    return "fitted"


def check_pantograph(found: receptance.Fit) -> None:
    """Refuse a chain that is not stable, or gives energy back."""
    matrices = found.chain.matrices
    for name in ("mass", "damping", "stiffness"):
        matrix = np.asarray(getattr(matrices, name))
        if not np.isfinite(matrix).all():
            raise FoundError(f"numbers of {name} that are not finite")
        values = np.linalg.eigvalsh(matrix)
        # Rounding of a matrix without one of its springs or dampers.
        if values[0] < -1e-9 * max(abs(values[-1]), np.finfo(float).tiny):
            raise FoundError(f"{name} that gives energy: {values.tolist()}")


def _check_message(message: str, path: Path) -> None:
    if not message or "Traceback" in message or not message.replace("\n", "").isprintable():
        raise FoundError(f"a message that does not print: {message!r}")
    if str(path) not in message and "nan" in message.lower():
        raise FoundError(message)
