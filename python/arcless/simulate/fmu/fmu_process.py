"""Main program of the process in which an FMU runs, alone: loads it, steps it, answers.

Its command line is `python -P fmu_process.py NUMBER`, with the number of the process of Arcless, in
the folder that the FMU is unpacked into, which it removes when Arcless is gone. It imports nothing
of Arcless: so it starts in a quarter of a second. Requests come on standard input, answers go to
standard output, both as frames:

    kind (1 byte), length of what follows (4 bytes, little-endian), content

    request            content                                  answer
    L  load            JSON: see `Fmu`                           heights at the start
    P  predict         time, step, inputs, forces of each trial  heights after each trial
    A  advance         time, step, inputs, forces                heights after the step

The first frame is an answer that nobody asked for: ready. Numbers are doubles in the units of the
FMU. An answer has the kind `=`; one of the kind `!` is what
failed, as JSON. What the FMU prints goes to standard error.
"""

import ctypes
import json
import os
import shutil
import signal
import struct
import sys
import threading
import time
from typing import Any, BinaryIO

HEAD = struct.Struct("<cI")
DONE, FAILED = b"=", b"!"
LOAD, PREDICT, ADVANCE = b"L", b"P", b"A"
_FMI_2 = 2
# Interval in s between two looks whether Arcless is still there: a process that hangs in a library
# hears nothing of a closed pipe.
_LOOK_EVERY_S = 1.0


def frame(kind: bytes, content: bytes) -> bytes:
    """Return a frame."""
    return HEAD.pack(kind, len(content)) + content


def write_frame(to: BinaryIO, kind: bytes, content: bytes) -> None:
    """Write a frame at once."""
    to.write(frame(kind, content))
    to.flush()


def read_frame(source: BinaryIO) -> tuple[bytes, bytes] | None:
    """Return kind and content of the next frame; None where the other side is gone."""
    head = source.read(HEAD.size)
    if len(head) < HEAD.size:
        return None
    kind, length = HEAD.unpack(head)
    content = source.read(length)
    return (kind, content) if len(content) == length else None


def doubles(content: bytes) -> tuple[float, ...]:
    """Return the doubles in the content of a frame."""
    return struct.unpack(f"<{len(content) // 8}d", content)


def packed(values: "list[float] | tuple[float, ...]") -> bytes:
    """Return doubles as the content of a frame."""
    return struct.pack(f"<{len(values)}d", *values)


class Fmu:
    """An FMU for co-simulation, loaded and initialised.

    Parameters
    ----------
    given
        version, model, token, folder (where the archive is unpacked), name (of the instance),
        start (references and values set before initialisation), inputs, forces, heights
        (references), first (values of inputs and forces at the start), keeps_state.
    """

    def __init__(self, given: dict[str, Any]) -> None:
        self._is_2 = given["version"] == _FMI_2
        self._fmu = self._loaded(given)
        self._heights = self._references(given["heights"])
        self._settable = self._references([*given["inputs"], *given["forces"]])
        self._inputs, self._forces = len(given["inputs"]), len(given["forces"])
        self._values = (ctypes.c_double * len(self._settable))()
        self._found = (ctypes.c_double * len(self._heights))()
        self._state = ctypes.c_void_p()
        start, values = given["start"]
        self._initialise(self._references(start), (ctypes.c_double * len(values))(*values))
        self.set(given["first"])
        self._call("ExitInitializationMode")

    def _loaded(self, given: dict[str, Any]) -> Any:
        """Load the library and instantiate it."""
        names = {
            "guid": given["token"],
            "modelIdentifier": given["model"],
            "unzipDirectory": given["folder"],
            "instanceName": given["name"],
        }
        import fmpy.fmi2
        import fmpy.fmi3

        kind = fmpy.fmi2.FMU2Slave if self._is_2 else fmpy.fmi3.FMU3Slave
        fmu = kind(**names)
        fmu.instantiate()
        return fmu

    def _initialise(self, start: Any, values: Any) -> None:
        """Set start values and enter the mode in which inputs are set for the first time."""
        if len(start):
            self._set(start, values)
        if self._is_2:
            self._fmu.setupExperiment(startTime=0.0)
        self._fmu.enterInitializationMode()

    def _references(self, numbers: list[int]) -> Any:
        return (ctypes.c_uint * len(numbers))(*numbers)

    def _call(self, name: str, *arguments: Any) -> Any:
        """Call a function of the interface; a status worse than a warning is an exception."""
        prefix = "fmi2" if self._is_2 else "fmi3"
        return getattr(self._fmu, prefix + name)(self._fmu.component, *arguments)

    def _set(self, references: Any, values: Any) -> None:
        if self._is_2:
            self._fmu.fmi2SetReal(self._fmu.component, references, len(references), values)
        else:
            count = len(references)
            self._fmu.fmi3SetFloat64(self._fmu.component, references, count, values, count)

    def set(self, values: "list[float] | tuple[float, ...]") -> None:
        """Set inputs and forces."""
        if values:
            self._values[:] = list(values)
            self._set(self._settable, self._values)

    def heights(self) -> list[float]:
        """Return the heights of the strips."""
        count = len(self._heights)
        if self._is_2:
            self._fmu.fmi2GetReal(self._fmu.component, self._heights, count, self._found)
        else:
            self._fmu.fmi3GetFloat64(self._fmu.component, self._heights, count, self._found, count)
        return list(self._found)

    def step(self, at: float, step: float, *, for_good: bool) -> None:
        """Take a step from a time in s; where it is not for good, the state is restored later."""
        if self._is_2:
            self._fmu.doStep(at, step, int(for_good))
            return
        _, ends, early, reached = self._fmu.doStep(at, step, for_good)
        if ends or early:
            raise RuntimeError(f"fmi3DoStep ended the simulation at {reached:.9g} s")

    def predict(self, numbers: tuple[float, ...]) -> list[float]:
        """Return the heights after each trial of a step; the state is as before."""
        at, step, *rest = numbers
        inputs, trials = rest[: self._inputs], rest[self._inputs :]
        self._save()
        found: list[float] = []
        for first in range(0, len(trials), self._forces):
            self.set([*inputs, *trials[first : first + self._forces]])
            self.step(at, step, for_good=False)
            found += self.heights()
            self._restore()
        return found

    def advance(self, numbers: tuple[float, ...]) -> list[float]:
        """Take a step for good; return the heights at its end."""
        at, step, *values = numbers
        self.set(values)
        self.step(at, step, for_good=True)
        return self.heights()

    def _save(self) -> None:
        """Save the state, in memory that is allocated once."""
        name = "GetFMUstate" if self._is_2 else "GetFMUState"
        self._call(name, ctypes.byref(self._state))

    def _restore(self) -> None:
        self._call("SetFMUstate" if self._is_2 else "SetFMUState", self._state)


