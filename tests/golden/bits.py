"""Digests of cases, and their dependences besides the code."""

import hashlib
import json
import platform
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import numpy as np
import scipy

from tests.golden.cases import Case, cases

KEPT = Path(__file__).with_name("bits.json")
# Digest of the input that is kept with a result.
SCENARIO = "@scenario"
# Features of processors for which the core or NumPy have code of their own.
FEATURES = ("SSE41", "AVX2", "FMA3", "AVX512F", "AVX512_SKX", "AVX512_ICL", "NEON", "ASIMD")


def machine() -> dict[str, Any]:
    """Return the causes of other bits than the code: libraries and kinds of processor."""
    from numpy._core._multiarray_umath import __cpu_features__ as has

    return {
        "processor": platform.machine(),
        "features": [name for name in FEATURES if has.get(name)],
        "numpy": np.__version__,
        "scipy": scipy.__version__,
    }


def digest(value: Any) -> str:
    """Digest of an array, or of anything as text."""
    array = np.ascontiguousarray(value)
    if array.dtype.kind in "OU":
        data = "\n".join(str(v) for v in array.ravel()).encode()
    else:
        data = array.dtype.str.encode() + array.tobytes()
    return hashlib.sha256(data).hexdigest()[:16]


def digests(case: Case) -> dict[str, str]:
    """Digests of what a case returns; of its error where it is refused."""
    try:
        found = case()
    except Exception as error:  # a refusal is part of the behaviour
        return {"error": f"{type(error).__name__}: {error}".split("\n")[0]}
    return {name: digest(value) for name, value in found.items()}


def digests_of(name: str) -> tuple[str, dict[str, str]]:
    """Name and digests of a case, for processes that know its name."""
    return name, digests(dict(cases())[name])


def read() -> dict[str, Any]:
    """Return the kept digests: `machine`, `reason`, `digests` by case and name."""
    return json.loads(KEPT.read_text())


def write(found: dict[str, dict[str, str]], reason: str, to: Path = KEPT) -> None:
    """Keep digests with the reason why they are new."""
    kept = {"machine": machine(), "reason": reason, "digests": found}
    to.write_text(json.dumps(kept, indent=1, sort_keys=True) + "\n")


def differences(before: dict[str, str], now: dict[str, str]) -> list[str]:
    """Names whose digests are not the same, or that are in one of both only."""
    return sorted(name for name in before.keys() | now.keys() if before.get(name) != now.get(name))


def described(before: dict[str, str], now: dict[str, str]) -> str:
    """Say what differs: numbers, inputs alone, or entries that only one of both has."""
    changed = [name for name in differences(before, now) if name in before and name in now]
    said = {
        "changed": changed,
        "new": sorted(now.keys() - before.keys()),
        "gone": sorted(before.keys() - now.keys()),
    }
    text = "; ".join(
        f"{len(names)} {kind}: {', '.join(names[:8])}{' …' if len(names) > 8 else ''}"
        for kind, names in said.items()
        if names
    )
    if changed and all(name.split()[-1] == SCENARIO for name in changed):
        text += " (the scenario kept with the result, no number)"
    return text


def elsewhere(kept: dict[str, Any]) -> str | None:
    """Why the digests cannot be compared on this machine, in a sentence; None if they can."""
    here = machine()
    other = [name for name in here if here[name] != kept["machine"].get(name)]
    if not other:
        return None
    was = ", ".join(f"{name} {kept['machine'].get(name)}" for name in other)
    return f"the bits are kept for {was}; here: {', '.join(str(here[n]) for n in other)}"


def total(found: Iterable[dict[str, str]]) -> int:
    """Number of digests."""
    return sum(len(each) for each in found)
