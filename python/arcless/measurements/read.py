"""A CSV file of a test run → a measurement."""

from collections.abc import Mapping
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from arcless.errors import MeasurementError
from arcless.measurements.measurement import Measurement
from arcless.measurements.samples.inertia import Head
from arcless.measurements.samples.pantograph import MeasuredPantograph
from arcless.measurements.samples.prepare import prepared
from arcless.measurements.samples.raw import Raw
from arcless.measurements.table.columns import KNOWN, SENSORS, Column, columns_of
from arcless.measurements.table.dialect import LARGEST_FILE, Dialect, examine
from arcless.measurements.table.numbers import numbers
from arcless.measurements.table.rows import scan
from arcless.model.settings.run_settings import FASTEST_TRAIN
from arcless.units import show, to_si

Values = Mapping[Column, NDArray[np.float64]]

# Endings of files that hold a measurement.
ENDINGS = (".csv", ".tsv", ".txt", ".dat", ".asc")
# Name of a pantograph that the columns do not name; runs call their first one so.
ONLY = "P1"
# Names of columns that are not used, in a remark.
NAMED = 5


def is_measured(path: Path) -> bool:
    """Say whether a path is that of a measurement: a file with one of the usual endings."""
    return path.suffix.lower() in ENDINGS and not path.is_dir()


def read(
    path: str | Path,
    *,
    speed: float | str | None = None,
    pantograph: str | None = None,
    head: Head | None = None,
    largest_bytes: int = LARGEST_FILE,
) -> Measurement:
    """Read a measured test run from a CSV file with units in its header.

    Parameters
    ----------
    path
        The file. Delimiter and decimal sign are recognised; lines that begin with # are skipped.
    speed
        Constant speed, such as ``"250 km/h"``, for a file without a column of it, and with only one
        of time and position.
    pantograph
        The one to read; all without it.
    head
        Mass and lift above the sensors, for the contact force from sensors below the strips.
    largest_bytes
        Size of the largest file that is read; it is held in memory.

    Raises
    ------
    MeasurementError
        The file is no such table, or its samples have no order; the message names line and column.
    ModelError
        The speed is no speed.
    """
    file = Path(path)
    constant = None if speed is None else _speed(speed)
    dialect = examine(file, largest_bytes=largest_bytes)
    columns, unused = columns_of(dialect.header, f"{file}:{dialect.header_line}")
    names = _chosen(columns, unused, pantograph, str(file))
    wanted = [column for column in columns if column.pantograph in (None, *names)]
    rows = scan(file, dialect)
    values = numbers(file, dialect, rows, wanted)
    raws = [_raw(name, values, rows.numbers, str(file)) for name in names]
    found = tuple(prepared(raw, constant, head) for raw in raws)
    notes = [*_about(dialect, unused), *_about_speed(raws[0], constant)]
    for raw, one in zip(raws, found, strict=True):
        _check_speed(one, str(file))
        notes += _about_force(raw, head)
        notes += _about_sampling(one)
    return Measurement(file.stem, file, found, tuple(notes))


def _speed(speed: float | str) -> float:
    found = to_si(speed, "m/s")
    if 0.0 < found <= FASTEST_TRAIN:
        return found
    hint = "a number without a unit is in m/s" if found > 0.0 else None
    raise MeasurementError(
        "speed of a train", got=f"{found:g} m/s ({3.6 * found:.0f} km/h)",
        expected=f"more than 0, at most {3.6 * FASTEST_TRAIN:.0f} km/h", hint=hint,
    )  # fmt: skip


def _check_speed(found: MeasuredPantograph, label: str) -> None:
    """Refuse a record whose speed no train has: a column is in another unit than it says."""
    usual = float(np.median(found.speed))
    if usual > FASTEST_TRAIN:
        raise MeasurementError(
            f"speed of pantograph {found.name}", where=label, got=f"{3.6 * usual:.0f} km/h",
            expected=f"at most {3.6 * FASTEST_TRAIN:.0f} km/h",
            hint="are the units of time, position and speed the right ones?",
        )  # fmt: skip


