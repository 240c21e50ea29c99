"""Random scenarios that are valid by construction, in any spelling that files allow."""

from typing import Any

from hypothesis import strategies as st

from arcless.model.shipped.library import shipped
from arcless.units import KINDS

Draw = st.DrawFn
Data = dict[str, Any]
SOURCES = {"S1": "a book", "S2": "a letter"}
# Shipped lines that are long enough for whatever runs over them here.
LINES = [name for name in shipped("line") if name not in {"praks"} and "rail" not in name]
PANTOGRAPHS = [name for name in shipped("pantograph") if name not in {"praks", "dsa-380-lift"}]
# Line breaks of YAML 1.1, which the writer of the test leaves as they are: read as blanks.
# All but control characters and marks of direction, which names and texts may not have.
WRITABLE = st.characters(
    exclude_characters="\u061c\u200e\u200f\ufeff"
    + "".join(map(chr, (*range(0x2028, 0x202F), *range(0x2066, 0x206A)))),
    exclude_categories=("Cs", "Cc"),
)


@st.composite
def quantity(draw: Draw, low: float, high: float, unit: str) -> Any:
    """A number in SI, a text with any unit of its kind, or either with its provenance."""
    number = float(f"{draw(st.floats(low, high)):.6g}")
    number = min(max(number, low), high)
    names = [name for name in KINDS[unit].units if name]
    if names and draw(st.booleans()):
        name = draw(st.sampled_from(names))
        given: Any = f"{number / float(KINDS[unit].units[name]):.12g} {name}"
    else:
        given = number
    if draw(st.integers(0, 3)):
        return given
    origin = {"mark": draw(st.sampled_from(["A", "A'", "B", "C", "C*", "D", "assumed"]))}
    if draw(st.booleans()):
        origin["source"] = draw(st.sampled_from(["S1", "S2", "S1, S2"]))
    return {"value": given, **origin, "note": draw(st.text(WRITABLE, max_size=8))}


def some(parts: dict[str, st.SearchStrategy[Any]]) -> st.SearchStrategy[Data]:
    """Any of the optional fields."""
    return st.fixed_dictionaries({}, optional=parts)


def wire(mass: tuple[float, float], tension: tuple[float, float]) -> st.SearchStrategy[Data]:
    damping = some({"alpha": quantity(0, 0.1, "1/s"), "beta": quantity(0, 1e-3, "s")})
    return st.fixed_dictionaries(
        {
            "mass": quantity(*mass, "kg/m"),
            "axial_stiffness": quantity(5e6, 20e6, "N"),
            "bending_stiffness": quantity(0, 300, "N m2"),
            "tension": quantity(*tension, "N"),
            "diameter": quantity(0.01, 0.02, "m"),
        },
        optional={
            "damping": damping,
            "ends": st.sampled_from(["fixed", "constant_force", "weights"]),
            "thermal_expansion": quantity(1e-5, 2e-5, "1/K"),
        },
    )


@st.composite
def span_type(draw: Draw) -> Data:
    length, count = draw(st.sampled_from([40.0, 50.0, 55.0, 62.5])), draw(st.integers(1, 6))
    positions = [length * (i + 1) / (count + 1) for i in range(count)]
    droppers: Data = {"positions": [f"{x:.6f} m" if draw(st.booleans()) else x for x in positions]}
    kind = draw(st.sampled_from([None, "presag", "lengths"]))
    if kind is not None:
        low, high = (0.0, 0.05) if kind == "presag" else (0.5, 1.2)
        droppers[kind] = [draw(quantity(low, high, "m")) for _ in positions]
    return {"length": length, "droppers": droppers}


ARMS = st.one_of(
    st.fixed_dictionaries(
        {"kind": st.just("spring"), "vertical_stiffness": quantity(0, 1000, "N/m")},
        optional={"mass": quantity(0, 2, "kg")},
    ),
    st.fixed_dictionaries(
        {"kind": st.just("arm"), "length": quantity(0.6, 1.5, "m")},
        optional={"slope": quantity(-0.3, 0.3, "rad"), "mass": quantity(0, 2, "kg/m")},
    ),
    st.just({"kind": "none"}),
)


@st.composite
def line(draw: Draw) -> Data:
    """An inline line of ten to twenty spans."""
    name = st.text("abc -1", min_size=1, max_size=6).filter(str.strip)
    types = draw(st.dictionaries(name, span_type(), min_size=1, max_size=3))
    keys = st.sampled_from(sorted(types))
    runs = draw(st.lists(st.tuples(keys, st.integers(2, 4)), min_size=5, max_size=6))
    arm = draw(ARMS)
    # Without a steady arm nothing holds the wire aside.
    aside = 0.0 if arm["kind"] == "none" else 0.3
    stagger = st.lists(quantity(-aside, aside, "m"), min_size=1, max_size=3)
    clamps = ("clamp_mass_contact_wire", "clamp_mass_messenger_wire")
    dropper = {
        "mass": quantity(0, 0.2, "kg/m"),
        "damping": quantity(0, 10, "N s/m"),
        "slackens": st.booleans(),
    } | {clamp: quantity(0, 0.3, "kg") for clamp in clamps}
    return {
        "name": draw(name),
        "sources": SOURCES,
        "contact_wire": draw(wire((0.8, 1.5), (10e3, 30e3))),
        "messenger_wire": draw(wire((0.5, 1.5), (8e3, 25e3))),
        "dropper": {"stiffness": draw(quantity(1e4, 1e6, "N/m"))} | draw(some(dropper)),
        "support": {"vertical_stiffness": draw(quantity(1e5, 1e7, "N/m"))},
        "steady_arm": arm,
        "geometry": {
            "contact_wire_height": draw(quantity(5, 6, "m")),
            "encumbrance": draw(quantity(1.0, 1.8, "m")),
        }
        | draw(some({"stagger_contact_wire": stagger, "stagger_messenger_wire": stagger})),
        "span_types": types,
        "spans": [{"type": key, "count": count} for key, count in runs],
    }


