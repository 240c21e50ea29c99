"""Records of the evidence: compared with a test's measurements, or renewed (`--publish`)."""

import re
from collections.abc import Container, Iterator
from contextlib import contextmanager
from dataclasses import replace
from fcntl import LOCK_EX, flock
from pathlib import Path
from types import ModuleType

import pytest

import arcless
from arcless.validate.evidence import Measurement, NoticedFault, Topic
from tests.support.faults import Fault
from tests.support.figures import draw

ROOT = Path(__file__).parents[2]
RECORDS = ROOT / "python" / "arcless" / "validate" / "recorded"
# Another processor or library may round differently. What moves by more than this share of its
# tolerance is not the value that the pages show.
DRIFT = 0.1
# What moves by less than this share is only rounding: the record stays.
STEADY = 0.01
# Unit of `Evidence.same`. With a channel more in the results more is compared, which is no finding;
# the record is true of the numbers it counts, and counts the others when it is written.
COUNT = re.compile(r"of (\d+) numbers")
PUBLISH = 'pytest -m "" --publish FILE'
AGAIN = f"run `make evidence`, or `{PUBLISH}`, and look at what changed"


def check_selection(publish: bool, markers: str, keywords: str) -> None:
    """Refuse to write records with -m or -k: what is left out would be missing, or of before."""
    if publish and (markers or keywords):
        left_out = f"-m '{markers}'" if markers else f"-k '{keywords}'"
        reason = f"--publish writes whole records, and {left_out} leaves tests out"
        raise pytest.UsageError(f"{reason}: run `{PUBLISH}`")


def place(file: Path) -> tuple[str, str]:
    """Group and topic of a test file in a folder of tests/verification."""
    return file.parent.name, file.stem.removeprefix("test_")


def path_of(group: str, name: str) -> Path:
    return RECORDS / group / f"{name}.json"


def load(group: str, name: str) -> Topic:
    """Read a record; an empty one if there is none yet."""
    file = path_of(group, name)
    if not file.is_file():
        return Topic(group, name)
    return Topic.from_json(file.read_text(encoding="utf-8"))


def measuring(module: pytest.Module) -> list[pytest.Function]:
    """Return the tests of a verification file that take the fixture `evidence`.

    The file is collected whole, whatever part of it is run: what none of these is called, no run
    of the file measures.
    """
    tests = [item for item in module.collect() if isinstance(item, pytest.Function)]
    return [test for test in tests if "evidence" in test.fixturenames]


def is_slow(test: pytest.Item) -> bool:
    """Return whether a test is left to `make evidence`."""
    return test.get_closest_marker("evidence") is not None


def publish_rows(
    file: Path, module: ModuleType, test: str, rows: list[Measurement],
    figures: list[dict[str, str]], *, tests: Container[str],
) -> None:  # fmt: skip
    """Replace what the record has of a test, and drop what it has of none of the file's `tests`."""
    with _own(file) as topic:
        topic.rows = [row for row in topic.rows if row.test in tests]
        _take_rows(topic, module, test, rows, figures)


def _take_rows(
    topic: Topic,
    module: ModuleType,
    test: str,
    rows: list[Measurement],
    figures: list[dict[str, str]],
) -> None:
    topic.title, _, text = (module.__doc__ or "").strip().partition("\n")
    topic.title, topic.text = topic.title.rstrip("."), text.strip()
    topic.version = arcless.__version__
    names = {figure["name"] for figure in figures}
    topic.rows = _replaced(topic.rows, test, _steady(rows, topic.rows), module)
    topic.figures = [f for f in topic.figures if f["name"] not in names]
    topic.figures += [
        {key: figure[key] for key in ("name", "title")}
        | {"file": draw(f"{topic.group}-{topic.name}-{figure['name']}", figure)}
        for figure in figures
    ]


def publish_fault(file: Path, faults: list[Fault], found: NoticedFault) -> None:
    """Replace what the record has of a fault, and drop what it has of faults that are gone."""
    with _own(file) as topic:
        _take_fault(topic, faults, found)


