"""Sentences of a study's report that page and paper have in common; between backticks is code."""

import shlex

from arcless.study.definition.study import Study
from arcless.study.folder.status import StudyStatus

SPEEDS = (
    "Wave speeds, and speeds at which spans or droppers pass at a natural frequency of the line or"
    " of a pantograph on it. They are computed from the line at rest. The figures over speed show"
    " the numbered ones. A peak is possible there, not certain. Sources: A, read in the source; D,"
    " from this program."
)
SOBOL = (
    "Sobol indices: the share of the variance of an output that a variable explains alone (first"
    " order), and together with its interactions (total)."
)
MORRIS = (
    "Elementary effects after Morris: the change of an output over the whole range of a variable,"
    " twice the change from one half of its levels to the other. The table has their mean, the"
    " mean of their magnitude, and their standard deviation, which is large if the effect depends"
    " on other variables."
)
INDICES = "Computed by SALib; ± is half of a 95 % bootstrap interval."
STOPS = (
    "pruned: the run was stopped because it could no longer become the best. Its values are those"
    " of the part of the section that it travelled; with a search for a mean force, those of the"
    " first run. These variants are in no figure, list or front of this report."
)
NO_BEST = "No variant meets the constraints."
LOWEST = "The lowest value of an output is not necessarily the best."


def judged(*, any_criterion: bool) -> str:
    """Return how variants are judged."""
    none = "" if any_criterion else " No output of this study is a quantity with a limit."
    return (
        "Each variant is judged by its own limits: those of the rules at its speed, mean force and"
        f" line.{none} A limit that was not checked in a source (marks C, C*, assumed) does not"
        " count: values beyond it are unverified, with the sign ?. A tolerance follows"
        ' its limit, as in "116.9 + 1 N"; a margin includes it.'
    )


def not_judged(titles: tuple[str, ...] | list[str]) -> str:
    """Return which criteria no output tells about; empty for none."""
    if not titles:
        return ""
    return (
        f"Not judged, because no output of this study provides them: {'; '.join(titles)}. Add the"
        " output `passed`, or `criteria.NAME` for one criterion, to judge all."
    )


def outputs_of(study: Study) -> str:
    """Return what the statistics of outputs are of."""
    once = ", each counted once; these are not probabilities"
    return f"Over the variants computed{once if study.design.kind in ('grid', 'list') else ''}."


def percentiles(status: StudyStatus) -> str:
    """Return what percentiles and their intervals mean."""
    others = " Variants without a value are not included."
    return (
        "Percentiles of the sample with their 95 % intervals from order statistics. For independent"
        " samples the interval contains the true percentile with at least this probability; a Latin"
        " hypercube or a Sobol sequence is usually more even. A dash means too few variants for a"
        f" bound.{others if status.done < status.total else ''}"
    )


def blocks(count: int, left_out: int, why: str) -> str:
    """Return how much of a design indices are of, and why there are none."""
    some = f"; {left_out} with a variant without a value are not included"
    none = f" No indices: {why}." if why else ""
    return f"{count} blocks of the design are complete{some if left_out else ''}.{none}"


def best(objectives: int) -> str:
    """Return of which variants the best are."""
    front = ": no other one is better in one objective and no worse in the rest"
    return f"Among the variants that meet the constraints{front if objectives > 1 else ''}."


def reasons(file: str | None) -> str:
    """Return what it means that a variant has no value."""
    again = f", `arcless study resume --retry-failed {file}` tries it again" if file else ""
    return f"invalid: the values give no valid scenario; failed: the computation failed{again}."


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