@st.composite
def pantograph(draw: Draw) -> Data:
    """An inline pantograph: a chain of masses."""
    parts = {
        "mass": quantity(1, 20, "kg"),
        "stiffness": quantity(10, 2e4, "N/m"),
        "damping": quantity(0, 200, "N s/m"),
    }
    lift = {"aerodynamic": quantity(0, 0.01, "N/(m/s)2")}
    masses = st.lists(st.fixed_dictionaries(parts, optional=lift), min_size=1, max_size=4)
    return {"name": "own", "sources": SOURCES, "masses": draw(masses)}


@st.composite
def placements(draw: Draw) -> list[Data]:
    """One to three pantographs, one behind the other."""
    found, behind = [], 0.0
    for number in range(draw(st.integers(1, 3))):
        force = draw(st.sampled_from(["static_force", "mean_force"]))
        model = draw(st.sampled_from(PANTOGRAPHS) | pantograph())
        one: Data = {"model": model, force: draw(quantity(50, 200, "N"))}
        if number:
            behind += draw(st.sampled_from([5.0, 15.0, 31.0]))
            one["distance"] = behind
        if draw(st.booleans()):
            places = [-100.0, draw(st.floats(0, 500)), 1e5]
            heave = [draw(quantity(-0.05, 0.05, "m")) for _ in places]
            one["roof_motion"] = {"position": places, "displacement": heave}
        if draw(st.booleans()):
            pid = {"target": draw(quantity(50, 200, "N")), "proportional": 0.5}
            one["controller"] = {"sample_time": "8 ms", "delay": "4 ms", "pid": pid}
        found.append(one)
    return found


SCHEMES = st.one_of(
    st.sampled_from(["generalised-alpha", "hht", "newmark", "trapezoidal", "backward-difference"]),
    st.builds(
        lambda radius: {"name": "generalised-alpha", "spectral_radius": radius},
        quantity(0, 1, "1"),
    ),
    st.builds(lambda alpha: {"name": "hht", "alpha": alpha}, quantity(-0.3, 0, "1")),
)
CONTACT = some(
    {"law": st.sampled_from(["compliant", "rigid"]), "stiffness": quantity(1e4, 1e5, "N/m")}
)
BUILT = some(
    {
        "temperature_difference": quantity(-40, 60, "K"),
        "contact_wire_wear": st.just(
            [{"from": 10, "to": "50 m", "fraction": 0.1}, {"from": 60, "to": 70, "fraction": 0.2}]
        ),
        "missing_droppers": st.sampled_from([["span 3 dropper 1"], [{"span": 2, "dropper": 1}]]),
        "dropper_length_errors": st.just(
            [{"span": 4, "dropper": 1, "length_error": {"value": "-5 mm", "note": "built so"}}]
        ),
    }
)


@st.composite
def scenarios(draw: Draw) -> Data:
    """A valid scenario: everything inline, or lines and pantographs by name."""
    line_data = draw(line() | st.sampled_from(LINES))
    data: Data = {
        "format": "arcless-scenario/1",
        "name": draw(st.text(WRITABLE, min_size=1, max_size=12)),
        "description": draw(st.text(WRITABLE, max_size=20)),
        "sources": SOURCES,
        "line": line_data,
        "pantographs": draw(placements()),
        "contact": draw(CONTACT),
        "solver": {"time_step": draw(st.sampled_from([1e-3, "2 ms", 0.004]))}
        | draw(
            some(
                {
                    "scheme": SCHEMES,
                    "kinematics": st.sampled_from(["linearised", "updated"]),
                    "wire_model": st.sampled_from(["auto", "hermite", "lumped"]),
                    "contact_wire_element": quantity(1.0, 3.0, "m") | st.just("auto"),
                }
            )
        ),
        "output": draw(some({"line_every": st.integers(1, 50), "droppers": st.booleans()})),
    }
    speed = draw(quantity(20, 90, "m/s"))
    profile = {"time": [0, 1e3], "speed": [speed, speed]}
    data |= {"speed": speed} if draw(st.booleans()) else {"speed_profile": profile}
    if isinstance(line_data, dict):
        data["as_built"] = draw(BUILT)
    return data
