"""Options of `arcless statics` for schedules of droppers and supports."""

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Self

import typer

if TYPE_CHECKING:
    from arcless.model import Line
    from arcless.simulate.statics import StaticsResult

DroppersOption = Annotated[
    Path | None,
    typer.Option(
        "--droppers",
        metavar="FILE.csv",
        help="Write the dropper schedule: positions, lengths, cut lengths, forces at rest.",
        show_default=False,
    ),
]
AllowanceOption = Annotated[
    str | None,
    typer.Option(
        "--allowance",
        metavar="LENGTH",
        help='Cut length less unstretched length of a dropper, such as "30 mm", 1 m at most; none'
        " without it.",
        show_default=False,
    ),
]
SupportsOption = Annotated[
    Path | None,
    typer.Option(
        "--supports",
        metavar="FILE.csv",
        help="Write heights, stagger, loads, lateral and arm forces at all supports.",
        show_default=False,
    ),
]


@dataclass(frozen=True)
class Schedules:
    """Schedules that were asked for: their files, and the allowance in m."""

    droppers: Path | None
    supports: Path | None
    allowance_m: float

    @classmethod
    def of(
        cls,
        droppers: Path | None,
        supports: Path | None,
        allowance: str | None,
        line: "Line",
    ) -> Self:
        """Check what was asked for before the line at rest is computed.

        Raises
        ------
        ModelError
            The allowance is no length with a unit, is negative or longer than fittings are, or
            nothing takes it; the line has no droppers.
        OutputError
            A file could not be written, or both are the same one.
        """
        from arcless.errors import ModelError, OutputError
        from arcless.simulate import schedules

        for file in (droppers, supports):
            if file is not None:
                _check_file(file)
        if droppers is not None and supports is not None and _same(droppers, supports):
            expected = "different files for --droppers and --supports"
            raise OutputError("one file for two schedules", where=str(supports), expected=expected)
        if allowance is not None and droppers is None:
            hint = "add --droppers FILE.csv, such as --droppers droppers.csv"
            raise ModelError("--allowance", got="no --droppers", expected="both", hint=hint)
        length = 0.0 if allowance is None else schedules.allowance(allowance, "--allowance")
        if droppers is not None and line.messenger_wire is None:
            raise ModelError(
                "--droppers", got=f"line `{line.name}`", expected="a line with droppers",
                hint="it has no messenger wire; --supports has what holds its contact wire",
            )  # fmt: skip
        return cls(droppers, supports, length)

    def write(self, found: "StaticsResult") -> list[Path]:
        """Write the schedules of a line at rest, and return their files."""
        if self.droppers is not None:
            found.write_droppers(self.droppers, self.allowance_m)
        if self.supports is not None:
            found.write_supports(self.supports)
        return [file for file in (self.droppers, self.supports) if file is not None]


def _check_file(file: Path) -> None:
    from arcless.simulate.schedules import check_ending
    from arcless.storage.whole_files import check_writable

    check_ending(file)
    check_writable(file)


def _same(one: Path, other: Path) -> bool:
    return one.resolve() == other.resolve()
