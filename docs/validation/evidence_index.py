"""The first page of the evidence: what is verified, what is not, and every topic in one line."""

from validation import evidence_reach
from validation.runs import escaped, table

from arcless.validate.evidence import GROUPS, INSIDE, Topic

NAME = "index"
# What each group compares with, for the first table.
AGAINST = {
    "closed_forms": "formulas of textbooks and papers, each derived or cited on its page",
    "orders": "the order that theory gives each wire model and each time-stepping scheme",
    "limits": "the same run with elements and steps refined until it no longer changes",
    "conservation": "balances of energy, force and mass; mirrored, moved and resumed runs",
    "peers": "Exudyn, scikit-fem, Drake and other programs that share no code",
    "references": "values that standards, papers and railways published",
}
HEAD = """# Validation

"""
NOT_VERIFIED = """## What is not verified

- **Measured runs.** The publications that we found leave out parts of the line, the pantograph or
  the instrument. `arcless compare` takes [your own measurement](../guide/compare-measured.md).
- **Limits and parameters of mark C or C\\*.** They are from memory or from secondary sources.
  Reports name them wherever they decide something.
- **Wear.** The form of the law is published; its [coefficients](../theory/wear.md) are not
  verified.
"""
HOW = """## How these pages are made

A check in `tests/verification` states what it measures, the reference value, the tolerance and
its reason. `make evidence` runs all checks and writes these pages. `make test` repeats the fast
ones and fails where a value has moved by more than a tenth of its tolerance. A *fault* is a
deliberate error in the model or the code, and counts only if a check notices it. *Most used* is
the largest part of a tolerance that a value of the topic takes. `arcless validate all` prints the
tables below.
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
    """Return the text of the first page: what is verified, how well, and what is not."""
    parts = [f"{HEAD}{_summary(topics)}", _overview(topics), _outside(topics)]
    parts += [f"{NOT_VERIFIED}{evidence_reach.still_not()}", evidence_reach.section(topics), HOW]
    for group, title in GROUPS.items():
        own = _of(topics, group)
        if own:
            parts.append(f"## [{title}]({page_name(group)}.md)\n\n{_table(own)}\n")
    return "\n".join([*parts, evidence_reach.topics_of(topics), TAIL])


def _of(topics: list[Topic], group: str) -> list[Topic]:
    return [topic for topic in topics if topic.group == group]


def _summary(topics: list[Topic]) -> str:
    found = evidence_reach.Counts.of(topics)
    versions = " and ".join(sorted({topic.version for topic in topics}))
    return (
        f"{found.values} values of version {versions} are compared with a reference; {found.inside}"
        f" are inside their tolerance, {found.values - found.inside} are outside and listed below."
        f" {found.faults} deliberate faults are noticed.\n"
    )


def _overview(topics: list[Topic]) -> str:
    rows = []
    for group, title in GROUPS.items():
        own = _of(topics, group)
        found = evidence_reach.Counts.of(own)
        name = f"[{title}]({page_name(group)}.md)"
        inside = f"{found.inside} of {found.values}"
        rows.append([name, AGAINST[group], inside, str(found.faults)])
    head = ["verified by", "against", "values inside", "faults noticed"]
    return f"## What is verified\n\n{table(head, rows)}\n"


def _outside(topics: list[Topic]) -> str:
    """Return the topics with values outside, each with the page that explains them."""
    rows = []
    for topic in topics:
        bad = [row for row in topic.rows if row.verdict != INSIDE]
        if bad:
            marks = ", ".join(sorted({escaped(row.mark) for row in bad if row.mark}))
            name = f"[{topic.title}]({page_name(topic.group)}.md)"
            rows.append([name, f"{len(bad)} of {len(topic.rows)}", marks])
    head = ["topic", "values outside", "marks of these references"]
    return f"## What disagrees\n\n{table(head, rows)}\n"


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
