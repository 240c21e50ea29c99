"""Stops, tables and friction between the masses of a pantograph, as the core takes them."""

from collections.abc import Iterator
from dataclasses import dataclass
from math import inf

from arcless.model.pantograph.joint import Joint
from arcless.model.pantograph.pantograph import Pantograph
from arcless.model.pantograph.placement import PantographPlacement
from arcless.pantograph.equation_of_motion import elongation
from arcless.simulate.setup.core_data import BumpStopData, PiecewiseForceData

Numbers = list[float]


@dataclass(frozen=True)
class PiecewiseLinearForce:
    """A spring or a damper with a table.

    Attributes
    ----------
    field
        Where it stands in the pantograph, such as masses.1.stiffness_table.
    data
        As the core takes it.
    is_table
        Whether it was given as a table: friction has no end.
    """

    field: str
    data: PiecewiseForceData
    is_table: bool

    @property
    def unit(self) -> str:
        """Unit of what it looks at."""
        return "m/s" if self.data.is_damper else "m"


def joints(pantograph: Pantograph) -> Iterator[tuple[str, Numbers, Joint]]:
    """Yield where each joint stands in the pantograph, its elongation, and itself."""
    size = pantograph.size
    for i, mass in enumerate(pantograph.masses):
        yield f"masses.{i}", elongation(size, i), mass
    if pantograph.matrices is not None:
        for i, joint in enumerate(pantograph.matrices.joints):
            yield f"matrices.joints.{i}", list(joint.between), joint


def stops(pantograph: Pantograph) -> list[BumpStopData]:
    """Return the bump stops of a pantograph as the core takes them."""
    found: list[BumpStopData] = []
    for _, direction, joint in joints(pantograph):
        if joint.stops is None:
            continue
        given = joint.stops.stiffness
        stiffness = inf if isinstance(given, str) else given
        if joint.stops.below is not None:
            found.append(BumpStopData(direction, gap=joint.stops.below, stiffness=stiffness))
        if joint.stops.above is not None:
            opens = [-value for value in direction]
            found.append(BumpStopData(opens, gap=joint.stops.above, stiffness=stiffness))
    return found


def piecewise_forces(pantograph: Pantograph) -> list[PiecewiseLinearForce]:
    """Return springs and dampers with tables, and friction, of a pantograph."""
    found: list[PiecewiseLinearForce] = []
    for place, direction, joint in joints(pantograph):
        for name, is_damper in (
            ("stiffness_table", False),
            ("damping_table", True),
            ("friction", True),
        ):
            part = getattr(joint, name)
            if part is not None:
                data = PiecewiseForceData(direction, is_damper, part.points)
                found.append(PiecewiseLinearForce(f"{place}.{name}", data, name != "friction"))
    return found


def tables_left(placements: tuple[PantographPlacement, ...], ranges: list[float]) -> list[str]:
    """Return a warning for each table that a run went beyond.

    Parameters
    ----------
    placements
        The pantographs.
    ranges
        Smallest and largest motion of each law, in the order of `piecewise_forces`.
    """
    numbers = iter(ranges)
    warnings = []
    for placement in placements:
        for law in piecewise_forces(placement.model):
            lowest, highest = next(numbers), next(numbers)
            first, last = law.data.points[0][0], law.data.points[-1][0]
            if law.is_table and (lowest < first or highest > last):
                warnings.append(
                    f"pantograph {placement.name}: {law.field} was left: {lowest:.4g} to"
                    f" {highest:.4g} {law.unit}, the table has {first:g} to {last:g} {law.unit};"
                    " beyond it the last slope continues"
                )
    return warnings
