"""Designs: the combinations of values that a study computes, and the order of their numbers.

A design is a model of the file and a function `plan` that numbers its combinations. Another one is
another class in `Design`.
"""

from typing import Annotated

from pydantic import Field

from arcless.study.designs.blocks import Morris, SobolIndices
from arcless.study.designs.grids_and_lists import Grid, Listed
from arcless.study.designs.plan import MAX_VARIANTS, Plan
from arcless.study.designs.samples import LatinHypercube, MonteCarlo, Sobol

__all__ = [
    "MAX_VARIANTS",
    "Design",
    "Grid",
    "LatinHypercube",
    "Listed",
    "MonteCarlo",
    "Morris",
    "Plan",
    "Sobol",
    "SobolIndices",
]

Design = Annotated[
    Grid | Listed | LatinHypercube | Sobol | MonteCarlo | SobolIndices | Morris,
    Field(discriminator="kind"),
]
