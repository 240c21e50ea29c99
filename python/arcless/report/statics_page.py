"""The line at rest as one page: views, elasticity, forces, tables of droppers and supports."""

from collections.abc import Mapping, Sequence
from datetime import UTC, datetime
from importlib.metadata import version
from pathlib import Path
from typing import Any

import numpy as np

from arcless.display.numbers import number
from arcless.equilibrium.initial_configuration import InitialConfiguration
from arcless.equilibrium.line_alone import LineAlone
from arcless.figures.statics import LineData, figures
from arcless.report.at_rest.wire_tables import span_table, wire_table
from arcless.report.template import render
from arcless.storage.whole_files import write_bytes

# Key of a support, title of its column with the unit, decimals.
_SUPPORT_COLUMNS = (
    ("contact_wire_height_m", "contact wire above rail, m", 4),
    ("stagger_m", "stagger, m", 3),
    ("messenger_wire_height_m", "messenger wire above rail, m", 4),
    ("messenger_force_N", "messenger-wire force, N", 1),
    ("contact_support_force_N", "contact-support force, N", 1),
    ("contact_wire_lateral_force_N", "lateral force of the contact wire, N", 1),
    ("messenger_wire_lateral_force_N", "lateral force of the messenger wire, N", 1),
    ("steady_arm_force_N", "steady-arm force, N", 1),
)
_CONTENTS = (
    ("summary", "Summary"), ("views", "Line at rest"), ("elasticity", "Elasticity"),
    ("droppers", "Droppers"), ("supports", "Supports"), ("clamped", "Stitch wires and bridles"),
    ("wires", "Wires"),
    ("dynamics", "Waves and resonance"),
)  # fmt: skip


def write(
    found: InitialConfiguration, path: str | Path, *, resonance: Mapping[str, Any] | None = None
) -> None:
    """Write the initial configuration as one HTML file that opens without a network.

    Parameters
    ----------
    found
        The initial configuration.
    path
        The file to write; its folder must exist.
    resonance
        Resonance speeds as plain values; see `arcless.simulate.statics`. None for a page without.

    Raises
    ------
    OutputError
        The file cannot be written; nothing half-written stays behind.
    """
    write_bytes(path, html(found, resonance=resonance).encode())


def html(found: InitialConfiguration, *, resonance: Mapping[str, Any] | None = None) -> str:
    """Return the page of an initial configuration; see `write`."""
    line = LineData(found)
    drawn = figures(line)
    texts: dict[str, Any] = {
        "droppers": dropper_table(found),
        "supports": support_table(line),
        "clamped": clamped_tables(found),
        "spans": span_table(found),
        "wires": wire_table(found),
    }
    there = {"summary", "views", "elasticity", "dynamics"}
    there |= {key for key, rows in texts.items() if rows}
    return render(
        "statics.html",
        drawn,
        track=_track(line),
        name=found.scenario.line.name,
        description=found.scenario.line.description,
        identity=identity(found),
        numbers=main_numbers(found),
        as_built=as_built_rows(found),
        frequencies=[number(value, 3) for value in found.natural_frequencies_Hz],
        speeds=[_speed_row(one) for one in (resonance or {}).get("speeds", ())],
        speed_notes=(resonance or {}).get("notes", ()),
        contents=[(key, title) for key, title in _CONTENTS if key in there],
        middle=found.middle_span,
        cut=(f"{line.begin:.0f}", f"{line.end:.0f}") if line.cut else None,
        date=_now(),
        **texts,
    )


def identity(found: InitialConfiguration) -> list[tuple[str, str]]:
    """Return what the page is about, as label and text."""
    places = found.equilibrium.support_places()
    kind = "Line" if isinstance(found.scenario, LineAlone) else "Scenario"
    weather = "as designed" if found.as_built is None else "as built"
    return [
        (kind, found.scenario.name),
        ("Length", f"{len(places) - 1} spans, {places[-1] - places[0]:.0f} m"),
        ("State", weather),
        ("Computed", _now()),
        ("Arcless", version("arcless")),
    ]


def main_numbers(found: InitialConfiguration) -> list[tuple[str, str, str]]:
    """Return label, value and unit of the main numbers: those of the drawing, then the others."""
    elasticity = 1e3 * np.array(found.elasticity_m_per_N)
    span = f"span {found.middle_span}"
    rows = _drawn_numbers(found)
    sag = f"sag of the contact wire, maximum less minimum height in {span}"
    rows.append((sag, number(1e3 * found.contact_wire_sag_m, 1), "mm"))
    lateral = found.contact_wire_lateral_max_m
    if lateral is not None:
        text = number(1e3 * lateral, 0)
        rows.append(("maximum lateral position of the contact wire", text, "mm"))
    low, high = (number(end, 3) for end in (elasticity.min(), elasticity.max()))
    rows.append((f"elasticity in {span}, minimum to maximum", f"{low} – {high}", "mm/N"))
    rows.append(
        (
            f"non-uniformity of elasticity in {span}",
            number(100 * found.elasticity_nonuniformity),
            "%",
        )
    )
    if found.wave_speed is not None:
        rows.append(("wave speed of the contact wire", number(3.6 * found.wave_speed, 0), "km/h"))
    if found.natural_frequencies_Hz:
        rows.append(("lowest natural frequency", number(found.natural_frequencies_Hz[0], 3), "Hz"))
    forces = [one["force_N"] for one in found.droppers]
    if forces:
        rows.append((f"dropper forces, {len(forces)} droppers", _ends(forces, 1), "N"))
        lengths = [one["length_m"] for one in found.droppers]
        rows.append(("dropper lengths between clamps", _ends(lengths, 3), "m"))
    return rows


