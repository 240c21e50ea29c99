"""Compare the bits of all cases with those kept, or renew those.

``python -m tests.golden`` compares; ``--renew "reason"`` renews those kept; ``--file FILE`` uses
another file, ``--only TEXT`` the cases with a text in their name.
"""

import argparse
import json
import sys
import time
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from pathlib import Path

from tests.golden import bits
from tests.golden.cases import cases


def main() -> int:
    """Return 0 if no bit differs, 1 if one does."""
    parser = argparse.ArgumentParser(prog="python -m tests.golden")
    parser.add_argument("--renew", metavar="REASON")
    parser.add_argument("--file", type=Path, default=bits.KEPT)
    parser.add_argument("--only", default="")
    parser.add_argument("--workers", type=int, default=2)
    asked = parser.parse_args()
    names = [name for name, _ in cases() if asked.only in name]
    began = time.perf_counter()
    with ProcessPoolExecutor(asked.workers, mp_context=get_context("spawn")) as pool:
        found = dict(pool.map(bits.digests_of, names))
    took = f"{bits.total(found.values())} digests of {len(found)} cases"
    took += f" in {time.perf_counter() - began:.0f} s"
    if asked.renew:
        if asked.only:  # the other cases stay as they are kept
            found = json.loads(asked.file.read_text())["digests"] | found
        bits.write(found, asked.renew, asked.file)
        print(f"{took} kept in {asked.file}")
        return 0
    kept = json.loads(asked.file.read_text())
    if (reason := bits.elsewhere(kept)) is not None:
        print(f"not compared: {reason}")
        return 0
    pairs = {
        name: (kept["digests"].get(name, {}), found.get(name, {}))
        for name in sorted(kept["digests"].keys() | found.keys())
        if asked.only in name
    }
    others = {name: bits.described(*pair) for name, pair in pairs.items() if pair[0] != pair[1]}
    count = sum(len(bits.differences(*pair)) for pair in pairs.values())
    for name, different in others.items():
        print(f"{name}: {different}")
    print(f"{took}; {count} differ")
    return int(bool(others))


if __name__ == "__main__":
    sys.exit(main())
