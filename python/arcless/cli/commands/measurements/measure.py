"""`arcless measure`: a saved run as an instrumented pantograph would have measured it."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from arcless.cli.arguments.amounts import amount
from arcless.cli.commands.saved_results import ResultArgument
from arcless.cli.terminal import console

if TYPE_CHECKING:
    from arcless.results import Readings

# Option → field of the instrument and its unit in SI.
_FIELDS = {
    "--rate": ("rate_Hz", "Hz"),
    "--low-pass": ("low_pass_Hz", "Hz"),
    "--head-mass": ("mass_above_kg", "kg"),
    "--head-lift": ("lift_N", "N"),
    "--force-noise": ("force_noise_N", "N"),
    "--force-resolution": ("force_resolution_N", "N"),
    "--force-min": ("force_min_N", "N"),
    "--force-max": ("force_max_N", "N"),
    "--acceleration-noise": ("acceleration_noise_m_s2", "m/s2"),
    "--height-noise": ("height_noise_m", "m"),
    "--offset": ("position_offset_m", "m"),
    "--drift": ("odometer_drift", "1"),
}


def _option(name: str, metavar: str, words: str) -> Any:
    return typer.Option(name, metavar=metavar, help=words, show_default=False)


def measure(
    result: ResultArgument,
    *,
    to: Annotated[
        Path, _option("--to", "FILE", "The CSV file to write; one that exists is replaced.")
    ],
    pantograph: Annotated[
        str | None,
        _option(
            "--pantograph", "NAME", "Which pantograph has the sensors; the first if not given."
        ),
    ] = None,
    rate: Annotated[
        str | None, _option("--rate", "FREQUENCY", "Sampling rate; 500 Hz if not given.")
    ] = None,
    low_pass: Annotated[
        str | None,
        _option(
            "--low-pass",
            "FREQUENCY",
            "Cut-off of the amplifier; a quarter of the rate if not given.",
        ),
    ] = None,
    mass: Annotated[
        str | None,
        _option(
            "--head-mass", "MASS", "Mass above the force sensors; that of the strips if not given."
        ),
    ] = None,
    lift: Annotated[
        str | None, _option("--head-lift", "FORCE", "Upward force of the air on that mass.")
    ] = None,
    force_noise: Annotated[
        str | None,
        _option("--force-noise", "FORCE", "Standard deviation of the force's noise."),
    ] = None,
    force_resolution: Annotated[
        str | None, _option("--force-resolution", "FORCE", "Step of the force.")
    ] = None,
    force_min: Annotated[
        str | None, _option("--force-min", "FORCE", "Lower end of the sensors' range.")
    ] = None,
    force_max: Annotated[
        str | None, _option("--force-max", "FORCE", "Upper end of the sensors' range.")
    ] = None,
    acceleration_noise: Annotated[
        str | None,
        _option("--acceleration-noise", "ACCELERATION", 'Of the acceleration, such as "0.5 m/s2".'),
    ] = None,
    height_noise: Annotated[
        str | None, _option("--height-noise", "LENGTH", "Of the height of the strips.")
    ] = None,
    offset: Annotated[
        str | None,
        _option("--offset", "LENGTH", "What the odometer shows too much at the beginning."),
    ] = None,
    drift: Annotated[
        str | None,
        _option("--drift", "PART", "What it shows too much for each metre, such as 0.1 %."),
    ] = None,
    seed: Annotated[int, _option("--seed", "NUMBER", "Of the noise.")] = 0,
) -> None:
    """Write a saved run as a pantograph with sensors measures it.

    Force sensors below the strips miss the inertia of what is above them. The file has time,
    position, speed, sensor force, acceleration of the strips and contact height;
    `arcless assess` and `arcless compare` read it as that of a test run.
    """
    from arcless.measurements.read import ENDINGS
    from arcless.results import Instrument
    from arcless.results import open as open_result
    from arcless.storage.endings import check_ending
    from arcless.storage.whole_files import check_writable

    texts = (
        rate, low_pass, mass, lift, force_noise, force_resolution, force_min, force_max,
        acceleration_noise, height_noise, offset, drift,
    )  # fmt: skip
    given = {
        field: amount(option, text, unit)
        for (option, (field, unit)), text in zip(_FIELDS.items(), texts, strict=True)
        if text is not None
    }
    hint = "these are the files that `arcless assess` reads"
    check_ending(to, ENDINGS, "not a name of a measured run", hint=hint)
    check_writable(to)
    readings = open_result(result).as_measured(Instrument(**given, seed=seed), pantograph)
    readings.save(to)
    console.data(f"wrote {to}\n{_told(readings)}")


def _told(readings: "Readings") -> str:
    """Return what a reader of the file must know."""
    instrument, delay_s = readings.instrument, readings.delay_s
    distance = delay_s * float(readings.speed_m_s.mean())
    clipped = f"; {readings.clipped} beyond the range" if readings.clipped else ""
    return (
        f"{readings.force_N.size} samples at {instrument.rate_Hz:g} Hz{clipped}. Above the sensors:"
        f" {readings.mass_above_kg:g} kg. The amplifier delays by {1e3 * delay_s:.1f} ms,"
        f" {distance:.2f} m."
    )