def _take_fault(topic: Topic, faults: list[Fault], found: NoticedFault) -> None:
    def steady(fault: NoticedFault) -> tuple[str | bool, ...]:
        allowed = fault.found.partition("; ")[2]
        return fault.fault, fault.row, allowed, fault.slow

    known = {fault.test: fault for fault in topic.faults}
    before = known.get(found.test)
    # What was found under a fault may vary; the record is kept while the tolerance beside it stays.
    if before is None or steady(before) != steady(found):
        known[found.test] = found
    topic.faults = [known[fault.name] for fault in faults if fault.name in known]


def compare_rows(file: Path, test: str, rows: list[Measurement]) -> None:
    """Fail if a test measures something else than what its record says."""
    known = {row.what: row for row in load(*place(file)).rows if row.test == test}
    assert known or not rows, f"no record of {test} yet: run `{PUBLISH}`"
    assert {row.what for row in rows} == set(known), f"not as recorded: {AGAIN}"
    for row in rows:
        _compare(row, known[row.what])


def compare_fault(file: Path, found: NoticedFault) -> None:
    """Fail if a fault is noticed by something else than what its record says."""
    known = [(fault.test, fault.row) for fault in load(*place(file)).faults]
    assert (found.test, found.row) in known, f"not as recorded: {AGAIN}"


def _compare(now: Measurement, then: Measurement) -> None:
    if _count(now) > _count(then) > 0:
        now = replace(now, unit=then.unit)
    changes = _changes(now, then, DRIFT)
    assert not changes, f"{now.what}: {'; '.join(changes)}: {AGAIN}"


def _count(row: Measurement) -> int:
    """Return how many numbers a row compares, bit by bit; 0 of other rows."""
    match = COUNT.fullmatch(row.unit)
    return int(match[1]) if match else 0


def _changes(now: Measurement, then: Measurement, share: float) -> list[str]:
    """Say what differs by more than a share of the tolerance."""
    changes = [
        f"{name} changed"
        for name in ("unit", "reason", "mark", "verdict", "test", "slow")
        if getattr(now, name) != getattr(then, name)
    ]
    room = share * _tolerance(then)
    for name in ("value", "reference", "low", "high"):
        one, other = getattr(now, name), getattr(then, name)
        differs = (one is None) != (other is None)
        if differs or (one is not None and not abs(one - other) <= room):
            changes.append(f"{name} {one!r}, was {other!r}")
    return changes


def _tolerance(row: Measurement) -> float:
    if row.low is not None and row.high is not None:
        return (row.high - row.low) / 2.0
    bound = row.high if row.high is not None else row.low
    return abs(bound or 0.0)


def _steady(rows: list[Measurement], known: list[Measurement]) -> list[Measurement]:
    """Keep the record of what only rounding moved, so that writing again changes no file."""
    before = {row.what: row for row in known}
    return [
        before[row.what]
        if row.what in before and not _changes(row, before[row.what], STEADY)
        else row
        for row in rows
    ]


def _replaced(
    known: list[Measurement], test: str, found: list[Measurement], module: ModuleType
) -> list[Measurement]:
    kept = [row for row in known if row.test != test]
    lines = {
        row.test: getattr(module, _function(row.test)).__code__.co_firstlineno
        for row in [*kept, *found]
    }
    # Sorting is stable: several rows of one test stay in their order.
    return sorted([*kept, *found], key=lambda row: (lines[row.test], row.test))


def _function(test: str) -> str:
    return test.partition("[")[0]


@contextmanager
def _own(file: Path) -> Iterator[Topic]:
    """Read the record of a test file and write it back; one process at a time does that."""
    group, name = place(file)
    path = path_of(group, name)
    path.parent.mkdir(parents=True, exist_ok=True)
    with (path.parent / ".lock").open("w") as lock:
        flock(lock, LOCK_EX)
        topic = load(group, name)
        yield topic
        path.write_text(topic.to_json(), encoding="utf-8")
