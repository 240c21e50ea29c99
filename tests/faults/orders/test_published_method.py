"""The checks of orders notice methods that are not told apart, and an error that stays."""

from collections.abc import Callable
from types import SimpleNamespace
from typing import Any
from unittest.mock import patch

import numpy as np

from tests.verification.orders import test_published_method as checks

Noticed = Callable[..., None]
RAMP = np.linspace(-1.0, 1.0, 1001)


def made_up(size: Callable[..., float]) -> Callable[..., Any]:
    """Runs whose force differs from the default method's by so many newtons, as sizes say."""

    def smooth(way: tuple[str, ...], element: float, step: float, **more: Any) -> Any:
        error = 0.0 if way == checks.DEFAULT else size(way, element, step, **more)
        return SimpleNamespace(force=100.0 + 30.0 * RAMP + error)

    return smooth


def test_errors_of_another_order(noticed: Noticed) -> None:
    def first(_: Any, element: float, step: float, **__: Any) -> float:
        return element

    def constant(_: Any, element: float, step: float, **__: Any) -> float:
        return 0.01 + 10.0 * step

    def squared(_: Any, element: float, step: float, **more: Any) -> float:
        return float(1e-7 * more["pantographs.0.static_force"] ** 2)

    with patch.object(checks, "smooth", made_up(first)):
        noticed("chains of first order", checks.test_wire_models)
    with patch.object(checks, "smooth", made_up(constant)):
        noticed("an error that stays as the step shrinks", checks.test_schemes)
    with patch.object(checks, "smooth", made_up(squared)):
        noticed("a quadratic term of the kinematics", checks.test_kinematics)
    with patch.object(checks, "smooth", made_up(lambda *_, **__: 0.3)):
        noticed("a method that does not converge", checks.test_whole_method)
