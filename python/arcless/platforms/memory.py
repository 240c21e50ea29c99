"""Memory that this process has used at most."""

import sys
from contextlib import suppress
from pathlib import Path

_STATUS = Path("/proc/self/status")


def most_memory(status: Path = _STATUS) -> int | None:
    """Return the most memory in bytes that this process has used; None where nothing tells it.

    Without Linux's `status` that of `getrusage` counts, which on Linux is no less than the memory
    that the parent used when it started this process.
    """
    with suppress(OSError):
        found = status.read_text("ascii").partition("VmHWM:")[2].split(maxsplit=1)
        if found:
            return 1024 * int(found[0])
    return _most_by_call()


if sys.platform == "win32":

    def _most_by_call() -> int | None:
        """Return the peak working set, by `GetProcessMemoryInfo`."""
        import ctypes
        from ctypes import wintypes

        class Counters(ctypes.Structure):
            _fields_ = (  # PROCESS_MEMORY_COUNTERS
                ("cb", wintypes.DWORD),
                ("PageFaultCount", wintypes.DWORD),
                ("PeakWorkingSetSize", ctypes.c_size_t),
                ("WorkingSetSize", ctypes.c_size_t),
                ("QuotaPeakPagedPoolUsage", ctypes.c_size_t),
                ("QuotaPagedPoolUsage", ctypes.c_size_t),
                ("QuotaPeakNonPagedPoolUsage", ctypes.c_size_t),
                ("QuotaNonPagedPoolUsage", ctypes.c_size_t),
                ("PagefileUsage", ctypes.c_size_t),
                ("PeakPagefileUsage", ctypes.c_size_t),
            )

        kernel, counters = ctypes.windll.kernel32, Counters()
        counters.cb = ctypes.sizeof(counters)
        kernel.GetCurrentProcess.restype = wintypes.HANDLE
        ask = kernel.K32GetProcessMemoryInfo
        ask.argtypes = (wintypes.HANDLE, ctypes.POINTER(Counters), wintypes.DWORD)
        if not ask(kernel.GetCurrentProcess(), ctypes.byref(counters), counters.cb):
            return None
        return int(counters.PeakWorkingSetSize)
else:

    def _most_by_call() -> int | None:
        """Return the peak resident set, by `getrusage`."""
        try:
            import resource
        except ImportError:
            return None
        unit = 1 if sys.platform == "darwin" else 1024  # bytes of ru_maxrss: getrusage(2) of each
        return unit * resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
