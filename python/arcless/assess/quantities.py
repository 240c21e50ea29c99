"""Names of the assessed quantities: one table for terminal, pages, figures and guides.

Terms are those of EN 50317 (measurement), EN 50318 (simulation) and EN 50367 (interaction), as
they are quoted in the sources that the criteria name; the standards' own texts were not read.
"""

from collections.abc import Mapping
from dataclasses import dataclass


@dataclass(frozen=True)
class Quantity:
    """Name, unit and decimals of a quantity.

    Attributes
    ----------
    label
        Its name. Names of bands hold places for the frequencies: see `label_of`.
    unit
        As printed; empty for a number without one.
    decimals
        Digits after the point; -1 for two significant digits.
    """

    label: str
    unit: str
    decimals: int


# Key of a pantograph in the assessment → quantity.
OF_PANTOGRAPH: Mapping[str, Quantity] = {
    "mean_force_N": Quantity("mean contact force F_m", "N", 1),
    "std_force_N": Quantity("standard deviation σ", "N", 1),
    "std_force_0_5Hz_N": Quantity("standard deviation, 0–{split} Hz", "N", 1),
    "std_force_5_20Hz_N": Quantity("standard deviation, {split}–{low_pass} Hz", "N", 1),
    "statistical_max_N": Quantity("statistical maximum F_m + 3σ", "N", 1),
    "statistical_min_N": Quantity("statistical minimum F_m − 3σ", "N", 1),
    "max_force_N": Quantity("maximum contact force", "N", 1),
    "min_force_N": Quantity("minimum contact force", "N", 1),
    "unfiltered_max_force_N": Quantity("maximum contact force, unfiltered", "N", 1),
    "unfiltered_min_force_N": Quantity("minimum contact force, unfiltered", "N", 1),
    "NQ_percent": Quantity("percentage of arcing NQ, losses above 5 ms", "%", 2),
    "contact_loss_percent": Quantity("loss of contact, all losses", "%", 2),
    "longest_loss_s": Quantity("longest loss of contact", "s", 3),
    "max_gap_mm": Quantity("maximum gap", "mm", 1),
    "contact_point_range_mm": Quantity("range of the contact point's height", "mm", 1),
    "max_lateral_position_mm": Quantity("maximum lateral position of the wire", "mm", 0),
}
# Of a scenario with coefficients of wear.
WEAR: Mapping[str, Quantity] = {
    "wear_mechanical_mm3_km": Quantity("wear by friction", "mm³/km", 3),
    "wear_joule_mm3_km": Quantity("wear by the current through the contact", "mm³/km", 3),
    "wear_arc_mm3_km": Quantity("wear by arcs", "mm³/km", 3),
    "wear_total_mm3_km": Quantity("total wear", "mm³/km", 3),
}
# Of the line and of the whole run.
OF_LINE: Mapping[str, Quantity] = {
    "max_uplift_at_support_mm": Quantity("maximum uplift at a support", "mm", 1),
    "min_dropper_force_N": Quantity("minimum dropper force", "N", 1),
    "slack_droppers_max": Quantity("maximum number of slack droppers", "", 0),
}
# Of the computation.
OF_COMPUTATION: Mapping[str, Quantity] = {
    "energy_residual_relative": Quantity("relative residual of the energy balance", "", -1),
    "steps": Quantity("time steps", "", 0),
    "setup_time_s": Quantity("wall time of the set-up", "s", 2),
    "wall_time_s": Quantity("wall time of the time steps", "s", 2),
    "real_time_factor": Quantity("real-time factor, simulated over wall time", "", 1),
}
QUANTITIES: Mapping[str, Quantity] = {**OF_PANTOGRAPH, **WEAR, **OF_LINE, **OF_COMPUTATION}


def label_of(key: str, *, low_pass_Hz: float = 20.0, band_split_Hz: float = 5.0) -> str:
    """Return the name of a quantity, with the frequencies in Hz of the bands it is about.

    Parameters
    ----------
    key
        In the assessment.
    low_pass_Hz, band_split_Hz
        Of the assessment; the standard's without.
    """
    return QUANTITIES[key].label.format(split=f"{band_split_Hz:g}", low_pass=f"{low_pass_Hz:g}")
