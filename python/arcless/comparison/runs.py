"""Runs that are compared: read, checked, called by what distinguishes them, pantographs matched."""

import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from arcless.errors import ComparisonError
from arcless.results import RESULT_NAME, Result, run_file
from arcless.results import open as open_result

FEWEST = 2
# Most characters of a run's name in legends and columns.
LONGEST_NAME = 48


@dataclass(frozen=True)
class Slot:
    """One pantograph of the comparison.

    Attributes
    ----------
    name
        Its name; where the runs call it differently, all names.
    places
        Its number in each run, from 0; None for a run without it.
    """

    name: str
    places: tuple[int | None, ...]


def opened(runs: Sequence[Result | str | Path]) -> tuple[list[Result], list[Path | None]]:
    """Return the runs, each read once, and the files of those that were named by their place.

    Raises
    ------
    ComparisonError
        There are fewer than two, one is named twice, or one stopped early.
    ResultFormatError
        A file is missing or damaged, or one is no run.
    """
    if len(runs) < FEWEST:
        raise ComparisonError(
            "runs to compare",
            got="one" if runs else "none",
            expected="at least two",
            hint="`arcless assess RUN` shows the numbers of one run",
        )
    files = [None if isinstance(one, Result) else run_file(one) for one in runs]
    _refuse_twice([
        id(one) if file is None else file.resolve() for one, file in zip(runs, files, strict=True)
    ], [str(one) for one in runs])  # fmt: skip
    found = []
    for one, file in zip(runs, files, strict=True):
        result = one if isinstance(one, Result) else open_result(file or one)
        if not result.is_complete:
            raise ComparisonError(
                "run that stopped early",
                where=result.scenario.name if file is None else str(file),
                expected="a finished run",
                hint="`arcless resume RUN` goes on with it",
            )
        found.append(result)
    return found, files


def names_of(
    results: Sequence[Result], files: Sequence[Path | None], only_field: Sequence[str] | None
) -> list[str]:
    """Return a short name of each run, no two the same.

    That is the changed field, where just one differs; else the name of the scenario, or of the
    folder, whichever differs; else both are followed by a number.

    Parameters
    ----------
    results, files
        The runs, and their files where they have some.
    only_field
        Text of the one field that differs, for each run; None where none or several do.
    """
    names = [one.scenario.name for one in results]
    folders = [None if file is None else _folder(file) for file in files]
    known = [folder for folder in folders if folder]
    if only_field is not None:
        names = list(only_field)
    elif len(set(names)) < len(names) and len(set(known)) == len(names):
        names = known
    return _told_apart([re.sub(r"[\r\n\t]+", " ", name) for name in names])


def matched(results: Sequence[Result]) -> tuple[list[Slot], bool]:
    """Return the pantographs side by side, and whether that is by their names.

    Without a name that all runs have they are matched by their order.
    """
    named = [[str(name) for name in one.latest["pantograph"].values] for one in results]
    common = set(named[0]).intersection(*named[1:])
    if common:
        every = list(dict.fromkeys(name for names in named for name in names))
        return [
            Slot(name, tuple(names.index(name) if name in names else None for names in named))
            for name in every
        ], True
    slots = []
    for place in range(max(map(len, named))):
        here = [names[place] for names in named if place < len(names)]
        places = tuple(place if place < len(names) else None for names in named)
        slots.append(Slot(" / ".join(dict.fromkeys(here)), places))
    return slots, False


def _refuse_twice(keys: Sequence[object], words: Sequence[str]) -> None:
    for place, key in enumerate(keys):
        if key in keys[:place]:
            raise ComparisonError(
                "run named twice", got=words[place], expected="each run once",
                hint="copy the result, if a run shall be compared with itself",
            )  # fmt: skip


def _folder(file: Path) -> str:
    """Return the name of the folder of a result, or of a file that is called otherwise."""
    return file.resolve().parent.name if file.name == RESULT_NAME else file.stem


def _told_apart(names: Sequence[str]) -> list[str]:
    cut = [n if len(n) <= LONGEST_NAME else n[: LONGEST_NAME - 1] + "…" for n in names]
    if len(set(cut)) == len(cut):
        return cut
    return [f"{number}: {name}" for number, name in enumerate(cut, start=1)]
