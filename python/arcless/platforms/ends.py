"""Ends of a process in words: the signal of POSIX or the code of Windows that ended it."""

import signal

Words = tuple[str, str | None]
_REPORT = "please report it"
_SHORT_OF_MEMORY = "record less or shorten the line where memory is short"
# Signals by which a process ends that nobody of us sent, in words, and what to do about it.
_SIGNALS: dict[str, Words] = {
    "SIGKILL": ("it was killed, by a user or because the memory of the machine was used up",
                _SHORT_OF_MEMORY),
    "SIGTERM": ("it was terminated", None),
    "SIGSEGV": ("it crashed (segmentation fault)", _REPORT),
    "SIGABRT": ("it aborted itself", _REPORT),
    "SIGFPE": ("it crashed (division by zero)", _REPORT),
    "SIGILL": ("it crashed (instruction that this processor does not have)", _REPORT),
    "SIGBUS": ("it could not reach its memory or a file", "is a disk full?"),
}  # fmt: skip
# Codes of Windows (NTSTATUS values), which no process of POSIX can end with: those end at 255.
_CODES: dict[int, Words] = {
    0x4001_0004: ("it was ended with its terminal or by the system", None),
    0xC000_0005: ("it crashed (access violation)", _REPORT),
    0xC000_0006: ("it could not reach its memory or a file", "is a disk full, or gone?"),
    0xC000_0017: ("the memory of the machine was used up", _SHORT_OF_MEMORY),
    0xC000_001D: ("it crashed (instruction that this processor does not have)", _REPORT),
    0xC000_0094: ("it crashed (division by zero)", _REPORT),
    0xC000_00FD: ("it crashed (stack overflow)", _REPORT),
    0xC000_0135: ("a library that it needs is missing", "install Arcless again"),
    0xC000_013A: ("it was ended by Ctrl-C or with its terminal", None),
    0xC000_0142: ("it could not start (a library failed)", "is the session being closed?"),
    0xC000_0409: ("it aborted itself", _REPORT),
}  # fmt: skip
_LARGEST_OF_POSIX = 255


def why_ended(code: int) -> Words:
    """Return why a process ended, and a hint where there is one, by its exit code.

    Parameters
    ----------
    code
        As `subprocess.Popen.returncode` has it: below zero the number of a signal.
    """
    if code < 0:
        try:
            name = signal.Signals(-code).name
        except ValueError:
            name = ""
        return _SIGNALS.get(name, (f"signal {-code}", None))
    if code > _LARGEST_OF_POSIX:
        return _CODES.get(code, (f"it ended with code 0x{code:08X}", _REPORT))
    return f"it ended with code {code}", _REPORT
