"""A line, or a pantograph, of a scenario as a file for other programs."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from arcless.errors import ModelError
from arcless.fmi.export.archive import archive
from arcless.fmi.export.choice import Choice, Given, Travel
from arcless.fmi.export.description import VERSIONS, Description, Version, describe
from arcless.fmi.export.library import libraries
from arcless.fmi.export.model import model_of
from arcless.model import Scenario
from arcless.model.load import check_kind
from arcless.simulate.setup import trajectory
from arcless.storage.whole_files import check_writable, write_bytes


@dataclass(frozen=True)
class Export:
    """File that was written.

    Attributes
    ----------
    path
        The file.
    description
        Its variables.
    platforms
        Platforms that its libraries are for; none for a model of the C interface.
    """

    path: Path
    description: Description
    platforms: tuple[str, ...]


def export_fmu(
    scenario: Scenario,
    path: str | Path,
    *,
    version: Version = 2,
    given: Given = "contact-force",
    travel: Travel = "speed",
    pantograph: str | None = None,
    supports: Sequence[str] | None = None,
) -> Export:
    """Write an FMU for co-simulation: the line of a scenario, or one of its pantographs.

    Parameters
    ----------
    scenario
        Line, where the pantographs are, speed and force at the start, time step, scheme.
    path
        The file to write, NAME.fmu; one that exists is replaced.
    version
        Version of the FMI: 2 (2.0) or 3 (3.0).
    given
        Inputs of a line: contact forces, heights of strips, or controlled forces of pantographs
        that are simulated inside.
    travel
        Input that moves the pantographs: speed, or position of the first of them.
    pantograph
        Name of a pantograph, which is then exported by itself.
    supports
        Names of supports whose uplift is an output; all without.

    Raises
    ------
    ModelError
        A choice that the scenario does not have, or what a loop cannot do: see `realtime`.
    MeshError, EquilibriumError, ContactError
        The line cannot be divided, has no equilibrium, or the start is not on it.
    OutputError
        The file cannot be written, or the library is missing.
    """
    if version not in VERSIONS:
        raise ModelError(
            "version of the FMI", where="--fmi", got=str(version), expected="2 (2.0) or 3 (3.0)"
        )
    carried = libraries()
    choice = Choice(given, travel, pantograph, supports)
    model, description = _made(scenario, path, choice)
    write_bytes(path, archive(model, description, version, carried))
    return Export(Path(path), description, tuple(carried))


def export_model(
    scenario: Scenario,
    path: str | Path,
    *,
    given: Given = "contact-force",
    travel: Travel = "speed",
    pantograph: str | None = None,
    supports: Sequence[str] | None = None,
) -> Export:
    """Write a model for the C interface, NAME.loop; arguments and errors are those of `export_fmu`.

    Raises
    ------
    ModelError, MeshError, EquilibriumError, ContactError, OutputError
        See `export_fmu`.
    """
    choice = Choice(given, travel, pantograph, supports)
    model, description = _made(scenario, path, choice)
    write_bytes(path, model)
    return Export(Path(path), description, ())


def _made(scenario: Scenario, path: str | Path, choice: Choice) -> tuple[bytes, Description]:
    """Return the model of a choice and its description."""
    check_kind(scenario)
    check_writable(Path(path))
    model = model_of(scenario, choice)
    travel = trajectory.motion(scenario)
    what = "line" if choice.pantograph is None else f"pantograph {choice.pantograph}"
    about = f"The {what} of the scenario {scenario.name}, stepped by Arcless"
    title = scenario.name if choice.pantograph is None else f"{scenario.name} {choice.pantograph}"
    return model, describe(model, title, about, travel.steps * travel.time_step)
