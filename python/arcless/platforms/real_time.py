"""Means of a system for a thread that must not be late: priority, memory, a processor.

Sources: sched(7), mlock(2), sched_setaffinity(2); Microsoft, "Scheduling Priorities".
"""

import ctypes
import os
import sys

from arcless.errors import MachineError

# Of the priorities 1 to 99 below those of the threads that serve interrupts on PREEMPT_RT, which
# have 50: above them a loop that never sleeps would stop the machine's disks and its network.
USUAL_PRIORITY = 49
LOWEST_PRIORITY, HIGHEST_PRIORITY = 1, 99
_LIMITS = "/etc/security/limits.conf"


def ask_priority(priority: int = USUAL_PRIORITY) -> str:
    """Give this thread a real-time priority; return in words what it has now.

    On Linux that is SCHED_FIFO, on Windows TIME_CRITICAL in a class of high priority.

    Parameters
    ----------
    priority
        Of SCHED_FIFO, 1 to 99; Windows has one.

    Raises
    ------
    MachineError
        The user may not ask for it, or the system has none.
    """
    if sys.platform == "win32":
        return _ask_windows()
    if sys.platform != "linux":
        raise _refusal("real-time priority", "none for programs of this kind", "Linux or Windows")
    try:
        os.sched_setscheduler(0, os.SCHED_FIFO, os.sched_param(priority))
    except OSError as error:
        raise _refusal(
            "real-time priority", error.strerror or str(error), "a user who may use it",
            f"as root: `chrt --fifo {priority} COMMAND`; or a line `USER - rtprio {priority}` in"
            f" {_LIMITS}, and sign in again",
        ) from error  # fmt: skip
    return f"SCHED_FIFO {priority}"


def lock_memory() -> str:
    """Keep all memory of this process, and what it takes later, in the machine's own memory.

    Otherwise a page that was not used for a while is on disk when a step wants it.

    Raises
    ------
    MachineError
        The user may not lock so much, or the system has no such call.
    """
    if sys.platform != "linux":
        raise _refusal("locked memory", "no call for a whole process", "Linux")
    now_and_later = 1 | 2  # MCL_CURRENT, MCL_FUTURE of <sys/mman.h>
    library = ctypes.CDLL(None, use_errno=True)
    if library.mlockall(now_and_later):
        raise _refusal(
            "locked memory", os.strerror(ctypes.get_errno()), "a user who may lock it all",
            f"as root; or a line `USER - memlock unlimited` in {_LIMITS}, and sign in again",
        )  # fmt: skip
    return "memory locked"


def stay_on(processor: int) -> str:
    """Keep this process on one processor, by its number from 0.

    Raises
    ------
    MachineError
        There is no such processor for this process, or the system does not say.
    """
    if sys.platform == "win32":
        kernel = ctypes.WinDLL("kernel32", use_last_error=True)
        kernel.GetCurrentProcess.restype = ctypes.c_void_p
        kernel.SetProcessAffinityMask.argtypes = (ctypes.c_void_p, ctypes.c_size_t)
        if not kernel.SetProcessAffinityMask(kernel.GetCurrentProcess(), 1 << processor):
            raise _refusal("processor", f"number {processor}", "the number of one, from 0")
    elif sys.platform == "linux":
        allowed = sorted(os.sched_getaffinity(0))
        try:
            os.sched_setaffinity(0, {processor})
        except (OSError, OverflowError, ValueError) as error:
            expected = "one of " + ", ".join(map(str, allowed))
            raise _refusal("processor", f"number {processor}", expected) from error
    else:
        raise _refusal("processor", "a system that does not bind processes", "Linux or Windows")
    return f"processor {processor}"


def _ask_windows() -> str:
    if sys.platform == "win32":
        kernel = ctypes.WinDLL("kernel32", use_last_error=True)
        kernel.GetCurrentProcess.restype = kernel.GetCurrentThread.restype = ctypes.c_void_p
        kernel.SetPriorityClass.argtypes = (ctypes.c_void_p, ctypes.c_ulong)
        kernel.SetThreadPriority.argtypes = (ctypes.c_void_p, ctypes.c_int)
        high, time_critical = 0x80, 15  # HIGH_PRIORITY_CLASS, THREAD_PRIORITY_TIME_CRITICAL
        done = kernel.SetPriorityClass(kernel.GetCurrentProcess(), high)
        if not (done and kernel.SetThreadPriority(kernel.GetCurrentThread(), time_critical)):
            got = ctypes.FormatError(ctypes.get_last_error())
            raise _refusal("real-time priority", got, "a user who may use it")
    return "TIME_CRITICAL of a high class"


def _refusal(what: str, got: str, expected: str, hint: str | None = None) -> MachineError:
    return MachineError(f"the system gives no {what}", got=got, expected=expected, hint=hint)
