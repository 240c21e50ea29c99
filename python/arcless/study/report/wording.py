"""Sentences of a study's report that page and paper have in common; between backticks is code."""

import shlex

from arcless.study.definition.study import Study
from arcless.study.folder.status import StudyStatus

SPEEDS = (
    "Wave speeds, and speeds at which spans or droppers pass at a natural frequency of the line or"
    " of a pantograph on it; from the line at rest. Those with a number are drawn in the figures"
    " over speed. A peak is possible there, not certain. Sources: A, read there; D, from this"
    " program."
)
SOBOL = (
    "Sobol indices: the share of an output's variance that a variable explains by itself (first"
    " order), and with all that it has in common with others (total)."
)
MORRIS = (
    "Morris' elementary effects: how much an output changes over all of a variable's range, from"
    " one half of its levels to the other, twice that step; their mean, their mean size, and their"
    " deviation, which is large where other variables matter to the effect."
)
INDICES = "By SALib; ± is half of a 95 % interval (bootstrap)."
STOPS = (
    "pruned: the run was stopped as it could not become good any more. Values so far are of the"
    " part of the section that was travelled, of a search for a mean force in its first run. These"
    " variants are in no figure, list or front of this report."
)
NO_BEST = "No variant keeps the constraints."
LOWEST = "The lowest value of an output is not necessarily the best."


def judged(*, any_criterion: bool) -> str:
    """Return how variants are judged."""
    none = "" if any_criterion else " No output of this study is a quantity with a limit."
    return (
        "Each variant is judged by its own limits: from the rules at its speed, its mean force, and"
        f" its line.{none} A limit that was not checked in a source (marks C, C*, assumed) does not"
        " count: values beyond it are unverified, with the sign ?. A tolerance stands"
        ' behind its limit, as in "116.9 + 1 N"; a margin has it in it.'
    )


def not_judged(titles: tuple[str, ...] | list[str]) -> str:
    """Return which criteria no output tells about; empty for none."""
    if not titles:
        return ""
    return (
        f"Not judged, as no output of this study has them: {'; '.join(titles)}. Add the output"
        " `passed`, or `criteria.NAME` for one criterion, to judge all."
    )


def outputs_of(study: Study) -> str:
    """Return what the statistics of outputs are of."""
    once = ", each counted once; these are not probabilities"
    return f"Over the variants computed{once if study.design.kind in ('grid', 'list') else ''}."


def percentiles(status: StudyStatus) -> str:
    """Return what percentiles and their intervals mean."""
    others = " Variants without a value are left out: the percentiles are those of the others."
    return (
        "Percentiles of the sample, and below them the 95 % interval that the number of variants"
        " leaves, by order statistics: of independent draws it holds the true percentile at least"
        " that often; a Latin hypercube or a Sobol sequence is at least as even as a rule. A dash:"
        f" too few variants for a bound.{others if status.done < status.total else ''}"
    )


def blocks(count: int, left_out: int, why: str) -> str:
    """Return how much of a design indices are of, and why there are none."""
    some = (
        f"; {left_out} with a variant that has no value are left out: the indices are those of the"
        " others"
    )
    none = f" No indices: {why}." if why else ""
    return f"{count} blocks of the design are whole{some if left_out else ''}.{none}"


def best(objectives: int) -> str:
    """Return of which variants the best are."""
    front = ": none of the others is better in one objective and no worse in the rest"
    return f"Of those that keep the constraints{front if objectives > 1 else ''}."


def reasons(file: str | None) -> str:
    """Return what it means that a variant has no value."""
    again = f", `arcless study resume --retry-failed {file}` tries it again" if file else ""
    return (
        "invalid: the values make no scenario that can be computed; failed: the computation"
        f" failed{again}."
    )


def again(file: str | None) -> str:
    """Return the commands that compute a study again; empty for one without a file."""
    if not file:
        return ""
    name = shlex.quote(file)
    return (
        f"arcless study run {name} --out NEW_FOLDER\n"
        f"arcless study variant {name} NUMBER --to variant.yaml"
        "   # any variant, as `arcless run` takes it"
    )
