"""A general linear pantograph: mass, damping and stiffness matrices, and where forces act."""

from math import sqrt
from typing import Annotated

from pydantic import Field, model_validator

from arcless.errors import ModelError
from arcless.model.fields import extremes
from arcless.model.fields.part import Part, Unit
from arcless.model.pantograph.force_tables import LiftTable
from arcless.model.pantograph.joint import Joint

MAX_COORDINATES = 20
# Measured or reduced matrices are written with rounded digits; this share of the largest entry is
# taken for such rounding, by the checks of symmetry and of sign.
ROUNDED = 1e-9
# The strip rises with the whole pantograph, apart from rounding of the written numbers.
RAISED = 1e-6

Vector = tuple[Annotated[float, Unit("1", minimum=-extremes.SHARE, maximum=extremes.SHARE)], ...]
Mass = Annotated[float, Unit("kg", minimum=-extremes.MASS, maximum=extremes.MASS)]
Damping = Annotated[float, Unit("N s/m", minimum=-extremes.DAMPING, maximum=extremes.DAMPING)]
Stiffness = Annotated[float, Unit("N/m", minimum=-extremes.STIFFNESS, maximum=extremes.STIFFNESS)]
Aerodynamic = Annotated[
    float, Unit("N/(m/s)2", minimum=-extremes.AERODYNAMIC, maximum=extremes.AERODYNAMIC)
]


class MatrixJoint(Joint):
    """Stops, tables and friction along a motion of a pantograph given by matrices."""

    between: Vector = Field(
        description="Motion that they sense: elongation for a unit of each coordinate."
    )

    @model_validator(mode="after")
    def _check_something(self) -> "MatrixJoint":
        parts = (self.stops, self.stiffness_table, self.damping_table, self.friction)
        if all(part is None for part in parts):
            expected = "stops, stiffness_table, damping_table or friction"
            raise ModelError("nothing given", expected=expected, field=("between",))
        return self


class MatrixLift(LiftTable):
    """A table of lift on a pantograph given by matrices."""

    on: Vector = Field(description="Work of a unit of the force on a unit of each coordinate.")

    def raising(self, rigid: tuple[float, ...], speed: float) -> float:
        """Return the share that raises the whole pantograph, in N at a speed in m/s."""
        return sum(r * g for r, g in zip(rigid, self.on, strict=True)) * self.at(speed)


class PantographMatrices(Part):
    """A linear pantograph in coordinates of its own: m ü + c u̇ + k u = forces."""

    mass: tuple[tuple[Mass, ...], ...] = Field(
        description="Mass matrix, row by row: symmetric, positive definite.",
        min_length=1,
        max_length=MAX_COORDINATES,
    )
    damping: tuple[tuple[Damping, ...], ...] = Field(
        description="Damping matrix, row by row: symmetric, not negative."
    )
    stiffness: tuple[tuple[Stiffness, ...], ...] = Field(
        description="Stiffness matrix, row by row: symmetric, not negative."
    )
    strip: Vector = Field(description="Height of the strip for a unit of each coordinate.")
    preload: Vector = Field(
        description="Work of a unit of the uplift force on a unit of each coordinate."
    )
    lift: tuple[Aerodynamic, ...] | None = Field(
        default=None,
        description="Upward aerodynamic force on each coordinate over speed squared; zero without.",
    )
    raised: Vector | None = Field(
        default=None,
        description="Coordinates of the whole pantograph raised by 1 m; 1 each without.",
    )
    lift_tables: tuple[MatrixLift, ...] = Field(
        default=(), description="Lift over speed.", max_length=MAX_COORDINATES
    )
    joints: tuple[MatrixJoint, ...] = Field(
        default=(),
        description="Stops, tables and friction in addition to the matrices.",
        max_length=MAX_COORDINATES,
    )

    @model_validator(mode="after")
    def _check(self) -> "PantographMatrices":
        size = len(self.mass)
        for name in ("mass", "damping", "stiffness"):
            _check_matrix(getattr(self, name), size, name, strict=name == "mass")
        for name in ("strip", "preload", "lift", "raised"):
            vector = getattr(self, name)
            if vector is not None and len(vector) != size:
                raise _wrong_size(f"{len(vector)} values", f"{size}, one for each row", (name,))
        self._check_directions(size)
        for name in ("strip", "preload"):
            if not any(getattr(self, name)):
                raise ModelError("acts nowhere", got="zeros", expected="a value", field=(name,))
        rise = sum(e * r for e, r in zip(self.strip, self.rigid, strict=True))
        if abs(rise - 1.0) > RAISED:
            raise ModelError(
                "the strip does not rise with the pantograph",
                got=f"{rise:g} m when the whole pantograph is raised by 1 m",
                expected="1 m: strip and raised belong to the same coordinates",
                hint="raised is 1 for every coordinate that is a height; give it for others",
                field=("strip" if self.raised is None else "raised",),
            )
        return self

    def _check_directions(self, size: int) -> None:
        joints = [(("joints", i, "between"), j.between) for i, j in enumerate(self.joints)]
        lifts = [(("lift_tables", i, "on"), table.on) for i, table in enumerate(self.lift_tables)]
        for field, vector in (*joints, *lifts):
            if len(vector) != size:
                raise _wrong_size(f"{len(vector)} values", f"{size}, one for each row", field)
            if not any(vector):
                raise ModelError("acts nowhere", got="zeros", expected="a value", field=field)

    @property
    def rigid(self) -> tuple[float, ...]:
        """Coordinates of the whole pantograph raised by 1 m."""
        return (1.0,) * len(self.mass) if self.raised is None else self.raised

    @property
    def lift_over_squared_speed(self) -> float:
        """The share of the contact force that the air carries, in N/(m/s)²."""
        return sum(r * g for r, g in zip(self.rigid, self.lift or (), strict=False))


