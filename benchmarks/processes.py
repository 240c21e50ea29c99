"""Processor time and memory of other processes, a browser or a server: from /proc, so on Linux."""

import os
import re
from collections.abc import Iterable
from pathlib import Path

TICK_S = 1.0 / os.sysconf("SC_CLK_TCK")


def processor(processes: Iterable[int]) -> float:
    """Return the processor time in s of some processes; one that has ended counts for nothing."""
    found = 0.0
    for number in processes:
        try:
            text = Path(f"/proc/{number}/stat").read_text("utf-8", "replace")
        except OSError:
            continue
        # The name before may have brackets and blanks.
        fields = text.rpartition(")")[2].split()
        found += TICK_S * (int(fields[11]) + int(fields[12]))
    return found


def resident(process: int) -> float:
    """Return the memory of a process in bytes."""
    status = Path(f"/proc/{process}/status").read_text("ascii")
    found = re.search(r"VmRSS:\s+(\d+) kB", status)
    assert found is not None, "the process has ended"
    return 1024.0 * int(found[1])
