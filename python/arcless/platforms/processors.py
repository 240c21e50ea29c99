"""Processors of this machine that a process may use."""

import os
import sys


def processors() -> int:
    """Return the number of processors that this process may use, at least 1."""
    if sys.platform == "linux":  # others cannot say which are allowed
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1