def _check_matrix(
    matrix: tuple[tuple[float, ...], ...], size: int, name: str, *, strict: bool
) -> None:
    """Refuse what is not square, symmetric and positive (or, unless `strict`, zero)."""
    if len(matrix) != size:
        raise _wrong_size(f"{len(matrix)} rows", f"{size}, as many as mass has", (name,))
    for index, row in enumerate(matrix):
        if len(row) != size:
            raise _wrong_size(f"{len(row)} values", f"{size}, as many as rows", (name, index))
    largest = max(abs(value) for row in matrix for value in row)
    for i in range(size):
        for j in range(i):
            if abs(matrix[i][j] - matrix[j][i]) > ROUNDED * largest:
                raise ModelError(
                    "not symmetric",
                    got=f"{matrix[i][j]:g} in row {i + 1}, column {j + 1}, and {matrix[j][i]:g} in"
                    f" row {j + 1}, column {i + 1}",
                    expected="the same number twice",
                    field=(name, i, j),
                )
    bad = _first_bad_row(matrix, 0.0 if strict else ROUNDED * largest)
    if bad is None or (largest == 0.0 and not strict):
        return
    what = {"mass": "inertia", "damping": "dissipation", "stiffness": "energy"}[name]
    found, wanted = ("no", "positive") if strict else ("negative", "no negative")
    raise ModelError(
        f"not positive {'definite' if strict else 'definite or zero'}",
        got=f"a motion of the first {bad + 1} coordinates with {found} {what}",
        expected=f"a matrix that gives every motion {wanted} {what}",
        field=(name,),
    )


def _first_bad_row(matrix: tuple[tuple[float, ...], ...], shift: float) -> int | None:
    """Return the first row where Cholesky's factor of `matrix` + `shift` breaks down, or None."""
    size = len(matrix)
    lower = [[0.0] * size for _ in range(size)]
    for i in range(size):
        for j in range(i + 1):
            value = matrix[i][j] - sum(lower[i][k] * lower[j][k] for k in range(j))
            if i != j:
                lower[i][j] = value / lower[j][j]
            elif value + shift <= 0.0:
                return i
            else:
                lower[i][i] = sqrt(value + shift)
    return None


def _wrong_size(got: str, expected: str, field: tuple[str | int, ...]) -> ModelError:
    return ModelError("wrong number of values", got=got, expected=expected, field=field)
