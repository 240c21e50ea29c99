"""Figures of a run: the contact force, the line's response to it, the line at rest."""

from collections.abc import Callable, Mapping

from arcless.figures.description import Figure
from arcless.figures.run import (
    along_track,
    contributions,
    distribution,
    energy,
    head,
    line_at_rest,
    response,
    space_time,
    spans,
)
from arcless.figures.run.run_data import RunData

# Key → figures, one for each pantograph or contact where they would hide each other.
# Those that the record has no data for are none.
FIGURES: Mapping[str, Callable[[RunData], list[Figure]]] = {
    "lead": along_track.lead,
    "force": along_track.force,
    "shares": along_track.shares,
    "gap": along_track.gap,
    "height": along_track.height,
    "uplift": response.uplift,
    "uplift_passages": response.uplift_passages,
    "space_time": space_time.space_time,
    "droppers": response.dropper_range,
    "dropper_map": response.dropper_map,
    "folded": spans.folded,
    "by_span": spans.by_span,
    "contributions": contributions.contributions,
    "irregular": contributions.irregular,
    "histogram": distribution.histogram,
    "spectrum": distribution.force_spectrum,
    "spectrogram": distribution.spectrogram,
    "lateral": head.lateral,
    "wear_pattern": head.wear_pattern,
    "side_view": line_at_rest.side_view,
    "plan_view": line_at_rest.plan_view,
    "elasticity": line_at_rest.elasticity,
    "energy": energy.energy,
}


def figures(run: RunData) -> dict[str, list[Figure]]:
    """Return all figures of a run by their keys; see `FIGURES`."""
    return {key: make(run) for key, make in FIGURES.items()}


__all__ = ["FIGURES", "RunData", "figures"]