def _drawn_numbers(found: InitialConfiguration) -> list[tuple[str, str, str]]:
    """Return the numbers of the line as designed: spans, heights, stagger, tensions."""
    line = found.scenario.line
    spans = np.diff(found.equilibrium.support_places())
    rows = [("span length", _ends(spans.tolist(), 1), "m")]
    if line.geometry.contact_wire_height is not None:
        height = number(line.geometry.contact_wire_height, 2)
        rows.append(("height of the contact wire above rail", height, "m"))
    if line.geometry.encumbrance is not None:
        rows.append(("encumbrance (system height)", number(line.geometry.encumbrance, 2), "m"))
    staggers = _staggers(found)
    if staggers:
        rows.append(("stagger at the supports", _ends([1e3 * one for one in staggers], 0), "mm"))
    wires = (("contact wire", line.contact_wire), ("messenger wire", line.messenger_wire))
    for name, wire in wires:
        if wire is not None and wire.tension:
            rows.append(
                (f"tension of the {name}, as designed", number(1e-3 * wire.tension, 2), "kN")
            )
    return rows


def dropper_table(found: InitialConfiguration) -> dict[str, Any]:
    """Return titles and rows of the droppers; nothing of a line without any."""
    rows = found.droppers
    if not rows:
        return {}
    simple = len({(one["from"], one["to"]) for one in rows}) == 1
    titles = ["span", "dropper", *([] if simple else ["from", "to"]), "position, m",
              "length between clamps, m", "unstretched length, m", "force, N"]  # fmt: skip
    cells = [
        [
            str(one["span"]), one["name"].replace(f"span {one['span']} ", "", 1),
            *([] if simple else [one["from"], one["to"]]), number(one["x_m"], 2),
            number(one["length_m"], 4), number(one["unstretched_length_m"], 4),
            number(one["force_N"], 1),
        ]
        for one in rows
    ]  # fmt: skip
    return {"titles": titles, "rows": cells, "texts": len(titles) - 4}


def _staggers(found: InitialConfiguration) -> list[float]:
    """Return the lateral position in m of the contact wire at each support; nothing if straight."""
    points = found.equilibrium.positions
    if not np.ptp(points[:, 1]) > 0.0:
        return []
    return [float(points[place.contact_node, 1]) for place in found.equilibrium.mesh.supports]


def support_table(line: LineData) -> dict[str, Any]:
    """Return titles and rows of the supports, without columns that no support has a value for."""
    known = _staggers(line.found)
    staggers: Sequence[float | None] = known or [None] * len(line.mesh.supports)
    rows = [
        {**one, "stagger_m": stagger}
        for one, stagger in zip(line.found.supports, staggers, strict=True)
    ]
    shown = [one for one in _SUPPORT_COLUMNS if any(row.get(one[0]) is not None for row in rows)]
    titles = ["support", "position, m", *(title for _, title, _ in shown)]
    cells = [
        [
            row["name"], number(row["x_m"], 2),
            *(number(row.get(key), digits) for key, _, digits in shown),
        ]
        for row in rows
    ]  # fmt: skip
    return {"titles": titles, "rows": cells, "texts": 1}


def clamped_tables(found: InitialConfiguration) -> list[tuple[str, dict[str, Any]]]:
    """Return name and table of stitch wires and of bridles, those that there are."""
    made = []
    for key, name, title, of in (
        ("stitch-wires", "Stitch wires", "lowest point, m", "lowest_m"),
        ("bridles", "Bridles", "height of the hanging point, m", "hangs_at_m"),
    ):
        rows: Sequence[Mapping[str, Any]] = (
            found.stitch_wires if of == "lowest_m" else found.bridles
        )
        if not rows:
            continue
        titles = ["support", "from, m", "to, m", title, "unstretched length, m", "tension, N"]
        cells = [
            [
                one["support"], number(one["from_m"], 2), number(one["to_m"], 2),
                number(one[of], 4), number(one["unstretched_length_m"], 4),
                number(one["tension_N"], 1),
            ]
            for one in rows
        ]  # fmt: skip
        made.append((name, {"key": key, "titles": titles, "rows": cells, "texts": 1}))
    return made


def as_built_rows(found: InitialConfiguration) -> list[tuple[str, str, str]]:
    """Return label, value and unit of the numbers as built; none of a line as designed."""
    rows = []
    for key, value in (found.as_built or {}).items():
        words, _, unit = key.rpartition("_")
        rows.append((words.replace("_", " "), number(value, 1 if unit == "N" else 4), unit))
    return rows


def _speed_row(one: Mapping[str, Any]) -> dict[str, str]:
    low, high = 3.6 * one["lowest_speed_m_s"], 3.6 * one["highest_speed_m_s"]
    return {
        "kind": one["kind"], "name": one["name"], "speed": number(3.6 * one["speed_m_s"], 0),
        "band": f"{number(low, 0)} – {number(high, 0)}" if low < high else "–",
        "frequency": number(one["frequency_Hz"], 2), "formula": one["formula"],
        "about": one["about"], "source": one["source"],
    }  # fmt: skip


def _track(line: LineData) -> dict[str, Any]:
    """Return the whole line, the spans shown first, and the supports, in m."""
    supports = line.supports[line.inside(line.supports)]
    return {
        "section": list(line.shown), "whole": list(line.whole),
        "first": 1 + int(np.searchsorted(line.supports, supports[0])),
        "supports": [round(float(x), 2) for x in supports],
    }  # fmt: skip


def _ends(values: Sequence[float], decimals: int) -> str:
    """Return the least and the largest of some values; one number where they are the same."""
    low, high = (number(end, decimals) for end in (min(values), max(values)))
    return low if low == high else f"{low} – {high}"


def _now() -> str:
    return f"{datetime.now(UTC):%Y-%m-%d %H:%M}"
