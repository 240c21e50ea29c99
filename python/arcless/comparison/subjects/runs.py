"""Runs and measurements that are compared: read, checked, named, pantographs matched."""

import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TypeAlias

from arcless.errors import ComparisonError
from arcless.measurements import Measurement, is_measured, read
from arcless.results import RESULT_NAME, Result, run_file
from arcless.results import open as open_result
from arcless.units import show

Subject: TypeAlias = Result | Measurement
FEWEST = 2
# Most characters of a run's name in legends and heads of columns: two of them stand side by side in
# a terminal of 80 columns, and six in a legend. Runs with a longer one are numbered.
LONGEST_NAME = 28
# Characters of a measurement's name, which tells its file and its kind: heads of columns wrap it.
# Measurements with a longer one are numbered.
LONGEST_MEASURED = 56
MEASURED = "measured"


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


def opened(
    runs: Sequence[Subject | str | Path],
) -> tuple[list[Subject], list[Path | None]]:
    """Return runs and measurements, each read once, and the files of those that have one.

    Raises
    ------
    ComparisonError
        There are fewer than two, one is named twice, or one stopped early.
    ResultFormatError, MeasurementError
        A file is missing or damaged, or one is no run.
    """
    if len(runs) < FEWEST:
        raise ComparisonError(
            "runs to compare",
            got="one" if runs else "none",
            expected="at least two",
            hint="`arcless assess RUN` shows the numbers of one run",
        )
    files = [_file_of(one) for one in runs]
    refuse_twice([
        file.resolve() if isinstance(one, str | Path) and file is not None else id(one)
        for one, file in zip(runs, files, strict=True)
    ], [str(one) for one in runs])  # fmt: skip
    found: list[Subject] = []
    for one, file in zip(runs, files, strict=True):
        if isinstance(one, Result | Measurement):
            subject: Subject = one
        else:
            place = file or Path(one)
            subject = read(place) if is_measured(place) else open_result(place)
        if isinstance(subject, Result) and not subject.is_complete:
            raise ComparisonError(
                "run that stopped early",
                where=subject.scenario.name if file is None else str(file),
                expected="a finished run",
                hint="`arcless resume RUN` continues it",
            )
        found.append(subject)
    return found, files


def _file_of(one: Subject | str | Path) -> Path | None:
    if isinstance(one, Result):
        return None
    if isinstance(one, Measurement):
        return one.path
    return Path(one) if is_measured(Path(one)) else run_file(one)


def check_names(names: Sequence[str], count: int) -> None:
    """Refuse names that are not one for each of so many runs, or do not tell them apart.

    Raises
    ------
    ComparisonError
        They are none.
    """
    if len(names) == count == len({*names}) and all(names):
        return
    raise ComparisonError(
        "names of runs",
        got=", ".join(map(show, names)) or "none",
        expected=f"{count}, each another one",
    )


def names_of(
    subjects: Sequence[Subject],
    files: Sequence[Path | None],
    only_field: Sequence[str | None] | None,
) -> list[str]:
    """Return the name of each run and measurement, in full.

    That is the changed field, where just one differs; else the name of the scenario, or of the
    folder, whichever differs. A measurement has that of its file, and is said to be measured.

    Parameters
    ----------
    subjects, files
        Runs and measurements, and their files where they have some.
    only_field
        Text of the one field that differs, for each run; None where none or several do.
    """
    names = [_told(one) for one in subjects]
    folders = [None if file is None else _folder(file) for file in files]
    known = [folder for folder in folders if folder]
    if only_field is not None:
        names = [own or name for own, name in zip(only_field, names, strict=True)]
    elif len(set(names)) < len(names) and len(set(known)) == len(names):
        names = [
            name if isinstance(one, Measurement) else folder
            for one, name, folder in zip(subjects, names, known, strict=True)
        ]
    return [re.sub(r"[\r\n\t]+", " ", name) for name in names]


def short_names(names: Sequence[str], subjects: Sequence[Subject]) -> list[str]:
    """Return a name of each run for legends and heads, no two the same, none cut.

    Runs are ``run 1``, ``run 2`` where the name of one has more than `LONGEST_NAME` characters,
    measurements ``measured 2`` where that of one has more than `LONGEST_MEASURED`; they follow a
    number where two are the same.
    """
    kinds = [isinstance(one, Measurement) for one in subjects]
    longest = {False: LONGEST_NAME, True: LONGEST_MEASURED}
    numbered = {kind for kind, name in zip(kinds, names, strict=True) if len(name) > longest[kind]}
    words = {False: "run", True: MEASURED}
    found = [
        f"{words[kind]} {number}" if kind in numbered else name
        for number, (kind, name) in enumerate(zip(kinds, names, strict=True), start=1)
    ]
    if len(set(found)) < len(found):
        return [f"{number}: {name}" for number, name in enumerate(found, start=1)]
    return found


def _told(one: Subject) -> str:
    """Return the title, and of a measurement that it is one."""
    title = title_of(one)
    return f"{title} ({MEASURED})" if isinstance(one, Measurement) else title


def title_of(one: Subject) -> str:
    """Return the name of a run's scenario, or of a measurement's file."""
    return one.name if isinstance(one, Measurement) else one.scenario.name


def _pantographs(one: Subject) -> list[str]:
    if isinstance(one, Measurement):
        return [each.name for each in one.pantographs]
    return [str(name) for name in one.latest["pantograph"].values]


def matched(subjects: Sequence[Subject]) -> tuple[list[Slot], bool]:
    """Return the pantographs side by side, and whether that is by their names.

    Without a name that all have they are matched by their order.
    """
    named = [_pantographs(one) for one in subjects]
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


def refuse_twice(keys: Sequence[object], words: Sequence[str]) -> None:
    """Refuse two equal keys, by the words of the second one."""
    for place, key in enumerate(keys):
        if key in keys[:place]:
            raise ComparisonError(
                "run named twice", got=words[place], expected="each run once",
                hint="copy the result, if a run shall be compared with itself",
            )  # fmt: skip


def _folder(file: Path) -> str:
    """Return the name of the folder of a result, or of a file that is called otherwise."""
    return file.resolve().parent.name if file.name == RESULT_NAME else file.stem
