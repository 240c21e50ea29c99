"""From the arguments of a command to a scenario."""

import warnings
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from arcless.cli.completion import names
from arcless.cli.process.start import permanent_objects
from arcless.cli.terminal import console

if TYPE_CHECKING:
    from arcless.model import Line, Scenario

ScenarioArgument = Annotated[
    str,
    typer.Argument(
        metavar="SCENARIO",
        help="The name of a shipped scenario, or a scenario file.",
        autocompletion=names.scenarios,
        show_default=False,
    ),
]
AtRestArgument = Annotated[
    str,
    typer.Argument(
        metavar="SCENARIO",
        help="A shipped scenario or line, or a file of either. Where both have the name it is the"
        " scenario; line/NAME means the line.",
        autocompletion=names.lines,
        show_default=False,
    ),
]
SpeedOption = Annotated[
    str | None,
    typer.Option("--speed", metavar="SPEED", help='Another speed, such as "300 km/h".'),
]
SetOption = Annotated[
    list[str] | None,
    typer.Option(
        "--set",
        metavar="FIELD=VALUE",
        help='Another value for any field, such as "line.contact_wire.tension=24 kN" or '
        '"pantographs.0.mean_force=150 N". May be repeated.',
    ),
]
QuietOption = Annotated[
    bool, typer.Option("--quiet", help="No progress, notes or warnings on standard error.")
]
AllowFmuOption = Annotated[
    bool,
    typer.Option(
        "--allow-fmu",
        help="Let pantographs that are FMUs run: their code has all rights that you have.",
    ),
]
JsonOption = Annotated[
    bool, typer.Option("--json", help="Write JSON, and nothing else, to standard output.")
]


def load(
    name: str, *, speed: str | None = None, changes: list[str] | None = None, quiet: bool = False
) -> "Scenario":
    """Load a scenario, apply the changes of the command line, and print its warnings."""
    with permanent_objects(), warnings.catch_warnings():
        from arcless import model
        from arcless.model.advice.speeds import check_speed

        if quiet:
            warnings.simplefilter("ignore", model.ModelRenamed)
        scenario = model.load(name)
    overrides = dict(model.parse_override(text) for text in changes or [])
    if speed is not None:
        overrides["speed"] = speed
    if overrides:
        scenario = scenario.with_(**overrides)
    check_speed(scenario, name if speed is None else None)
    if not quiet:
        for warning in model.scenario_warnings(scenario):
            console.warn(warning)
    return scenario


def load_at_rest(
    name: str, *, changes: list[str] | None = None, quiet: bool = False
) -> "Scenario | Line":
    """Load a scenario or a line, apply the changes of the command line, print its warnings."""
    with permanent_objects():
        from arcless import model
        from arcless.model.scenario.overrides import apply_to_line
        from arcless.model.shipped.library import shipped

    own = name.removeprefix("line/")
    is_line = own in shipped("line") and (own != name or own not in shipped("scenario"))
    if not is_line and _is_line_file(name):
        own, is_line = name, True
    if not is_line:
        return load(name.removeprefix("scenario/"), changes=changes, quiet=quiet)
    line = model.load_line(own)
    overrides = dict(model.parse_override(text) for text in changes or [])
    line = apply_to_line(line, overrides) if overrides else line
    for warning in [] if quiet else model.line_warnings(line):
        console.warn(warning)
    return line


def line_of(chosen: "Scenario | Line") -> "Line":
    """Return the line of a scenario, or a line itself."""
    from arcless.model import Scenario

    return chosen.line if isinstance(chosen, Scenario) else chosen


def _is_line_file(name: str) -> bool:
    """Return whether a file is that of a line; anything else is looked at as a scenario."""
    from arcless.errors import ModelError
    from arcless.model.files.yaml_reader import is_file, parse, read_text

    if not is_file(Path(name)):
        return False
    try:
        given = parse(read_text(Path(name), name), name)[0].get("format")
    except ModelError:
        return False
    return isinstance(given, str) and given.startswith("arcless-line/")
