from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from arcless.mesh.tables.columns import Tables
from arcless.simulate.setup.core_data import (
    CollectorData,
    DriveData,
    LoadData,
    OnLineData,
    PantographData,
    RecordPlan,
    SessionStart,
    SteppingData,
)

__version__: str
# Names of the series of a record, which grow with the run.
SERIES: tuple[str, ...]

class NativeError(Exception): ...

def solve_lcp(
    h: NDArray[np.float64], w: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64], int, bool, float]: ...
def filtered(
    sections: NDArray[np.float64], state: NDArray[np.float64], signal: NDArray[np.float64]
) -> NDArray[np.float64]: ...
def filter_on(
    sections: NDArray[np.float64], states: NDArray[np.float64], signals: NDArray[np.float64]
) -> None: ...
def advance(
    *,
    sessions: list[Session],
    forces: NDArray[np.float64],
    positions: NDArray[np.float64],
    speeds: NDArray[np.float64],
    out: NDArray[np.float64],
    workers: int,
) -> list[tuple[int, NativeError | None]]: ...
def exported_line(
    *,
    line: Equilibrium,
    lanes: list[list[int]],
    stepping: SteppingData,
    drive: DriveData,
    start: SessionStart,
    travel: str,
    pantographs: list[OnLineData],
    watched: list[int],
    supports: list[str],
) -> bytes: ...
def exported_pantograph(
    *,
    session: Session,
    number: int,
    stepping: SteppingData,
    name: str,
    heights: list[tuple[int, str]],
    influence: list[float],
) -> bytes: ...
def described(model: bytes) -> dict[str, Any]: ...

class Equilibrium:
    def __new__(
        cls,
        *,
        dimension: int,
        positions: NDArray[np.float64],
        slopes: NDArray[np.float64],
        parts: Tables,
        gravity: float,
        design: bool,
        residual_flexibility: bool = False,
        fitted_bends: bool = False,
        across_only: bool = False,
        near: Equilibrium | None = None,
    ) -> Equilibrium: ...
    def altered(self, changes: dict[str, Any]) -> Equilibrium: ...
    def nodal_forces(self, load: NDArray[np.float64]) -> list[tuple[int, int, float]]: ...
    def arrays(self) -> dict[str, NDArray[np.float64]]: ...
    def elasticity(self, lanes: list[list[int]], x: list[float], force: float) -> list[float]: ...
    def frequencies(self, count: int) -> list[float]: ...
    def modes_moved(
        self, lanes: list[list[int]], x: float, steps: int
    ) -> tuple[float, list[float], list[float]]: ...
    def prepare(
        self,
        *,
        lanes: list[list[int]],
        scheme: tuple[str, list[float]],
        step: float,
        contact_stiffness: float,
        updated: bool,
        period_correction: bool = False,
    ) -> WireModel: ...

class WireModel:
    def run(
        self,
        *,
        pantographs: list[PantographData],
        distances: list[float],
        positions: ArrayLike,
        speeds: ArrayLike,
        friction: float,
        loads: list[LoadData],
        plan: RecordPlan,
        observe: Callable[[int], bool],
        state: tuple[int, dict[str, NDArray[np.float64]]] | None = None,
        until: int | None = None,
        take: tuple[int, Callable[[dict[str, Any]], None]] | None = None,
    ) -> dict[str, Any]: ...
    def cost(self) -> tuple[int, int, int]: ...

class Session:
    @staticmethod
    def with_forces(
        *,
        line: WireModel,
        collectors: list[CollectorData],
        forces: list[float],
        start: SessionStart,
    ) -> Session: ...
    @staticmethod
    def with_pantographs(
        *,
        line: WireModel,
        pantographs: list[PantographData],
        distances: list[float],
        start: SessionStart,
    ) -> Session: ...
    @staticmethod
    def with_strips(
        *,
        line: WireModel,
        pantographs: list[PantographData],
        distances: list[float],
        start: SessionStart,
    ) -> Session: ...
    def step_strips(
        self,
        heights: NDArray[np.float64],
        compliance: NDArray[np.float64],
        position: float,
        speed: float,
        out: NDArray[np.float64],
    ) -> None: ...
    def compliance(
        self, forces: NDArray[np.float64], position: float, speed: float
    ) -> tuple[NDArray[np.float64], NDArray[np.float64]]: ...
    def watch(self, nodes: list[int]) -> None: ...
    def uplift(self) -> NDArray[np.float64]: ...
    def strip_heights(self) -> NDArray[np.float64]: ...
    def step(
        self,
        forces: NDArray[np.float64],
        position: float,
        speed: float,
        out: NDArray[np.float64],
    ) -> None: ...
    def read(self, out: NDArray[np.float64]) -> None: ...
    def sizes(self) -> tuple[int, int]: ...
    def contacts(self) -> list[list[int]]: ...
    def displacements(self) -> NDArray[np.float64]: ...
    def place(self) -> tuple[int, float, float]: ...
    def take_down(self) -> tuple[int, dict[str, NDArray[np.float64]]]: ...
    def put_back(self, state: tuple[int, dict[str, NDArray[np.float64]]]) -> None: ...
