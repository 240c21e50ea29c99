"""`arcless fmu`: lines and pantographs for other programs."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

import typer

from arcless.cli.arguments.scenario import (
    JsonOption,
    QuietOption,
    ScenarioArgument,
    SetOption,
    SpeedOption,
    load,
)
from arcless.cli.terminal import console

if TYPE_CHECKING:
    from arcless.fmi.export.export import Export

app = typer.Typer(rich_markup_mode=None, add_completion=False, no_args_is_help=True)


@app.callback()
def fmu() -> None:
    """Write lines and pantographs for other programs: FMUs, and models of the C interface."""


@app.command()
def export(
    name: ScenarioArgument,
    *,
    out: Annotated[
        Path,
        typer.Option(
            "--out",
            metavar="FILE",
            help="The file to write: NAME.fmu, or NAME.loop for the C interface; one that exists is"
            " replaced.",
            show_default=False,
        ),
    ],
    fmi: Annotated[
        Literal["2", "3"] | None,
        typer.Option("--fmi", help="Version of the FMI: 2.0 or 3.0; 2 if not named."),
    ] = None,
    given: Annotated[
        Literal["contact-force", "strip-height", "control-force"] | None,
        typer.Option(
            "--given",
            help="Inputs of the line: contact forces, heights of strips, or controlled forces of "
            "pantographs simulated inside; contact-force if not named.",
        ),
    ] = None,
    travel: Annotated[
        Literal["position", "speed"],
        typer.Option("--travel", help="Input that moves the pantographs along the track."),
    ] = "speed",
    pantograph: Annotated[
        str | None,
        typer.Option(
            "--pantograph",
            metavar="NAME",
            help="The pantograph alone instead of the line; contact forces are its inputs.",
            show_default=False,
        ),
    ] = None,
    uplift: Annotated[
        list[str] | None,
        typer.Option(
            "--uplift",
            metavar="SUPPORT",
            help="A support whose uplift is an output, all of them if none is named. May be "
            "repeated.",
            show_default=False,
        ),
    ] = None,
    speed: SpeedOption = None,
    changes: SetOption = None,
    quiet: QuietOption = False,
    json: JsonOption = False,
) -> None:
    """Write the line of a scenario, or one of its pantographs, for a program that steps it.

    The file has everything in it: library, line at rest, start. Nothing of Arcless needs to be
    installed where it is used.
    """
    from arcless.errors import ModelError
    from arcless.fmi import export_fmu, export_model

    if pantograph is not None and given not in (None, "contact-force"):
        raise ModelError(
            "inputs of a pantograph alone",
            where="--given",
            got=given,
            expected="contact-force, or no --given",
        )
    kind = out.suffix.lower()
    if kind not in (".fmu", ".loop"):
        raise ModelError(
            "kind of file", where="--out", got=str(out), expected="NAME.fmu or NAME.loop"
        )
    if kind == ".loop" and fmi is not None:
        raise ModelError(
            "version of the FMI", where="--fmi", got=fmi, expected="no --fmi for NAME.loop"
        )
    scenario = load(name, speed=speed, changes=changes, quiet=quiet)
    inputs = given or "contact-force"
    if kind == ".loop":
        done = export_model(
            scenario, out, given=inputs, travel=travel, pantograph=pantograph, supports=uplift
        )
    else:
        done = export_fmu(
            scenario,
            out,
            version=3 if fmi == "3" else 2,
            given=inputs,
            travel=travel,
            pantograph=pantograph,
            supports=uplift,
        )
    _say(done, json=json)


def _say(done: "Export", *, json: bool) -> None:
    """Print what was written: its variables, and platforms."""
    described = done.description
    if json:
        variables = [
            {"name": v.name, "unit": v.unit, "role": v.role, "description": v.description}
            for v in described.variables
        ]
        facts = {
            "path": str(done.path),
            "token": described.token,
            "step_length_s": described.step_length,
            "platforms": list(done.platforms),
            "variables": variables,
        }
        console.data(console.json_text(facts))
        return
    for role in ("input", "output"):
        names = [f"{v.name} [{v.unit}]" for v in described.of_role(role)]
        shown = ", ".join(names[:8]) + (
            f", … ({len(names)})" if len(names) > len(names[:8]) else ""
        )
        console.data(f"{role}s: {shown}")
    console.data(f"steps of {1e3 * described.step_length:g} ms")
    if done.platforms:
        console.data(f"for {', '.join(done.platforms)}")
    console.data(f"wrote {done.path}")


@app.command()
def library(
    folder: Annotated[
        Path,
        typer.Argument(metavar="DIR", help="A folder that exists.", show_default=False),
    ],
) -> None:
    """Copy the library of the C interface, and its header, into a folder."""
    from arcless.fmi import copy_library

    for path in copy_library(folder):
        console.data(f"wrote {path}")
