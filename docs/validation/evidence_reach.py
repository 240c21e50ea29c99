"""Reach of the evidence: lines in space, contacts that move, a pantograph behind another one."""

from dataclasses import dataclass

from validation.runs import table

from arcless.validate.evidence import Topic

HEAD = """## In space, under motion, behind another pantograph

How far the checks reach in the uses that matter most. The topics of each row are listed
[at the end](#topics-of-these-uses).
"""


@dataclass(frozen=True)
class Reach:
    """One question to the evidence.

    Attributes
    ----------
    where : what is verified
    topics : the topics of the evidence that do it, each as GROUP/NAME of its record
    shown : what they show
    still_not : what none of them shows
    """

    where: str
    topics: tuple[str, ...]
    shown: str
    still_not: str


@dataclass(frozen=True)
class Counts:
    """How many values some topics have, how many of them are inside, and how many faults."""

    values: int
    inside: int
    faults: int

    @classmethod
    def of(cls, topics: list[Topic]) -> "Counts":
        """Count what the topics have."""
        return cls(
            sum(len(topic.rows) for topic in topics),
            sum(topic.inside for topic in topics),
            sum(len(topic.faults) for topic in topics),
        )


MOVING = tuple(f"closed_forms/moving_{name}" for name in ("kink", "head", "stiffness", "pair"))
REACHES = (
    Reach(
        "a line in space, at rest",
        ("conservation/staggered_line", "closed_forms/curve", "closed_forms/bands",
         "closed_forms/opposed_stagger", "closed_forms/parting_wires",
         "closed_forms/parting_wires_on_droppers", "peers/exudyn_space_statics"),
        "arms are springs of force over length; wires in curves; stagger compared with the planar"
        " line; opposed staggers; two contact wires that part and meet; another program's line",
        "published elasticities of a line with stagger",
    ),
    Reach(
        "a line in space, under motion",
        ("closed_forms/moving_on_stagger", "closed_forms/bands", "conservation/rolling_head",
         "conservation/mirror", "limits/shipped_scenarios", "peers/exudyn_space_run"),
        "closed forms of the plane hold with stagger while the wire swings aside, at 275 and"
        " 320 km/h; bands on hinged arms; energy with a head that rolls; another program's run",
        "arms that turn far from where they are at rest; a wire"
        " with stagger whose tension changes; a measured run",
    ),
    Reach(
        "a contact that moves",
        (*MOVING, "closed_forms/bands", "closed_forms/superposed_kinks", "closed_forms/doppler",
         "closed_forms/moving_force_string", "closed_forms/moving_force_beam",
         "closed_forms/explicit_moving_force", "peers/exudyn_run"),
        "kink, thrown head, head on a spring, stiffness and trapped mode, waves on springs, each"
        " over element length, at two speeds and by both families; another program's run",
        "droppers that go slack, in a closed form that does not take their forces from the run",
    ),
    Reach(
        "behind another pantograph",
        ("closed_forms/moving_pair", "closed_forms/moving_on_stagger", "conservation/far_apart",
         "limits/pairs", "references/spacing", "references/wake", "peers/exudyn_space_run"),
        "what the trailing one feels and when, on one wire, also with stagger; shipped lines"
        " against the limit; the trend over the spacing, and what one pantograph alone predicts of"
        " it; another program's run with two",
        "a measured trailing pantograph",
    ),
)  # fmt: skip


def section(topics: list[Topic]) -> str:
    """Return the section; a topic that is not recorded is an error."""
    rows = []
    for reach in REACHES:
        own = Counts.of(_own(reach, topics))
        rows.append([reach.where, reach.shown, str(own.values), str(own.faults)])
    return f"{HEAD}\n{table(['', 'verified by', 'values', 'faults noticed'], rows)}\n"


def still_not() -> str:
    """Return a list of what no topic of each use shows."""
    return "".join(f"- **{reach.where.capitalize()}**: {reach.still_not}.\n" for reach in REACHES)


def topics_of(topics: list[Topic]) -> str:
    """Return the section that lists the topics behind each use."""
    lines = []
    for reach in REACHES:
        titles = dict.fromkeys(topic.title.partition(",")[0] for topic in _own(reach, topics))
        lines.append(f"- **{reach.where.capitalize()}**: {'; '.join(titles)}")
    return "## Topics of these uses\n\n" + "\n".join(lines) + "\n"


def _own(reach: Reach, topics: list[Topic]) -> list[Topic]:
    known = {f"{topic.group}/{topic.name}": topic for topic in topics}
    return [known[name] for name in reach.topics]
