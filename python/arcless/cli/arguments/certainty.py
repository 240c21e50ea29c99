"""The option `--certainty [N]`, whose number may be left out."""

import re
from typing import TYPE_CHECKING, Annotated, Any

import typer
from typer.core import TyperCommand

if TYPE_CHECKING:
    from arcless.model import Scenario

OPTION = "--certainty"
# Texts that may be meant as its number; any other text is the next argument.
_NUMBER = re.compile(r"[+-]?[\d.]")
CertaintyOption = Annotated[
    str | None,
    typer.Option(
        OPTION,
        metavar="[N]",
        help="Say how sure every number is: repeat the run from N starts within a span (8 if not"
        " named), and once with the other family of elements, refined.",
        show_default=False,
    ),
]


class WithCertainty(TyperCommand):
    """A command that takes the option without its number, too."""

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        """Write the number out where it was left out."""
        return super().parse_args(ctx, spelt_out(args))


def spelt_out(words: list[str]) -> list[str]:
    """Return the words of a command line with the number of every `--certainty`."""
    if OPTION not in words:  # the models are imported later, with no garbage looked for
        return words
    from arcless.model.settings.certainty import STARTS

    spelt = []
    for word, following in zip(words, [*words[1:], ""], strict=False):
        is_alone = word == OPTION and not _NUMBER.match(following)
        spelt += [f"{OPTION}={STARTS}"] if is_alone else [word]
    return spelt


def asked_for(scenario: "Scenario", starts: str | None) -> "Scenario":
    """Return the scenario with the certainty that the command line asks for."""
    if starts is None:
        return scenario
    from arcless.model.files.yaml_nodes import scalar
    from arcless.simulate.run import with_certainty

    return with_certainty(scenario, scalar(starts))


def number_of(starts: str | None, *, once: bool) -> int | None:
    """Return the number of starts for `arcless validate`; None to run each case once.

    Raises
    ------
    ModelError
        That is no number of starts, or both were asked for.
    """
    from arcless.errors import ModelError
    from arcless.model.files.yaml_nodes import scalar
    from arcless.model.settings.certainty import FEWEST_STARTS, MOST_STARTS, STARTS

    if once:
        if starts is None:
            return None
        expected = "one of them: what is run once does not say how sure it is"
        raise ModelError("not together with `--once`", where=OPTION, got=starts, expected=expected)
    number = STARTS if starts is None else scalar(starts)
    if type(number) is int and FEWEST_STARTS <= number <= MOST_STARTS:
        return number
    expected = f"a whole number from {FEWEST_STARTS} to {MOST_STARTS}"
    raise ModelError("number of starts", where=OPTION, got=f"`{starts}`", expected=expected)


def check_whole(starts: str | None, until: str | None) -> None:
    """Refuse to ask how sure the numbers of a run are that stops early, and so has none."""
    if starts is None or until is None:
        return
    from arcless.errors import ModelError

    raise ModelError(
        "not together with `--until`",
        where=OPTION,
        got=starts,
        expected="a run to its end: one that stops early has no numbers to be sure of",
        hint="put `certainty: 8` into the scenario; `arcless resume` then does it at the end",
    )