def _chosen(columns: list[Column], unused: list[str], wanted: str | None, label: str) -> list[str]:
    """Return names of pantographs that have a force."""
    with_force = [c.pantograph for c in columns if c.channel in ("contact_force", "sensor_force")]
    names = list(dict.fromkeys(with_force))
    if not names:
        raise MeasurementError(
            "missing column", where=label, got="no contact force",
            expected="contact_force [N], or sensor_force_1 [N] and so on",
            hint=_other_names(unused),
        )  # fmt: skip
    if None in names and len(names) > 1:
        raise MeasurementError(
            "force without the name of its pantograph", where=label,
            got=", ".join(c.title for c in columns if c.channel == "contact_force"),
            expected="P1.contact_force [N] and so on, where there are several pantographs",
        )  # fmt: skip
    found = [ONLY if name is None else name for name in names]
    if wanted is None:
        return found
    if wanted not in found:
        raise MeasurementError(
            "unknown pantograph", where=label, got=show(wanted), expected=", ".join(found)
        )
    return [wanted]


def _other_names(unused: list[str]) -> str | None:
    """Return the columns found that have none of the names known, and the names that are known."""
    if not unused:
        return None
    more = f" and {len(unused) - NAMED} more" if len(unused) > NAMED else ""
    found = ", ".join(map(show, unused[:NAMED]))
    return f"found {found}{more}; names that are known: {', '.join(KNOWN)}"


def _raw(name: str, values: Values, lines: NDArray[np.int64], label: str) -> Raw:
    """Return the columns of a pantograph: its own, and those that belong to all."""
    channels: dict[str, NDArray[np.float64]] = {}
    sensors: dict[str, dict[str, NDArray[np.float64]]] = {key: {} for key in SENSORS}
    for own in (False, True):
        for column, numbers_of in values.items():
            if column.pantograph == (name if own else None):
                if column.channel in SENSORS:
                    sensors[column.channel][column.title] = numbers_of
                else:
                    channels[column.channel] = numbers_of
    order = np.arange(lines.size)
    parts = channels, sensors["sensor_force"], sensors["acceleration"]
    return Raw(name, *parts, lines, order, label)


def _about(dialect: Dialect, unused: list[str]) -> list[str]:
    notes = [f"read as CSV: {dialect.words}"]
    if unused:
        more = f" and {len(unused) - NAMED} more" if len(unused) > NAMED else ""
        notes.append(f"columns that are not used: {', '.join(unused[:NAMED])}{more}")
    return notes


def _about_speed(raw: Raw, speed: float | None) -> list[str]:
    notes = []
    if "position" not in raw.channels:
        notes.append("no positions in the file: they are counted from its first sample, by speed")
    own = "speeds" if "speed" in raw.channels else "times and positions"
    if speed is not None and (own == "speeds" or {"time", "position"} <= raw.channels.keys()):
        notes.append(
            f"the speed given, {3.6 * speed:g} km/h, is not used: the file has {own} of its own"
        )
    return notes


def _about_force(raw: Raw, head: Head | None) -> list[str]:
    if "contact_force" in raw.channels:
        extra = [*raw.sensors, *raw.accelerations]
        return [f"pantograph {raw.name} has a column of contact force; columns of sensors are not "
                f"used: {', '.join(extra)}"] if extra else []  # fmt: skip
    count = len(raw.sensors)
    what = f"contact force of pantograph {raw.name}: sum of {count} sensor{'s' * (count > 1)}"
    if head is None:
        return [f"{what} below the strips, not corrected for the inertia of what is above them; its"
                " criteria are not judged"]  # fmt: skip
    return [f"{what} below the strips; {head.words}"]


def _about_sampling(found: MeasuredPantograph) -> list[str]:
    notes = []
    if found.held > 1:
        notes.append(
            f"pantograph {found.name}: each value is held over {found.held} samples, so the rate "
            f"is {found.true_rate_Hz:.4g} Hz instead of {found.rate_Hz:.4g} Hz"
        )
    if found.rounded_s and not found.interpolated:
        notes.append(
            f"pantograph {found.name}: times are rounded to {1e3 * found.rounded_s:.3g} ms, and"
            f" were taken as equally spaced, at {found.rate_Hz:.4g} Hz"
        )
    if found.interpolated:
        notes.append(
            f"pantograph {found.name}: samples are not equally spaced in time; they were "
            f"interpolated to {found.rate_Hz:.4g} Hz, within pieces without a gap only"
        )
    return notes
