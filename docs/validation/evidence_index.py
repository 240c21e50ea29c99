"""The first page of the evidence: every topic in one line."""

from validation import evidence_reach
from validation.runs import table

from arcless.validate.evidence import GROUPS, Topic

NAME = "index"
HEAD = """# Why the numbers can be trusted

What stands here was written by the tests. A check in `tests/verification` says what it measured,
what that must be, how far it may be off and why; `make evidence` runs all checks and writes these
pages, `make test` compares what it measures with them and fails where they differ by more than a
tenth of a tolerance. Below the checks of each file stands a table of faults: one thing broken on
purpose, and the check that must notice it. `arcless validate all` prints the table below,
`arcless validate all --report FILE.html` has it on a page, after the values in their ranges.

*Most used* is the largest part of a tolerance that any value of the topic uses up. *Faults* counts
what was broken on purpose and noticed.
"""
TAIL = """## Pages with tables of runs

Longer studies, each with its own text:

- [EN 50318:2002](en50318-2002.md), [AC simple](ac-simple.md), [PRAKS](praks.md): published cases
- [AC simple in space, in two programs](in-space.md): both families of elements, and those of Exudyn
- [Convergence](convergence.md) and [of the published method](convergence-published.md)
- [Modelling choices](modelling-choices.md)
- [Energy](energy.md)
- [Shipped lines](lines.md), [library](library.md)
- [Two pantographs on every line](spacing.md)

## What else is tested

- [Hostile input](hostile-input.md): random and damaged models, fuzzing of the core
- [Failure drills](failure-drills.md): killed, interrupted, out of disk
- [Broken on purpose](core-faults.md): changes of the core's source that the checks must notice
"""


def page_name(group: str) -> str:
    """Name of the page of a group."""
    return group.replace("_", "-").replace("peers", "other-programs")


def page(topics: list[Topic]) -> str:
    """Return the text of the first page."""
    versions = " and ".join(sorted({topic.version for topic in topics}))
    counts = f"{sum(len(topic.rows) for topic in topics)} values in {len(topics)} topics"
    parts = [f"{HEAD}\nRecorded with version {versions}: {counts}.\n"]
    parts.append(f"{evidence_reach.section(topics)}\n")
    for group, title in GROUPS.items():
        own = [topic for topic in topics if topic.group == group]
        if own:
            parts.append(f"## [{title}]({page_name(group)}.md)\n\n{_table(own)}\n")
    return "\n".join([*parts, TAIL])


def _table(topics: list[Topic]) -> str:
    return table(
        ["topic", "values", "inside", "most used", "faults"],
        [
            [
                topic.title,
                str(len(topic.rows)),
                str(topic.inside),
                "" if topic.most_used is None else f"{100 * topic.most_used:.0f} %",
                str(len(topic.faults)),
            ]
            for topic in topics
        ],
    )
