"""Result file → the run in a few words.

The numbers are those of the assessment.json next to the file where that is the assessment of this
very result by this version; else they are computed from the result, which takes longer.
"""

import hashlib
import json
from collections import defaultdict
from collections.abc import Mapping
from dataclasses import fields
from datetime import UTC, datetime
from importlib.metadata import version
from pathlib import Path
from typing import Any

from arcless.assess import (
    MET,
    NOT_JUDGED,
    NOT_MET,
    NOT_MET_UNVERIFIED,
    TOO_CLOSE,
    assess,
    decides,
    is_withheld,
    verdict_of,
)
from arcless.dataset.netcdf.store import UNREADABLE as DAMAGE
from arcless.dataset.netcdf.store import open_plain, read_facts
from arcless.errors import ArclessError
from arcless.model.scenario.as_typed import changes_of
from arcless.results.kept_runs.kept_run import (
    STOPPED,
    UNREADABLE,
    KeptRun,
    MainNumbers,
    Verdict,
)
from arcless.results.kept_runs.places import ASSESSMENT_NAME, RESULT_NAME

# Criteria that could be compared, and are not judged: see `is_withheld`.
WITHHELD = "withheld"
# Head of the criteria whose limits were not read in a source.
UNVERIFIED = "beyond a limit that is not verified"
# Time in s after the result within which its assessment is written. Longer, one that was edited
# soon after is believed; shorter, slow ones are assessed at each listing.
WRITTEN_TOGETHER_S = 60.0
# A hundred times the largest of a run of many pantographs; a larger file is another one.
_MOST_BYTES = 10_000_000
# Keys of an assessment → attributes of the result, that both take over from the run. The wall time
# alone, measured to the nanosecond, hardly ever comes twice.
_SHARED = {
    "scenario": "scenario_name",
    "version": "arcless_version",
    "section_m": "section_m",
    "steps": "steps",
    "setup_time_s": "setup_time_s",
    "wall_time_s": "wall_time_s",
    "real_time_factor": "real_time_factor",
    "slack_droppers_max": "slack_droppers_max",
    "energy_residual_relative": "energy_residual_relative",
}
# Fields of a line that change no number.
_NO_CONTENT = ("description", "sources", "provenance")
# Hexadecimal digits of a digest: by chance two of 1000 lines meet once in 10 000 times.
_DIGITS = 8
_NUMBERS = tuple(each.name for each in fields(MainNumbers))


def read(file: Path) -> KeptRun:
    """Return a run in a few words, whatever the file is: one that cannot be read says why."""
    path = file.parent if file.name == RESULT_NAME else file
    try:
        return _described(path, file, read_facts(file))
    except ArclessError as error:
        return unreadable(path, _without_place(error))
    except DAMAGE as error:
        return unreadable(path, f"damaged: {type(error).__name__}: {error}".partition("\n")[0])


def unreadable(path: Path, reason: str) -> KeptRun:
    """Return the entry of what cannot be read."""
    try:
        changed = datetime.fromtimestamp(path.stat().st_mtime, UTC)
        created: str | None = changed.isoformat(timespec="seconds")
    except OSError:
        created = None
    return KeptRun(path, UNREADABLE, reason, created=created)


def _described(path: Path, file: Path, facts: Mapping[str, Any]) -> KeptRun:
    known: dict[str, Any] = {
        "name": facts["scenario_name"],
        "created": facts["created"],
        "version": facts["arcless_version"],
        "line": facts["scenario"]["line"]["name"],
        "line_digest": _digest(facts["scenario"]["line"]),
        "changes": changes_of(facts["scenario"]),
    }
    state = facts["state"]
    if state is not None:
        where = f"at {state['position_m']:.2f} m, {facts['simulated_time_s']:g} s"
        return KeptRun(path, STOPPED, where, **known)
    found = _kept_numbers(file, facts)
    numbers = _numbers(assess(open_plain(file)).to_dict()) if found is None else found
    return KeptRun(path, **numbers, **known)


def _digest(line: Mapping[str, Any]) -> str:
    """Return a digest of what a line says, without where its values come from."""
    told = {key: value for key, value in line.items() if key not in _NO_CONTENT}
    text = json.dumps(told, sort_keys=True, ensure_ascii=True)
    return hashlib.sha256(text.encode()).hexdigest()[:_DIGITS]


def _numbers(assessment: Mapping[str, Any]) -> dict[str, Any]:
    verdict, reason = judged(assessment["criteria"])
    return {
        "verdict": verdict,
        "reason": reason,
        "speed_m_s": assessment["speed_m_s"],
        "pantographs": tuple(
            MainNumbers(**{key: one[key] for key in _NUMBERS}) for one in assessment["pantographs"]
        ),
        "max_uplift_at_support_mm": assessment["max_uplift_at_support_mm"],
    }


def judged(criteria: list[dict[str, Any]]) -> tuple[Verdict, str | None]:
    """Return the verdict over all criteria, and those of which there is more to say.

    Criteria too close to tell count as met, as in `Assessment.passed`. Where a number could have
    been compared with a limit that decides and is not judged, the run is not judged.
    """
    titles: dict[str, list[str]] = defaultdict(list)
    several = len({one["pantograph"] for one in criteria} - {None}) > 1
    for one in criteria:
        of = f" ({one['pantograph']})" if several and one["pantograph"] else ""
        word = WITHHELD if is_withheld(one) else verdict_of(one)
        titles[word].append(f"{one['title']}{of}")
    decided = any(decides(one["mark"]) and verdict_of(one) in (MET, TOO_CLOSE) for one in criteria)
    withheld = [one for one in criteria if is_withheld(one)]
    decided &= not any(decides(one["mark"]) for one in withheld)
    verdict: Verdict = "met" if decided else "not judged"
    heads = {
        NOT_MET: "", NOT_MET_UNVERIFIED: f"{UNVERIFIED}: ", TOO_CLOSE: f"{TOO_CLOSE}: ",
        WITHHELD: f"{NOT_JUDGED}: ",
    }  # fmt: skip
    parts = [f"{head}{', '.join(titles[word])}" for word, head in heads.items() if titles[word]]
    return "not met" if titles[NOT_MET] else verdict, "; ".join(parts) or None


def _kept_numbers(file: Path, facts: Mapping[str, Any]) -> dict[str, Any] | None:
    """Return the numbers of the assessment next to a result; None where it is another one's.

    It is of this result where it is not older nor changed later, and all that both took over from
    the run is the same; of its own section and filter, where these are those of the scenario; by
    these criteria, where this version computed the run.
    """
    beside = file.with_name(ASSESSMENT_NAME)
    if file.name != RESULT_NAME or facts["arcless_version"] != version("arcless"):
        return None
    try:
        state = beside.stat()
        if state.st_size > _MOST_BYTES or state.st_mtime < file.stat().st_mtime:
            return None
        if state.st_mtime > file.stat().st_mtime + WRITTEN_TOGETHER_S:
            return None
        given = json.loads(beside.read_bytes())
        own = {key: facts[attribute] for key, attribute in _SHARED.items()}
        own["low_pass_Hz"] = facts["scenario"]["analysis"]["low_pass"]
        own["band_split_Hz"] = facts["scenario"]["analysis"]["band_split"]
        if any(given[key] != value for key, value in own.items()):
            return None
        return _numbers(given)
    except (OSError, ValueError, LookupError, TypeError, AttributeError, RecursionError):
        return None  # missing, or no assessment


def _without_place(error: ArclessError) -> str:
    """Return the message of an error in short, without the file, which the entry names."""
    fact = error.got or error.expected
    return f"{error.what}: {fact}" if fact else error.what
