"""Contact channels of a stored run, read in blocks of rows."""

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from arcless.studio.motion.channels import ROUNDING_S, Singles

Floats = NDArray[np.float64]
# Bytes of chunks that HDF5 keeps unpacked of each variable: those of the rows that are played.
# With less each row unpacks its chunk again.
CACHE = 16 << 20


class ContactRows:
    """Rows of the contact channels of a file, by their time.

    Attributes
    ----------
    times
        Times of all rows in s.
    pantographs
        Name and number of masses of each.
    """

    def __init__(self, data: Mapping[str, Any]) -> None:
        self._data = data
        self.times: Floats = np.asarray(data["time"][:], dtype=float)
        self._masses = _masses(data)
        names = texts(data["pantograph"])
        self.pantographs = tuple(zip(names, map(len, self._masses), strict=True))

    def before(self, times: Floats) -> NDArray[np.intp]:
        """Return the last row at or before each time in s."""
        found = np.searchsorted(self.times, times + ROUNDING_S, side="right") - 1
        return np.maximum(found, 0)

    def values(self, rows: NDArray[np.intp]) -> list[Singles]:
        """Return of each pantograph position, force, height, uplift, masses, in ascending rows."""
        if not len(rows):
            return []
        part = slice(int(rows[0]), int(rows[-1]) + 1)
        at = rows - rows[0]

        def read(name: str) -> Floats:
            values: Floats = np.asarray(self._data[name][part])[at]
            return values

        head = [read(name) for name in ("position", "contact_force", "contact_height")]
        moved = read("mass_displacement") if any(map(len, self._masses)) else None
        found = []
        for number, masses in enumerate(self._masses):
            columns = [*(values[:, number] for values in head), np.full(len(rows), np.nan)]
            if moved is not None:
                columns += list(moved[:, number, masses].T)
            found.append(np.column_stack(columns).astype(np.float32))
        return found


def texts(labels: Any) -> list[str]:
    """Return the labels of a dimension of names, as the file has them."""
    return [one.decode() if isinstance(one, bytes) else str(one) for one in labels[:]]


def _masses(data: Mapping[str, Any]) -> list[list[int]]:
    """Return the masses of each pantograph: others have fewer than the dimension has numbers."""
    count = data["contact_force"].shape[1]
    if "mass_displacement" not in data:
        return [[] for _ in range(count)]
    first = np.asarray(data["mass_displacement"][0])
    return [np.flatnonzero(np.isfinite(first[number])).tolist() for number in range(count)]
