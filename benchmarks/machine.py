"""The machine in words, without its name."""

import os
import platform
import re
import subprocess
import time
from pathlib import Path

import numpy as np

# Bytes of two vectors that fit well into the second cache of a core, and into the third only.
NEAR, FAR = 256 * 1024, 4 * 1024 * 1024


def machine() -> list[str]:
    """Return a line for each thing that timings depend on."""
    rust = subprocess.run(["rustc", "--version"], capture_output=True, text=True, check=False)
    python, versions = platform.python_version(), [f"NumPy {np.__version__}"]
    load = os.getloadavg()[0]
    return [
        f"{_processor()}, {os.cpu_count()} cores; caches of a core: {_caches()}",
        f"one core reads {_reads(NEAR):.0f} GB/s from the second cache, {_reads(FAR):.0f} GB/s from"
        " the third",
        f"{platform.system()}, Python {python}, {', '.join(versions)},"
        f" {' '.join(rust.stdout.split()[:2]) or 'no rustc'}",
        f"{load:.1f} programs wanted to run on average when this was measured",
    ]


def _processor() -> str:
    info = Path("/proc/cpuinfo")
    found = re.search(r"model name\s*:\s*(.+)", info.read_text()) if info.exists() else None
    return found[1].strip() if found else platform.processor() or platform.machine()


def _caches() -> str:
    found = []
    for folder in sorted(Path("/sys/devices/system/cpu/cpu0/cache").glob("index*")):
        kind, size, level = (
            (folder / name).read_text().strip() for name in ("type", "size", "level")
        )
        if kind != "Instruction":
            found.append(f"L{level} {size}")
    return ", ".join(found) or "unknown"


def _reads(size: int) -> float:
    """Highest rate in GB/s at which a scalar product reads two vectors of `size` bytes in all."""
    x = np.ones(size // 16)
    y, repeats = x.copy(), 2**27 // size
    best = np.inf
    for _ in range(9):
        began = time.perf_counter()
        for _ in range(repeats):
            np.dot(x, y)
        best = min(best, (time.perf_counter() - began) / repeats)
    return float(size / best / 1e9)
