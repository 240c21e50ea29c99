"""Measured frequency response of a pantograph → a chain of masses that has it."""

from arcless.pantograph.receptance.chain import Chain, Damping
from arcless.pantograph.receptance.fit import (
    LARGEST_MISFIT,
    MOST_MASSES,
    check_order,
    fit,
    orders,
)
from arcless.pantograph.receptance.fitted import Fit, Mode, Parameter
from arcless.pantograph.receptance.measured import (
    QUANTITIES,
    MeasuredReceptance,
    of_arrays,
    read,
)
from arcless.pantograph.receptance.model_file import pantograph, text
from arcless.pantograph.receptance.remarks import remarks
from arcless.pantograph.receptance.tables import to_dict

__all__ = [
    "LARGEST_MISFIT",
    "MOST_MASSES",
    "QUANTITIES",
    "Chain",
    "Damping",
    "Fit",
    "MeasuredReceptance",
    "Mode",
    "Parameter",
    "check_order",
    "fit",
    "of_arrays",
    "orders",
    "pantograph",
    "read",
    "remarks",
    "text",
    "to_dict",
]
