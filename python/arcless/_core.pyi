from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

__version__: str

class NativeError(Exception): ...

def solve_lcp(
    h: NDArray[np.float64], w: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64], int, bool, float]: ...
def filtered(
    sections: NDArray[np.float64], state: NDArray[np.float64], signal: NDArray[np.float64]
) -> NDArray[np.float64]: ...

class Equilibrium:
    def __new__(
        cls,
        dim: int,
        positions: NDArray[np.float64],
        slopes: NDArray[np.float64],
        parts: dict[str, tuple[NDArray[np.int64], NDArray[np.float64]]],
        gravity: float,
        design: bool,
        residual_flexibility: bool = False,
        fitted_bends: bool = False,
        across_only: bool = False,
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
        lanes: list[list[int]],
        scheme: tuple[str, list[float]],
        step: float,
        contact_stiffness: float,
        updated: bool,
        period_correction: bool = False,
    ) -> Prepared: ...

class Prepared:
    def run(
        self,
        riders: list[Any],
        distances: list[float],
        positions: ArrayLike,
        speeds: ArrayLike,
        friction: float,
        loads: list[tuple[list[tuple[int, int, float]], list[float]]],
        plan: dict[str, Any],
        observe: Callable[[int], bool],
        state: tuple[int, dict[str, NDArray[np.float64]]] | None = None,
        until: int | None = None,
        take: tuple[int, Callable[[dict[str, Any]], None]] | None = None,
    ) -> dict[str, Any]: ...
    def cost(self) -> tuple[int, int, int]: ...

class Live:
    @staticmethod
    def with_forces(
        line: Prepared,
        collectors: list[tuple[float, float]],
        forces: list[float],
        start: tuple[float, float, float],
    ) -> Live: ...
    @staticmethod
    def with_riders(
        line: Prepared,
        riders: list[Any],
        distances: list[float],
        start: tuple[float, float, float],
    ) -> Live: ...
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
    def place(self) -> tuple[int, float, float]: ...
    def take_down(self) -> tuple[int, dict[str, NDArray[np.float64]]]: ...
    def put_back(self, state: tuple[int, dict[str, NDArray[np.float64]]]) -> None: ...
