"""Results with known content: what a run would record, written down instead of computed."""

from collections.abc import Callable
from typing import Any

import numpy as np

from arcless.model import load
from arcless.results import dataset_from

SPAN_M = 50.0
DROPPERS_PER_SPAN = 5

QUIET_ENERGIES = (
    "energy_contact",
    "energy_pantograph",
    "energy_dissipated_droppers",
    "energy_dissipated_supports",
    "energy_dissipated_pantograph",
    "energy_dissipated_scheme",
    "energy_switching",
    "energy_work_traction",
    "energy_work_friction",
    "energy_residual",
)

Signal = Callable[[np.ndarray], np.ndarray]


def scenario_data(**changes: Any) -> dict[str, Any]:
    """A whole scenario, 72 km/h on a 10 kN wire; changes by path, dots written as ``__``."""
    wire = {"mass": 1.0, "axial_stiffness": 1e7, "bending_stiffness": 100.0, "tension": 10_000.0}
    sourced = {"value": "10 kN", "mark": "A", "source": "S1", "note": "drawn"}
    data: dict[str, Any] = {
        "name": "synthetic",
        "description": "Sines instead of a computation",
        "speed": 20.0,
        "line": {
            "name": "drawn line",
            "sources": {"S1": "a drawing"},
            "contact_wire": {**wire, "tension": sourced},
            "messenger_wire": wire,
            "dropper": {"stiffness": 1e5},
            "support": {"vertical_stiffness": 5e5},
            "steady_arm": {"kind": "spring", "vertical_stiffness": 300.0},
            "geometry": {"contact_wire_height": 5.3, "encumbrance": 1.2},
            "span_types": {"all": {"length": SPAN_M, "droppers": {"positions": [5.0, 45.0]}}},
            "spans": [{"type": "all", "count": 12}],
            "design": {"supply": "AC 25 kV", "uplift_space": 0.1},
        },
        "pantographs": [
            {
                "static_force": 60.0,
                "model": {"name": "drawn", "masses": [{"mass": 8, "stiffness": 50, "damping": 1}]},
            }
        ],
    }
    for path, value in changes.items():
        *folders, last = path.split("__")
        target = data
        for folder in folders:
            target = target.setdefault(folder, {})
        target[last] = value
    return load(data).to_dict()


def synthetic_dataset(
    *,
    duration_s: float = 30.0,
    step_s: float = 1e-3,
    line_every: int = 5,
    speed_m_s: float = 20.0,
    pantographs: tuple[str, ...] = ("P1",),
    distance_m: float = 100.0,
    force: Signal = lambda t: np.full_like(t, 100.0),
    gap: Signal = np.zeros_like,
    height: Signal = lambda t: np.full_like(t, 5.3),
    section: tuple[float, float] = (200.0, 400.0),
    scenario: dict[str, Any] | None = None,
    attrs: dict[str, Any] | None = None,
    stagger_m: float = 0.0,
    without: tuple[str, ...] = (),
) -> Any:
    """Build a dataset through the product's own builder.

    Every pantograph meets the same signals at the same time; the first starts at x = 0.
    """
    time = step_s * np.arange(round(duration_s / step_s) + 1)
    line_time = time[::line_every]
    behind = distance_m * np.arange(len(pantographs))
    everywhere = np.ones(len(pantographs))
    record = {
        "contact_force": np.outer(force(time), everywhere),
        "contact_gap": np.outer(gap(time), everywhere),
        "contact_height": np.outer(height(time), everywhere),
        "contact_lateral": np.zeros((time.size, len(pantographs))),
        "position": speed_m_s * time[:, None] - behind,
        "speed": np.full_like(time, speed_m_s),
        "mass_displacement": np.zeros((time.size, len(pantographs), 2)),
    }
    line, static, names = _line(line_time, speed_m_s, speed_m_s * duration_s, stagger_m)
    record |= line
    names |= {"time": time, "line_time": line_time, "pantograph": list(pantographs)}
    for name in without:
        record.pop(name, None)
        static.pop(name, None)
    return dataset_from(record, names, static, _attributes(duration_s, section, scenario, attrs))


