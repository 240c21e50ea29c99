"""The line at rest as tables."""

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from arcless.cli.terminal.tables import number, table

if TYPE_CHECKING:
    from rich.console import RenderableType


def blocks(name: str, found: dict[str, Any]) -> "Iterator[RenderableType]":
    """Yield the tables of a static result: the middle span, then the line's own numbers."""
    places = sorted({support["x_m"] for support in found["supports"]})
    span = found["middle_span"]
    ends = places[span - 1 : span + 1]
    chosen = [support for support in found["supports"] if support["x_m"] in ends]
    if found["droppers"]:
        yield _droppers(found["droppers"], span, len(places) - 1)
    yield _supports(chosen)
    names = {support["name"] for support in chosen}
    stitches = [stitch for stitch in found["stitch_wires"] if stitch["support"] in names]
    if stitches:
        yield _clamped("Stitch wires there", "lowest point / m", "lowest_m", stitches)
    bridles = [bridle for bridle in found["bridles"] if bridle["support"] in names]
    if bridles:
        yield _clamped("Bridles there", "hang at / m", "hangs_at_m", bridles)
    yield _summary(name, found)
    if found["resonance_speeds"]["speeds"]:
        yield _resonance(found["resonance_speeds"])
        if found["resonance_speeds"]["notes"]:
            yield "".join(f"Note: {text}.\n" for text in found["resonance_speeds"]["notes"])


def _droppers(droppers: list[dict[str, Any]], span: int, spans: int) -> "RenderableType":
    chosen = [dropper for dropper in droppers if dropper["span"] == span]
    simple = all(dropper["from"] == "messenger wire" for dropper in chosen)
    columns = ("dropper", "x / m", "length between clamps / m", "force / N")
    # Where all hang from the messenger wire there is nothing to tell apart.
    extra = () if simple else ("hangs from",)
    made = table(f"Droppers of span {span} of {spans}", *columns, *extra, numbers=columns)
    prefix = f"span {span} dropper " if simple else f"span {span} "
    for dropper in chosen:
        made.add_row(
            dropper["name"].removeprefix(prefix),
            number(dropper["x_m"], 2),
            number(dropper["length_m"], 4),
            number(dropper["force_N"], 1),
            *(() if simple else (dropper["from"],)),
        )
    return made


def _clamped(title: str, words: str, key: str, found: list[dict[str, Any]]) -> "RenderableType":
    columns = ("from / m", "to / m", words, "unstretched length / m", "tension / N")
    made = table(title, "support", *columns, numbers=columns)
    for stitch in found:
        made.add_row(
            stitch["support"],
            number(stitch["from_m"], 2),
            number(stitch["to_m"], 2),
            number(stitch[key], 4),
            number(stitch["unstretched_length_m"], 4),
            number(stitch["tension_N"], 1),
        )
    return made


def _supports(supports: list[dict[str, Any]]) -> "RenderableType":
    held = "messenger" if "messenger_force_N" in supports[0] else "contact_support"
    words = f"{held.replace('_', '-')} force / N"
    columns = ("x / m", "height of contact wire / m", words, "steady-arm force / N")
    made = table("Supports of that span", "support", *columns, numbers=columns)
    for support in supports:
        made.add_row(
            support["name"],
            number(support["x_m"], 2),
            number(support["contact_wire_height_m"], 4),
            number(support[f"{held}_force_N"], 1),
            number(support["steady_arm_force_N"], 1),
        )
    return made


def _resonance(found: dict[str, Any]) -> "RenderableType":
    columns = ("speed / km/h", "from", "to", "f / Hz", "formula")
    made = table("Resonance speeds", "what", "which", *columns, numbers=columns[:-1])
    for one in found["speeds"]:
        ends = (one["lowest_speed_m_s"], one["highest_speed_m_s"])
        band = ends if ends[0] < ends[1] else (None, None)
        made.add_row(
            one["kind"],
            one["name"],
            number(3.6 * one["speed_m_s"], 0),
            *(number(None if end is None else 3.6 * end, 0) for end in band),
            number(one["frequency_Hz"], 2),
            one["formula"],
        )
    return made


def _summary(name: str, found: dict[str, Any]) -> "RenderableType":
    made = table(f"{name}: line at rest", "quantity", "unit", "value", numbers=("value",))
    middle = found["middle_span"]
    span = f"span {middle}"
    sag = f"sag of the contact wire, maximum less minimum height in {span}"
    made.add_row(sag, "m", number(found["contact_wire_sag_m"], 4))
    sags = [
        one["messenger_wire_sag_below_chord_m"] for one in found["spans"] if one["span"] == middle
    ]
    if any(sag is not None for sag in sags):
        lowest = max(sag for sag in sags if sag is not None)
        made.add_row(f"sag of the messenger wire below its chord in {span}", "m", number(lowest, 4))
    lateral = found["contact_wire_lateral_max_m"]
    if lateral is not None:
        made.add_row("largest lateral position of the contact wire", "m", number(lateral, 3))
    for wire in found["wires"]:
        if wire["stress_max_MPa"] is not None:
            words = f"maximum stress T/A of the {wire['wire'].replace('_', ' ')}"
            made.add_row(words, "MPa", number(wire["stress_max_MPa"], 1))
    elasticity = [point["mm_per_N"] for point in found["elasticity"]]
    if elasticity:
        made.add_row("minimum elasticity", "mm/N", number(min(elasticity), 3))
        made.add_row("maximum elasticity", "mm/N", number(max(elasticity), 3))
    uniformity = found["elasticity_nonuniformity"]
    percent = None if uniformity is None else 100 * uniformity
    made.add_row("non-uniformity of elasticity", "%", number(percent, 1))
    speed = found["wave_speed_m_s"]
    made.add_row("wave speed of the contact wire", "m/s", number(speed, 1))
    made.add_row("", "km/h", number(None if speed is None else 3.6 * speed, 0))
    for quantity, value in (found["as_built"] or {}).items():
        words, _, unit = quantity.rpartition("_")
        made.add_row(f"as built: {words.replace('_', ' ')}", unit, number(value, 4))
    frequencies = found["natural_frequencies_Hz"]
    if frequencies:
        made.add_row("lowest natural frequency", "Hz", number(frequencies[0], 3))
    return made
