"""Errors of a complementarity problem."""

from arcless.errors import ArclessError


class LcpInputError(ArclessError, ValueError):
    """H or w is not what a complementarity problem needs."""

    exit_code = 2


class LcpUnsolvedError(ArclessError):
    """No solution was found, or the one found does not satisfy the problem.

    Parameters
    ----------
    pivots : int
        Exchanges made.
    residual : float
        Residual of the last candidate, NaN when there was none.
    """

    def __init__(
        self,
        what: str,
        *,
        where: str | None = None,
        got: str | None = None,
        expected: str | None = None,
        hint: str | None = None,
        pivots: int = 0,
        residual: float = float("nan"),
    ) -> None:
        super().__init__(what, where=where, got=got, expected=expected, hint=hint)
        self.pivots = pivots
        self.residual = residual
