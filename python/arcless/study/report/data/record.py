"""Data of a study's report: its rows as columns of numbers."""

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from arcless.assess.quantities import QUANTITIES, label_of
from arcless.study.analysis.findings import Findings, of
from arcless.study.definition.quantities import WORST, is_number, owner_of_key
from arcless.study.definition.study import Study
from arcless.study.folder import table
from arcless.study.folder.folder import StudyFolder
from arcless.study.folder.status import RowCounter, StudyStatus
from arcless.study.journal.row import Row

Floats = NDArray[np.float64]
_LONGEST_WORD = 28


@dataclass(frozen=True)
class Column:
    """A variable or an output over the rows that are done.

    Attributes
    ----------
    name, unit, about
        Of a variable the unit that the study file gives it in; `about` is a description, or where
        it comes from.
    values
        Numbers in that unit, NaN for none; of words the place in `words`.
    words
        The values that are no numbers, in the order of the study file; None for numbers.
    is_drawn
        Whether the values are numbers of drawings, over which there is nothing to plot.
    scale
        Size of the unit in SI.
    title
        Name that people are shown: that of the quantity, where the study file gives no other.
    of
        The pantograph that it belongs to, in words; empty where there is one alone, or none.
    """

    name: str
    unit: str
    about: str
    values: Floats
    words: tuple[str, ...] | None = None
    is_drawn: bool = False
    scale: float = 1.0
    title: str = ""
    of: str = ""

    @property
    def heading(self) -> str:
        """Name, and the pantograph that it belongs to."""
        return ", ".join(part for part in (self.title or self.name, self.of) if part)

    @property
    def label(self) -> str:
        """Name, pantograph and unit."""
        return f"{self.heading}, {self.unit}" if self.unit else self.heading

    @property
    def varies(self) -> bool:
        """True when there are two different values."""
        known = self.values[np.isfinite(self.values)]
        return bool(known.size and known.min() < known.max())


class RowColumns:
    """Rows that are done, as columns.

    Parameters
    ----------
    study
        The study.
    done
        Rows of it with the status `done`.
    """

    def __init__(self, study: Study, done: list[Row]) -> None:
        self.study, self.done = study, done

    @cached_property
    def variants(self) -> NDArray[np.int64]:
        """Numbers of the variants that are done."""
        return np.array([row.variant for row in self.done], dtype=np.int64)

    @cached_property
    def variables(self) -> list[Column]:
        """The variables."""
        found = []
        for axis in self.study.axes:
            about = self.study.variables[axis.name].description or axis.field
            given = [row.values[axis.name] for row in self.done]
            levels = axis.levels or ()
            if all(is_number(value) for value in levels):
                numbers = np.array(given, dtype=float) / axis.scale
                found.append(
                    Column(
                        axis.name, axis.typed_unit, about, numbers,
                        is_drawn=axis.is_drawn, scale=axis.scale,
                    )
                )  # fmt: skip
            else:
                words = list(dict.fromkeys(_word(value) for value in levels))
                codes = np.array([words.index(_word(value)) for value in given], dtype=float)
                shown = tuple(words_of(axis.name, levels))
                found.append(Column(axis.name, "", about, codes, shown))
        return found

    @cached_property
    def outputs(self) -> list[Column]:
        """The outputs."""
        found = []
        for name, output in self.study.outputs.items():
            values = [row.outputs.get(name) for row in self.done]
            unit = table.unit_of_output(self.study, name)
            key, known = output.expression.strip(), quantity_of(output.expression)
            about = output.description or known or output.expression
            found.append(
                Column(
                    name, "" if unit == "1" else unit, about, np.array(values, dtype=float),
                    title=known if name == key else name, of=pantograph_of(self.study, name),
                )
            )  # fmt: skip
        return found


class Record(RowColumns):
    """A study and the rows that it has.

    Parameters
    ----------
    study
        From `arcless.study.load`.
    folder
        Its folder; ``runs/studies/NAME`` without.

    Raises
    ------
    StudyError
        No study was begun there, or another one; a package is missing.
    """

    def __init__(self, study: Study, folder: Path | None = None) -> None:
        table.check_available()
        self.place = StudyFolder(study, folder)
        self.state: dict[str, Any] = self.place.check_same()
        self.place.recall()
        tally = RowCounter()
        self.rows: list[Row] = list(tally.of(self.place.rows()))
        self.status: StudyStatus = tally.status(study, self.place)
        super().__init__(study, [row for row in self.rows if row.status == "done"])

    @cached_property
    def findings(self) -> Findings:
        """Findings of all rows together."""
        return of(self.study, self.rows)


def quantity_of(expression: str) -> str:
    """Return the name of the assessed quantity that an output is; empty where it is none."""
    quantity = expression.strip().rpartition(".")[2]
    return label_of(quantity) if quantity in QUANTITIES else ""


def decimals_of(expression: str) -> int | None:
    """Return the decimals of the assessed quantity that an output is; None where it has none."""
    known = QUANTITIES.get(expression.strip().rpartition(".")[2])
    return None if known is None or known.decimals < 0 else known.decimals


def pantograph_of(study: Study, output: str) -> str:
    """Return the pantographs that an output is of, in words; empty of one alone, or of none."""
    names = [placed.name for placed in study.base.pantographs]
    if len(names) < 2:  # noqa: PLR2004 - one pantograph needs no name
        return ""
    owners = {owner_of_key(key, study.base) for key in study.expressions[output].names}
    owners -= {None}
    return " and ".join(_pantograph(owner, names) for owner in sorted(owners, key=str))


def _pantograph(owner: int | str | None, names: list[str]) -> str:
    if not isinstance(owner, int):
        assert owner == WORST
        return f"worst of {len(names)} pantographs"
    place = {0: "leading pantograph", len(names) - 1: "trailing pantograph"}.get(
        owner, f"pantograph {owner + 1} of {len(names)}"
    )
    plain = names[owner] in (place.partition(" ")[0], f"P{owner + 1}")
    return place if plain else f"{place} ({names[owner]})"


def words_of(name: str, levels: Iterable[Any]) -> list[str]:
    """Return the values of a variable that are no numbers as words: groups by their places."""
    kinds = dict.fromkeys(map(_word, levels))
    texts = [level for level in levels if isinstance(level, str)]
    if len(texts) == len(kinds):
        return list(kinds)
    numbered = enumerate(kinds, start=1)
    groups = {_word(level) for level in levels if isinstance(level, dict | list | tuple)}
    return [f"{name} {number}" if word in groups else word for number, word in numbered]


def shortened(words: Iterable[str]) -> list[str]:
    """Return words that fit at an axis, still different from each other."""
    cut = [w if len(w) <= _LONGEST_WORD else w[: _LONGEST_WORD - 1] + "…" for w in words]
    return [f"{w} ({i + 1})" if cut.count(w) > 1 else w for i, w in enumerate(cut)]


def _word(value: Any) -> str:
    import json

    return value if isinstance(value, str) else json.dumps(value, ensure_ascii=False)
