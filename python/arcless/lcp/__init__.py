"""Linear complementarity: contacts that push but do not pull.

`solve` solves one problem ``y = Hx + w``, ``x ≥ 0``, ``y ≥ 0``, ``xᵀy = 0``. `PublishedStep` moves
any elastic system with such contacts through time, as the paper that Arcless is founded on does.
See ``docs/guide/lcp.md`` and ``docs/theory/published-method.md``.
"""

from arcless.lcp.arrays import SYMMETRY_TOLERANCE
from arcless.lcp.failures import LcpInputError, LcpUnsolvedError
from arcless.lcp.problem import DEFINITE_MIN, LcpInfo, solve
from arcless.lcp.published import PublishedStep, Step, friction

__all__ = [
    "DEFINITE_MIN",
    "SYMMETRY_TOLERANCE",
    "LcpInfo",
    "LcpInputError",
    "LcpUnsolvedError",
    "PublishedStep",
    "Step",
    "friction",
    "solve",
]
