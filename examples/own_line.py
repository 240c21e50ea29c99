"""A line of your own, written as a dictionary: what its droppers must be, and how it runs.

Run it with ``python examples/own_line.py``. The same text in YAML is a model file.
"""

import arcless

LINE = {
    "format": "arcless-line/1",
    "name": "my-line",
    "contact_wire": {
        "mass": "1.07 kg/m",
        "axial_stiffness": "12 MN",
        "bending_stiffness": "130 N m2",
        "tension": "15 kN",
        "ends": "weights",
        "damping": {"alpha": "0.17 1/s", "beta": "0.1 ms"},  # 1 % of critical at 1.4 Hz
    },
    "messenger_wire": {
        "mass": "0.60 kg/m",
        "axial_stiffness": "7 MN",
        "bending_stiffness": 0,
        "tension": "15 kN",
        "ends": "weights",
        "damping": {"alpha": "0.17 1/s", "beta": "0.1 ms"},
    },
    "midpoint_anchor": {"stiffness": "1 MN/m"},  # so both ends hang on weights
    "dropper": {"stiffness": "200 kN/m", "mass": "0.1 kg/m"},
    "support": {"vertical_stiffness": "500 kN/m"},
    "steady_arm": {"kind": "spring", "vertical_stiffness": "250 N/m", "mass": "1 kg"},
    "geometry": {"contact_wire_height": "5.3 m", "encumbrance": "1.4 m"},
    "span_types": {
        "standard": {
            "length": "60 m",
            "droppers": {
                "positions": [5, 15, 25, 35, 45, 55],  # numbers are SI: metres
                "presag": ["0 mm", "20 mm", "30 mm", "30 mm", "20 mm", "0 mm"],
            },
        }
    },
    "spans": [{"type": "standard", "count": 12}],
    "design": {"supply": "AC 25 kV"},  # chooses the limits of force
}

SCENARIO = {
    "format": "arcless-scenario/1",
    "name": "my-line-160",
    "line": LINE,
    "pantographs": [{"model": "dsa-250", "static_force": "70 N"}],
    "speed": "160 km/h",
}


def main() -> arcless.Result:
    """Print the dropper table and the elasticity of a span, then run a pantograph along it."""
    scenario = arcless.load(SCENARIO)

    statics = arcless.statics(scenario)
    print("dropper            length m  force N")
    for dropper in statics.droppers:
        if dropper["span"] == 6:
            print(f"{dropper['name']}  {dropper['length_m']:8.3f}  {dropper['force_N']:7.1f}")
    middle = len(statics.elasticity_m_per_N) // 2
    for place, index in (("support", 0), ("mid-span", middle)):
        print(f"elasticity, {place}: {1e3 * statics.elasticity_m_per_N[index]:.2f} mm/N")

    result = arcless.run(scenario)
    pantograph = result.assessment.pantographs[0]
    print(f"mean force {pantograph.mean_force_N:.1f} N, deviation {pantograph.std_force_N:.1f} N")
    return result


if __name__ == "__main__":
    main()