def _attributes(
    duration_s: float,
    section: tuple[float, float],
    scenario: dict[str, Any] | None,
    attrs: dict[str, Any] | None,
) -> dict[str, Any]:
    return {
        "arcless_version": "0.0.0",
        "scenario": scenario or scenario_data(),
        "scenario_name": (scenario or scenario_data())["name"],
        "section_m": list(section),
        "steps": 30_000,
        "simulated_time_s": duration_s,
        "wall_time_s": duration_s / 50.0,
        "setup_time_s": 0.5,
        "real_time_factor": 50.0,
        "energy_residual_relative": 1e-12,
        "slack_droppers_max": 2,
        "lcp_pivots_total": 40_000,
        "lcp_pivots_max": 7,
        "static_force_found": {"P1": 60.0},
        "warnings": ["this run was drawn, not computed"],
        "command": "arcless run synthetic",
        **(attrs or {}),
    }


def _line(
    time: np.ndarray, speed_m_s: float, length_m: float, stagger_m: float
) -> tuple[dict[str, Any], dict[str, Any], dict[str, Any]]:
    """Uplift passes each place as a bell 5 m wide on both sides, 40 mm at supports."""
    spans = max(2, int(np.ceil(length_m / SPAN_M)))
    support_x = SPAN_M * np.arange(spans + 1)
    offsets = SPAN_M * (np.arange(DROPPERS_PER_SPAN) + 0.5) / DROPPERS_PER_SPAN
    dropper_x = (SPAN_M * np.arange(spans)[:, None] + offsets).ravel()
    node_x = np.arange(0.0, spans * SPAN_M + 1.0, 2.0)
    sag = 4.0 * (node_x % SPAN_M) / SPAN_M * (1.0 - (node_x % SPAN_M) / SPAN_M)
    side = stagger_m * np.cos(np.pi * node_x / SPAN_M)
    front = speed_m_s * time[:, None]
    uplift = 0.04 * np.exp(-(((front - support_x) / 5.0) ** 2))
    tension = 50.0 * (1.0 - 1.2 * np.exp(-(((front - dropper_x) / 5.0) ** 2)))
    record = {
        "support_uplift": uplift,
        "support_uplift_max": np.full(support_x.size, 0.04),
        "dropper_force": np.maximum(tension, 0.0),
        "dropper_force_min": np.full(dropper_x.size, 0.0),
        "dropper_force_max": np.full(dropper_x.size, 50.0),
        "slack_droppers": np.ones(time.size),
        "energy_kinetic": 100.0 + 10.0 * np.sin(time),
        "energy_elastic": 100.0 - 10.0 * np.sin(time),
        "energy_dissipated_line": 3.0 * time,
        "energy_work_uplift": 200.0 + 3.0 * time,
        **{name: np.zeros(time.size) for name in QUIET_ENERGIES},
    }
    static = {
        "dropper_x": dropper_x,
        "dropper_span": 1 + (dropper_x // SPAN_M),
        "dropper_length": np.full(dropper_x.size, 1.0),
        "dropper_top_z": np.full(dropper_x.size, 6.3),
        "dropper_bottom_z": np.full(dropper_x.size, 5.3),
        "dropper_force_static": np.full(dropper_x.size, 50.0),
        "support_x": support_x,
        "support_force_static": np.full(support_x.size, 900.0),
        "contact_wire_node_x": node_x,
        "contact_wire_node_y": side,
        "contact_wire_node_z": 5.3 - 0.03 * sag,
        "messenger_wire_node_x": node_x,
        "messenger_wire_node_y": 0.5 * side,
        "messenger_wire_node_z": 6.5 - 0.6 * sag,
        "elasticity": 3e-4 + 1e-4 * sag[:26],
        "natural_frequency": np.array([0.9, 1.0, 1.1]),
    }
    names = {
        "dropper": [
            f"span {1 + i // DROPPERS_PER_SPAN} dropper {1 + i % DROPPERS_PER_SPAN}"
            for i in range(dropper_x.size)
        ],
        "support": [f"support {i + 1}" for i in range(support_x.size)],
        "elasticity_x": node_x[:26],
    }
    return record, static, names
