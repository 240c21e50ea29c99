"""From the arguments of a command to a scenario."""

import warnings
from typing import TYPE_CHECKING, Annotated

import typer

from arcless.cli.completion import names
from arcless.cli.process.start import permanent_objects
from arcless.cli.terminal import console

if TYPE_CHECKING:
    from arcless.model import Scenario

ScenarioArgument = Annotated[
    str,
    typer.Argument(
        metavar="SCENARIO",
        help="The name of a shipped scenario, or a scenario file.",
        autocompletion=names.scenarios,
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
JsonOption = Annotated[
    bool, typer.Option("--json", help="Write JSON, and nothing else, to standard output.")
]


def load(
    name: str, *, speed: str | None = None, changes: list[str] | None = None, quiet: bool = False
) -> "Scenario":
    """Load a scenario, apply the changes of the command line, and print its warnings."""
    with permanent_objects(), warnings.catch_warnings():
        from arcless import model

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


def check_speed(scenario: "Scenario", file: str | None) -> None:
    """Refuse a speed without its unit that looks like one in km/h, before anything is computed."""
    from arcless.errors import ModelError
    from arcless.model.advice.speeds import check_typed_speed

    try:
        check_typed_speed(scenario)
    except ModelError as error:
        error.where = "--speed" if file is None else f"{file}: speed"
        raise
