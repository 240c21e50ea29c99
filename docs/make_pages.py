"""Write what is generated in the pages: `python docs/make_pages.py [--check] [--all] [PAGE …]`.

Without PAGE, those parts of all pages that take seconds; with `--all` also those from runs, half an
hour of processor time. `--check` writes nothing, says what is out of date, and then exits with 1.
A PAGE is named as below docs and without its ending, `validation/lines`: all its parts are made.
"""

import argparse
import sys
from collections.abc import Callable, Iterator
from concurrent.futures import ProcessPoolExecutor
from functools import partial
from itertools import chain
from pathlib import Path

sys.path.append(str(Path(__file__).parents[1]))  # the mutations of tests/faults

from fragments import DOCS, Fragment, changes, names, path_of, put
from guide import damping, examples, line_types, messages, speed_marks
from reference import names as required
from reference import tables
from theory import readings
from validation import (
    adif,
    choices,
    conclusions,
    converging,
    core_faults,
    evidence,
    library,
    mid_span,
    praks,
    praks_in_space,
    published,
    shipped,
    spacing,
    spacing_lines,
    two_programs,
)

Makers = dict[str, dict[str, Callable[[], str]]]


def _of(
    folder: str, makers: Makers, *, slow: bool = False, computed: bool = True
) -> Iterator[Fragment]:
    for page, parts in makers.items():
        for name, make in parts.items():
            yield Fragment(f"{folder}{page}", name, make, slow, computed)


FRAGMENTS = [
    *_of("", tables.QUICK, computed=False),
    *_of("guide/", {"damping": damping.QUICK} | examples.QUICK, computed=False),
    *_of("guide/", line_types.QUICK | speed_marks.QUICK),
    *_of("guide/", {"damping": damping.SLOW} | line_types.SLOW | examples.SLOW, slow=True),
    *_of("theory/", readings.QUICK),
    *_of("theory/", readings.SLOW, slow=True),
    *_of("validation/", core_faults.QUICK, computed=False),
    *_of("validation/", two_programs.QUICK, computed=False),
    *_of("validation/", {"library": library.QUICK}, computed=False),
    *_of("validation/", published.QUICK),
    *_of("validation/", published.SLOW, slow=True),
    *_of("validation/", {
        "library": library.SLOW,
        "lines": shipped.TABLES | adif.TABLES | mid_span.TABLES | spacing.TABLES,
        "spacing": spacing_lines.TABLES,
        "modelling-choices": choices.TABLES,
        "convergence-published": converging.TABLES,
        "praks": praks.TABLES | praks_in_space.TABLES,
    }, slow=True),
]  # fmt: skip


def whole_pages() -> dict[str, str]:
    """Return the text of each page that is generated from its first to its last line."""
    return {"guide/messages": messages.page()} | {
        f"validation/{page}": text for page, text in evidence.pages().items()
    }


def renewed(numbers: list[int], *, check: bool) -> list[str]:
    """Write fragments of one page, by their numbers, or say what differs."""
    said = []
    for part in (FRAGMENTS[number] for number in numbers):
        print(f"{part.page}: {part.name}", file=sys.stderr, flush=True)
        text = part.made()
        said += [f"{part.page}, {part.name}: {t}" for t in changes(part.printed(), text)]
        if not check:
            put(part.page, part.name, text)
    return said if check else []


def places() -> Iterator[str]:
    """Say which page has a place for no fragment."""
    for path in sorted(DOCS.rglob("*.md")):
        page = path.relative_to(DOCS).with_suffix("").as_posix()
        known = {part.name for part in FRAGMENTS if part.page == page}
        yield from (f"{page}: nothing makes {name}" for name in set(names(page)) - known)


def main() -> int:
    """Write or check pages; return the exit code."""
    asked = argparse.ArgumentParser(description=__doc__)
    asked.add_argument("pages", nargs="*", metavar="PAGE")
    asked.add_argument("--check", action="store_true")
    asked.add_argument("--all", action="store_true")
    given = asked.parse_args()
    by_page: dict[str, list[int]] = {}
    for number, part in enumerate(FRAGMENTS):
        if part.page in given.pages if given.pages else given.all or not part.slow:
            by_page.setdefault(part.page, []).append(number)
    if unknown := set(given.pages) - set(by_page):
        whole = sorted(unknown & set(whole_pages()))
        if whole:
            asked.error(f"{', '.join(whole)}: made as a whole; give no PAGE to write all of these")
        asked.error(f"nothing is generated in {', '.join(sorted(unknown))}")
    work = partial(renewed, check=given.check)
    # Each page in a process of its own, which keeps the runs that its tables share.
    if given.all or given.pages:
        with ProcessPoolExecutor() as pool:
            said = list(chain.from_iterable(pool.map(work, by_page.values())))
    else:
        said = list(chain.from_iterable(map(work, by_page.values())))
    for page, text in {} if given.pages else whole_pages().items():
        path = path_of(page)
        printed = path.read_text(encoding="utf-8") if path.exists() else ""
        if not given.check:
            path.write_text(text, encoding="utf-8")
        else:
            said += [f"{page}: {t}" for t in changes(printed, text)]
    said += [*places(), *required.complaints(), *conclusions.complaints()]
    for text in said:
        print(f"make pages: {text}", file=sys.stderr)
    return int(bool(said))


if __name__ == "__main__":
    sys.exit(main())
