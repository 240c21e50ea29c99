"""Sensitivity of outputs to variables: Sobol indices and Morris' effects, computed by SALib.

A block (or trajectory) of the design needs all its points: one with a row that failed, is invalid
or is not there yet is left out, and counted. Then the indices are those of the blocks that remain.
"""

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from arcless.study.definition.study import Study
from arcless.study.designs import Morris, SobolIndices
from arcless.study.folder.table import needs
from arcless.study.journal.row import Row

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

# With fewer blocks an interval says nothing.
LEAST_BLOCKS = 4
# Bootstrap samples that the confidence intervals are made of, and how sure they are.
RESAMPLES, CONFIDENCE = 200, 0.95


def check_available(study: Study) -> None:
    """Refuse a study for indices, before any computing, where they could not be computed.

    Raises
    ------
    StudyError
        SALib is not installed.
    """
    if isinstance(study.design, SobolIndices | Morris):
        needs("SALib", "a sensitivity design")


def indices(study: Study, rows: Iterable[Row]) -> dict[str, Any] | None:
    """Return the indices of every output over every variable.

    Parameters
    ----------
    study
        None is returned unless its design is one for indices.
    rows
        In any order; those that are missing or not done take their blocks with them.

    Returns
    -------
    dict or None
        ``method``, ``confidence``, and by output ``blocks``, ``left_out``, ``why`` (where there are
        no indices) and ``indices``: by variable ``first`` and ``total`` (and ``pairs``), or
        ``mu``, ``mu_star``, ``sigma``, each with the half width of its interval
        (``first_interval``, …). Effects are in the unit of the output, for all of a variable's
        range: 0 to 1 of its quantiles.

    Raises
    ------
    StudyError
        SALib is not installed.
    """
    design = study.design
    if not isinstance(design, SobolIndices | Morris):
        return None
    check_available(study)
    found: dict[str, list[float | None]] = {
        name: [None] * study.plan.count for name in study.outputs
    }
    for row in rows:
        for name, values in found.items():
            values[row.variant - 1] = row.outputs.get(name)
    outputs = {}
    for name, values in found.items():
        outputs[name] = of_output(design, list(study.variables), values, study.seed)
    return {"method": design.kind, "confidence": CONFIDENCE, "outputs": outputs}


def of_output(
    design: SobolIndices | Morris, names: list[str], values: list[float | None], seed: int
) -> dict[str, Any]:
    """Return the indices of one output, from its values in the order of the design."""
    import numpy as np

    blocks = np.array(values, dtype=float).reshape(design.count, design.block(len(names)))
    whole = np.isfinite(blocks).all(axis=1)
    kept = blocks[whole]
    found: dict[str, Any] = {"blocks": len(kept), "left_out": int(design.count - len(kept))}
    why = None
    if len(kept) < LEAST_BLOCKS:
        why = f"fewer than {LEAST_BLOCKS} whole blocks"
    elif kept.max() - kept.min() <= np.finfo(float).eps * np.abs(kept).max():
        why = "the output is the same everywhere"
    if why is not None:
        return {**found, "why": why, "indices": None}
    problem = {"num_vars": len(names), "names": names, "bounds": [[0.0, 1.0]] * len(names)}
    if isinstance(design, SobolIndices):
        return {**found, "indices": _sobol(design, problem, kept.ravel(), seed)}
    points = design.points(0, len(names), seed).reshape(*blocks.shape, len(names))[whole]
    return {**found, "indices": _morris(design, problem, points, kept.ravel(), seed)}


def _sobol(
    design: SobolIndices, problem: dict[str, Any], values: "NDArray[np.float64]", seed: int
) -> dict[str, Any]:
    from SALib.analyze import sobol

    found = sobol.analyze(
        problem,
        values,
        calc_second_order=design.second_order,
        num_resamples=RESAMPLES,
        conf_level=CONFIDENCE,
        seed=seed + 1,  # SALib takes 0 for none
    )
    names = problem["names"]
    result: dict[str, Any] = {}
    for place, name in enumerate(names):
        result[name] = {
            "first": _plain(found["S1"][place]),
            "first_interval": _plain(found["S1_conf"][place]),
            "total": _plain(found["ST"][place]),
            "total_interval": _plain(found["ST_conf"][place]),
        }
        if design.second_order:
            result[name]["pairs"] = {
                other: {
                    "second": _plain(found["S2"][place, behind]),
                    "second_interval": _plain(found["S2_conf"][place, behind]),
                }
                for behind, other in enumerate(names[place + 1 :], start=place + 1)
            }
    return result


def _morris(
    design: Morris,
    problem: dict[str, Any],
    points: "NDArray[np.float64]",
    values: "NDArray[np.float64]",
    seed: int,
) -> dict[str, Any]:
    from SALib.analyze import morris

    # A step of SALib is p/(2(p − 1)) of 0 to 1 with levels at l/(p − 1); ours is 1/2.
    levels = points * design.levels - 0.5
    grid = (levels / (design.levels - 1)).reshape(-1, problem["num_vars"])
    stretch = 2.0 * design.levels / (2.0 * (design.levels - 1))
    found = morris.analyze(
        problem,
        grid,
        values,
        num_resamples=RESAMPLES,
        conf_level=CONFIDENCE,
        num_levels=design.levels,
        seed=seed,
    )
    keys = {"mu": "mu", "mu_star": "mu_star", "mu_star_interval": "mu_star_conf", "sigma": "sigma"}
    return {
        name: {ours: _plain(stretch * found[theirs][place]) for ours, theirs in keys.items()}
        for place, name in enumerate(problem["names"])
    }


def _plain(value: Any) -> float | None:
    import math

    number = float(value)
    return number if math.isfinite(number) else None