def main() -> None:
    """Answer until Arcless closes the pipe or is gone."""
    # Ctrl-C in the terminal is for Arcless, which ends this process.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    source = sys.stdin.buffer
    answers = os.fdopen(os.dup(sys.stdout.fileno()), "wb")
    # Text that a library prints must not get between the frames.
    os.dup2(sys.stderr.fileno(), sys.stdout.fileno())
    folder = os.getcwd()  # noqa: PTH109 - as a text, to be removed at the end
    # On Windows the launcher of a virtual environment stands between.
    arcless = int(sys.argv[1]) if sys.platform == "win32" else os.getppid()
    threading.Thread(target=_end_with, args=(arcless, folder), daemon=True).start()
    import fmpy.fmi2
    import fmpy.fmi3  # noqa: F401 - before the FMU's time counts

    write_frame(answers, DONE, b"")
    fmu: Fmu | None = None
    while (asked := read_frame(source)) is not None:
        kind, content = asked
        try:
            if kind == LOAD:
                fmu = Fmu(json.loads(content))
                answer = fmu.heights()
            else:
                assert fmu is not None
                act = fmu.predict if kind == PREDICT else fmu.advance
                answer = act(doubles(content))
        except Exception as error:
            said = {"error": type(error).__name__, "text": str(error)}
            write_frame(answers, FAILED, json.dumps(said).encode())
        else:
            write_frame(answers, DONE, packed(answer))
    _leave(folder)


def _end_with(arcless: int, folder: str) -> None:
    """End this process when that of Arcless is gone, even inside of the library."""
    _wait_for_end(arcless)
    _leave(folder)


if sys.platform == "win32":

    def _wait_for_end(arcless: int) -> None:
        """Wait until the process of Arcless is gone, which its number does not tell there."""
        synchronize, for_ever = 0x0010_0000, 0xFFFF_FFFF
        kernel = ctypes.WinDLL("kernel32")
        kernel.OpenProcess.restype = ctypes.c_void_p
        handle = kernel.OpenProcess(synchronize, False, arcless)
        if handle:
            kernel.WaitForSingleObject(ctypes.c_void_p(handle), for_ever)
else:

    def _wait_for_end(arcless: int) -> None:
        """Wait until the process of Arcless is gone: this one gets another parent then."""
        while os.getppid() == arcless:
            time.sleep(_LOOK_EVERY_S)


def _leave(folder: str) -> None:
    """Remove the folder and end at once: no library has a say in that any more.

    Windows keeps a library that is loaded, and the folder that a process works in.
    """
    os.chdir(os.path.dirname(folder))  # noqa: PTH120 - as above
    shutil.rmtree(folder, ignore_errors=True)
    os._exit(0)


if __name__ == "__main__":
    main()
